#include "make_scenes/vegetation.hpp"

#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "make_scenes/textures.hpp"
#include "make_scenes/turn.hpp"

namespace vkbake::scenes {
namespace {

constexpr int sides = 6; // of stems and branches

// Light-map UVs: wood in the left fifth, a strip a branch; leaves in a grid to its right.
constexpr float wood_share = 0.2F;

glm::dvec3 aslant(const glm::dvec3& v) {
    return unit(glm::cross(v, std::abs(v.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
}

class Draw {
public:
    explicit Draw(std::uint32_t seed) : m_next(seed * 100'003U + 17U) {}
    double operator()(double low, double high) { return low + (high - low) * random_of(m_next++); }

private:
    std::uint32_t m_next;
};

void add_triangle(Patch& patch, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    patch.indices.insert(patch.indices.end(), {a, b, c});
}

struct Strip {
    std::size_t index = 0;
    std::size_t count = 1;
};

/// A tapering round bar along `path`, open at both ends.
void add_bar(Patch& wood, const std::vector<glm::dvec3>& path, double radius, const Strip& strip) {
    const auto first = static_cast<std::uint32_t>(wood.positions.size());
    constexpr std::uint32_t stride = sides + 1; // the seam has its own UVs
    for (std::size_t ring = 0; ring < path.size(); ++ring) {
        const double share = static_cast<double>(ring) / static_cast<double>(path.size() - 1);
        const glm::dvec3 along =
            ring + 1 < path.size() ? unit(path[ring + 1] - path[ring]) : unit(path[ring] - path[ring - 1]);
        const glm::dvec3 u = aslant(along);
        const glm::dvec3 v = glm::cross(along, u);
        for (std::uint32_t k = 0; k < stride; ++k) {
            const double around = static_cast<double>(k % sides) / sides;
            const glm::dvec2 c = on_circle(around);
            const glm::dvec3 normal = c.x * u + c.y * v;
            wood.positions.emplace_back(path[ring] + radius * (1.0 - 0.8 * share) * normal);
            wood.normals.emplace_back(normal);
            const double row =
                (static_cast<double>(strip.index) + 0.05 + 0.9 * k / sides) / static_cast<double>(strip.count);
            wood.tex_coords_1.emplace_back(wood_share * static_cast<float>(0.02 + 0.93 * share),
                                           static_cast<float>(row));
        }
    }
    for (std::uint32_t ring = 0; ring + 1 < path.size(); ++ring) {
        for (std::uint32_t k = 0; k < sides; ++k) {
            const std::uint32_t a = first + ring * stride + k;
            add_triangle(wood, a, a + 1, a + stride + 1);
            add_triangle(wood, a, a + stride + 1, a + stride);
        }
    }
}

/// Two triangles, folded along the leaf or of a card, in cell `index` of a square grid of at least `count` cells.
void add_leaf(Patch& leaves, const glm::dvec3& foot, const glm::dvec3& along, const glm::dvec3& across,
              std::size_t index, std::size_t count) {
    const auto first = static_cast<std::uint32_t>(leaves.positions.size());
    const glm::dvec3 normal = unit(glm::cross(across, along));
    const double fold = 0.2 * glm::length(across);
    const std::array folded{foot, foot + 0.5 * along + across + fold * normal, foot + along,
                            foot + 0.5 * along - across + fold * normal};
    const std::array card{foot - 1.5 * across, foot + 1.5 * across, foot + along + 1.5 * across,
                          foot + along - 1.5 * across};
    const bool cut_out = paint_info(leaves.paint).texture == Texture::sprig;
    for (const glm::dvec3& point : cut_out ? card : folded) {
        leaves.positions.emplace_back(point);
        leaves.normals.emplace_back(normal);
    }
    if (cut_out) {
        leaves.tex_coords_0.insert(leaves.tex_coords_0.end(), {{0, 1}, {1, 1}, {1, 0}, {0, 0}});
    }
    const auto grid = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
    const auto cell = 1.0F / static_cast<float>(grid);
    const std::size_t row = index / grid;
    const glm::vec2 corner{static_cast<float>(index % grid) * cell, static_cast<float>(row) * cell};
    for (const glm::vec2& s :
         {glm::vec2{0.1F, 0.1F}, glm::vec2{0.9F, 0.1F}, glm::vec2{0.9F, 0.9F}, glm::vec2{0.1F, 0.9F}}) {
        const glm::vec2 place = corner + cell * s;
        leaves.tex_coords_1.emplace_back(wood_share + (1.0F - wood_share) * place.x, place.y);
    }
    add_triangle(leaves, first, first + 1, first + 2);
    add_triangle(leaves, first, first + 2, first + 3);
}

std::vector<glm::dvec3> branch_path(const glm::dvec3& from, const glm::dvec3& out, double reach, Draw& draw) {
    const double lift = draw(0.3, 0.7);
    return {from, from + reach * (0.4 * out + glm::dvec3(0, 0.30 * lift, 0)),
            from + reach * (0.75 * out + glm::dvec3(0, 0.45 * lift, 0)),
            from + reach * (out + glm::dvec3(0, 0.40 * lift, 0))};
}

} // namespace

std::vector<Patch> make_plant(const PlantShape& shape, std::uint32_t number) {
    Draw draw(number);
    Patch wood{.paint = Paint::walnut};
    Patch leaves{.paint = shape.foliage};
    const Strip all{0, static_cast<std::size_t>(shape.branches) + 1};
    std::vector<glm::dvec3> stem{glm::dvec3(0.0)};
    for (int ring = 1; ring <= shape.stem_rings; ++ring) {
        const double bend = 0.04 * shape.height;
        stem.emplace_back(stem.back().x + draw(-bend, bend), shape.height * ring / shape.stem_rings,
                          stem.back().z + draw(-bend, bend));
    }
    add_bar(wood, stem, shape.radius, all);

    std::vector<std::vector<glm::dvec3>> branches;
    for (int k = 0; k < shape.branches; ++k) {
        const double up = 0.35 + 0.6 * k / shape.branches;
        const auto ring = static_cast<std::size_t>(up * shape.stem_rings);
        const glm::dvec2 c = on_circle(0.382 * k + draw(-0.05, 0.05));
        branches.push_back(
            branch_path(stem[ring], {c.x, 0.0, c.y}, shape.reach * draw(0.7, 1.1) * (1.25 - 0.6 * up), draw));
        add_bar(wood, branches.back(), 0.4 * shape.radius, {static_cast<std::size_t>(k) + 1, all.count});
    }
    for (int k = 0; k < shape.leaves; ++k) {
        const std::vector<glm::dvec3>& branch = branches[static_cast<std::size_t>(k) % branches.size()];
        const double place = draw(0.6, 2.99);
        const auto segment = static_cast<std::size_t>(place);
        const glm::dvec3 on = glm::mix(branch[segment], branch[segment + 1], place - static_cast<double>(segment));
        const double spread = 0.25 * shape.reach;
        const glm::dvec3 foot = on + glm::dvec3(draw(-spread, spread), draw(-spread, spread), draw(-spread, spread));
        const glm::dvec2 c = on_circle(draw(0.0, 1.0));
        const glm::dvec3 along = shape.leaf_length * draw(0.7, 1.2) * unit(glm::dvec3(c.x, draw(-0.6, 0.4), c.y));
        add_leaf(leaves, foot, along, 0.28 * glm::length(along) * aslant(along), static_cast<std::size_t>(k),
                 static_cast<std::size_t>(shape.leaves));
    }
    return {wood, leaves};
}

double terrain_height(const glm::dvec2& place) {
    return 1.2 * on_circle(place.x / 41.0 + 0.1).y + 0.9 * on_circle(place.y / 33.0).x +
           0.25 * on_circle(place.x / 9.0 + place.y / 7.0).y;
}

Patch make_terrain(const glm::ivec2& cells, const glm::dvec2& size) {
    Patch ground{.paint = Paint::earth};
    const glm::dvec2 step{size.x / cells.x, size.y / cells.y};
    for (int row = 0; row <= cells.y; ++row) {
        for (int column = 0; column <= cells.x; ++column) {
            const glm::dvec2 place{step.x * column, step.y * row};
            const auto height = [&](double x, double z) { return terrain_height(place + glm::dvec2(x, z)); };
            ground.positions.emplace_back(place.x, height(0, 0), place.y);
            ground.normals.emplace_back(
                unit({height(-0.1, 0) - height(0.1, 0), 0.2, height(0, -0.1) - height(0, 0.1)}));
            ground.tex_coords_1.emplace_back(static_cast<float>(column) / static_cast<float>(cells.x),
                                             static_cast<float>(row) / static_cast<float>(cells.y));
            if (row < cells.y && column < cells.x) {
                const auto stride = static_cast<std::uint32_t>(cells.x) + 1;
                const std::uint32_t a = static_cast<std::uint32_t>(row) * stride + static_cast<std::uint32_t>(column);
                add_triangle(ground, a, a + stride, a + stride + 1);
                add_triangle(ground, a, a + stride + 1, a + 1);
            }
        }
    }
    return ground;
}

} // namespace vkbake::scenes
