#include "geometry_image/reference.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "geometry_image/texel_triangles.hpp"

namespace vkbake {

namespace {

struct Whole {
    std::int64_t x = 0;
    std::int64_t y = 0;
};

std::int64_t cross(const Whole& a, const Whole& b) { return a.x * b.y - a.y * b.x; }

std::int64_t dot(const Whole& a, const Whole& b) { return a.x * b.x + a.y * b.y; }

/// The sample point as weights of the corners, and its squared distance to the centre as the depth test sees it.
struct Sample {
    double b1 = 0.0;
    double b2 = 0.0;
    double distance = 0.0;
};

/// To 24 bits, halves as Veltkamp's splitting has them; nothing below floats' range.
float rounded(double value) {
    const double scaled = value * 536870913.0; // 2^29 + 1
    const double head = scaled - (scaled - value);
    return std::abs(head) < static_cast<double>(std::numeric_limits<float>::min()) ? 0.0F : static_cast<float>(head);
}

class TexelTest {
public:
    TexelTest(const shared::TexelTriangle& triangle, int units, int i, int j)
        : m_triangle(triangle), m_half(units / 2) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            m_corners[corner] = {triangle.x[corner] - std::int64_t{i} * units - m_half,
                                 triangle.y[corner] - std::int64_t{j} * units - m_half};
        }
    }

    [[nodiscard]] std::optional<Sample> centre() const {
        const std::array weights{cross(m_corners[1], m_corners[2]), cross(m_corners[2], m_corners[0]),
                                 cross(m_corners[0], m_corners[1])};
        const auto [low, high] = std::ranges::minmax(weights);
        const bool has_area = weights[0] + weights[1] + weights[2] != 0;
        if (!has_area || (low < 0 && high > 0)) {
            return std::nullopt;
        }
        const double inverse_area = m_triangle.inverse_area;
        return Sample{static_cast<double>(weights[1]) * inverse_area, static_cast<double>(weights[2]) * inverse_area,
                      0.0};
    }

    [[nodiscard]] std::optional<Sample> nearest() const {
        std::optional<Sample> best;
        for (std::size_t edge = 0; edge < 3; ++edge) {
            const std::optional<Sample> candidate = nearest_on(edge);
            if (candidate && (!best || candidate->distance < best->distance)) {
                best = candidate;
            }
        }
        return best;
    }

private:
    [[nodiscard]] std::optional<Sample> nearest_on(std::size_t edge) const {
        std::array<std::size_t, 2> ends{edge, (edge + 1) % 3};
        if (((m_triangle.turned >> edge) & 1U) != 0) {
            std::swap(ends[0], ends[1]);
        }
        const Whole a = m_corners[ends[0]];
        const Whole b = m_corners[ends[1]];
        const Whole d{b.x - a.x, b.y - a.y};
        if (!meets_square(a, b)) {
            return std::nullopt;
        }
        const auto half = static_cast<double>(m_half);
        double low = 0.0;
        double high = 1.0;
        const auto clip = [&](std::int64_t start, std::int64_t step, double inverse) {
            if (step == 0) {
                return;
            }
            const double near_side = step > 0 ? -half : half;
            low = std::max(low, (near_side - static_cast<double>(start)) * inverse);
            high = std::min(high, (-near_side - static_cast<double>(start)) * inverse);
        };
        clip(a.x, d.x, m_triangle.inverse_x[edge]);
        clip(a.y, d.y, m_triangle.inverse_y[edge]);
        const double projection = static_cast<double>(-dot(a, d)) * m_triangle.inverse_square[edge];
        const double t = std::max(low, std::min(high, projection));
        const double x = std::clamp(static_cast<double>(a.x) + t * static_cast<double>(d.x), -half, half);
        const double y = std::clamp(static_cast<double>(a.y) + t * static_cast<double>(d.y), -half, half);
        std::array<double, 3> weights{};
        weights[ends[0]] = 1.0 - t;
        weights[ends[1]] = t;
        return Sample{weights[1], weights[2], x * x + y * y};
    }

    /// The segment and the square are apart if both lie on different sides of a side of the square, or the square on
    /// one side of the segment's line.
    [[nodiscard]] bool meets_square(const Whole& a, const Whole& b) const {
        const std::int64_t h = m_half;
        if (std::max(a.x, b.x) < -h || std::min(a.x, b.x) > h || std::max(a.y, b.y) < -h || std::min(a.y, b.y) > h) {
            return false;
        }
        const Whole d{b.x - a.x, b.y - a.y};
        const std::array squares{Whole{-h, -h}, Whole{h, -h}, Whole{h, h}, Whole{-h, h}};
        const auto side = [&](const Whole& corner) { return cross(d, {corner.x - a.x, corner.y - a.y}); };
        return !std::ranges::all_of(
                   squares, [](std::int64_t s) { return s > 0; }, side) &&
               !std::ranges::all_of(
                   squares, [](std::int64_t s) { return s < 0; }, side);
    }

    const shared::TexelTriangle& m_triangle;
    std::int64_t m_half;
    std::array<Whole, 3> m_corners;
};

glm::vec3 combined(const float* v, const Sample& sample) {
    const auto component = [&](std::size_t axis) {
        const auto v0 = static_cast<double>(v[axis]);
        const double first = sample.b1 * (static_cast<double>(v[3 + axis]) - v0);
        const double second = sample.b2 * (static_cast<double>(v[6 + axis]) - v0);
        return rounded(v0 + first + second);
    };
    return {component(0), component(1), component(2)};
}

/// An image of any texels of a page, in which triangles compete.
class Competition {
public:
    Competition(const Surface& surface, const TexelGrid& grid, int width, int height)
        : m_surface(&surface), m_units(grid.units), m_scale(1.0 / (static_cast<double>(grid.units) * grid.units)) {
        const std::size_t texels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
        m_image.width = width;
        m_image.height = height;
        m_image.triangle.assign(texels, GeometryImage::empty);
        m_image.position = ZeroedArray<glm::vec3>(texels);
        m_image.shading_normal = ZeroedArray<glm::vec3>(texels);
        m_image.geometric_normal = ZeroedArray<glm::vec3>(texels);
        m_nearest.assign(texels, 1.0F);
    }

    /// Texel (i, j) of the page stands at `place`, as its image has it.
    void enter(std::uint32_t number, const shared::TexelTriangle& triangle, int i, int j, const glm::ivec2& place) {
        const TexelTest test(triangle, m_units, i, j);
        const std::optional<Sample> centre = test.centre();
        const std::optional<Sample> sample = centre ? centre : test.nearest();
        const float depth = centre ? 0.0F : std::max(sample ? rounded(sample->distance * m_scale) : 1.0F, 0x1p-100F);
        const std::size_t texel = static_cast<std::size_t>(place.y) * static_cast<std::size_t>(m_image.width) +
                                  static_cast<std::size_t>(place.x);
        if (!sample || !(depth < m_nearest[texel])) {
            return;
        }
        m_nearest[texel] = depth;
        const glm::vec3& geometric = m_surface->geometric_normals[number];
        m_image.triangle[texel] = number;
        m_image.position[texel] = combined(triangle.position, *sample);
        m_image.shading_normal[texel] = unit_shading_normal(combined(triangle.normal, *sample), geometric);
        m_image.geometric_normal[texel] = geometric;
    }

    GeometryImage finish() { return std::move(m_image); }

private:
    const Surface* m_surface;
    int m_units;
    double m_scale;
    GeometryImage m_image;
    std::vector<float> m_nearest;
};

} // namespace

GeometryImage reference_geometry_image(const Surface& surface, const Atlas& atlas, std::uint32_t page) {
    const TexelGrid grid(atlas.pages.at(page));
    Competition competition(surface, grid, grid.width, grid.height);
    for (const std::uint32_t number : drawn_triangles(surface, atlas, page)) {
        const shared::TexelTriangle triangle = make_texel_triangle(surface, atlas, grid, number);
        const TexelBox box = texel_box(atlas, grid, number);
        for (int j = box.y_begin; j < box.y_end; ++j) {
            for (int i = box.x_begin; i < box.x_end; ++i) {
                competition.enter(number, triangle, i, j, {i, j});
            }
        }
    }
    return competition.finish();
}

GeometryImage sampled_geometry_image(const Surface& surface, const Atlas& atlas, std::uint32_t page, int side,
                                     const std::function<bool(int x, int y)>& takes) {
    const TexelGrid grid(atlas.pages.at(page));
    const int columns = (grid.width + side - 1) / side;
    const int rows = (grid.height + side - 1) / side;
    constexpr int none = -1;
    std::vector<int> number_of; // of each square of the page
    int count = 0;
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            number_of.push_back(takes(x, y) ? count++ : none);
        }
    }
    Competition competition(surface, grid, count * side, side);
    if (count == 0) {
        return competition.finish();
    }
    for (const std::uint32_t number : drawn_triangles(surface, atlas, page)) {
        const shared::TexelTriangle triangle = make_texel_triangle(surface, atlas, grid, number);
        const TexelBox box = texel_box(atlas, grid, number);
        for (int j = box.y_begin; j < box.y_end; ++j) {
            for (int i = box.x_begin; i < box.x_end; ++i) {
                const int square = number_of[static_cast<std::size_t>(j / side) * static_cast<std::size_t>(columns) +
                                             static_cast<std::size_t>(i / side)];
                if (square == none) {
                    i += side - 1 - i % side; // on to the next square
                } else {
                    competition.enter(number, triangle, i, j, {square * side + i % side, j % side});
                }
            }
        }
    }
    return competition.finish();
}

} // namespace vkbake
