#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>
#include <unordered_map>

#include <glm/geometric.hpp>

#include "atlas/patches.hpp"
#include "atlas/plane_grid.hpp"

namespace vkbake {

namespace {

constexpr double coplanar_cosine = 0.99999; // about ¼°

/// The point beyond the laid side a → b: where the triangle's third corner comes.
glm::dvec2 third_place(const LaidTriangle& triangle, const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 along = (b - a) / glm::length(b - a);
    return a + along * triangle.x2 + glm::dvec2(-along.y, along.x) * triangle.y2;
}

class PatchGrower {
public:
    /// `side_length`: what the triangles' sides have on average.
    PatchGrower(Patches& patches, const PatchLimits& limits, double side_length)
        : m_all(patches), m_mesh(*patches.mesh), m_limits(limits), m_side_length(side_length), m_grid(side_length) {}

    Patch grow(std::uint32_t seed, std::uint32_t name) {
        m_name = name;
        m_patch = {};
        m_facing = glm::dvec3(0.0);
        m_places.clear();
        m_open = {};
        const LaidTriangle laid = lay_down(m_mesh, 3 * seed);
        m_grid = PlaneGrid(m_side_length);
        m_grid.add({glm::dvec2(0.0), glm::dvec2(laid.x1, 0.0), glm::dvec2(laid.x2, laid.y2)});
        m_places[m_mesh.vertices[3 * seed]] = {0.0, 0.0};
        m_places[m_mesh.vertices[3 * seed + 1]] = {laid.x1, 0.0};
        m_places[m_mesh.vertices[3 * seed + 2]] = {laid.x2, laid.y2};
        m_begin = {(laid.x1 + laid.x2) / 3.0, laid.y2 / 3.0};
        take(3 * seed, laid);
        while (!m_open.empty()) {
            const std::uint32_t side = m_open.top().side;
            m_open.pop();
            if (m_all.patch_of[side / 3] == ChartMesh::none) {
                try_triangle(side);
            }
        }
        return std::move(m_patch);
    }

private:
    struct Open {
        bool bent; ///< coplanar ones come first
        double distance;
        std::uint32_t side; ///< of the triangle that may be taken: the one that it hangs on by

        bool operator<(const Open& other) const {
            return std::tie(other.bent, other.distance, other.side) < std::tie(bent, distance, side);
        }
    };

    /// `laid`: with this side on the x axis.
    void take(std::uint32_t base, const LaidTriangle& laid) {
        const std::uint32_t triangle = base / 3;
        m_all.patch_of[triangle] = m_name;
        m_patch.triangles.push_back(triangle);
        for (std::uint32_t place = 3 * triangle; place < 3 * triangle + 3; ++place) {
            m_all.places[place] = m_places.at(m_mesh.vertices[place]);
        }
        const double area = 0.5 * laid.x1 * laid.y2;
        m_patch.area += area;
        m_facing += area * m_mesh.normals[triangle];
        m_patch.energy += area * distortion(laid, m_all.places[base], m_all.places[next_corner(base)],
                                            m_all.places[last_corner(base)])
                                     .energy();
        for (std::uint32_t side = 3 * triangle; side < 3 * triangle + 3; ++side) {
            const std::uint32_t beyond = m_mesh.across[side];
            if (beyond == ChartMesh::none || m_all.patch_of[beyond / 3] != ChartMesh::none || m_mesh.is_crease(side)) {
                continue;
            }
            const double flatness = glm::dot(m_mesh.normals[triangle], m_mesh.normals[beyond / 3]);
            const glm::dvec2 way = 0.5 * (m_all.places[side] + m_all.places[next_corner(side)]) - m_begin;
            m_open.push({flatness < coplanar_cosine, glm::dot(way, way), beyond});
        }
    }

    /// Where the corner that is not on `side` comes: the mean of what this triangle and those beside it say.
    [[nodiscard]] glm::dvec2 foretell(std::uint32_t side, const LaidTriangle& laid) const {
        const std::uint32_t far = m_mesh.vertices[last_corner(side)];
        glm::dvec2 sum =
            third_place(laid, m_places.at(m_mesh.vertices[side]), m_places.at(m_mesh.vertices[next_corner(side)]));
        double count = 1.0;
        for (const std::uint32_t own : {next_corner(side), last_corner(side)}) {
            const std::uint32_t beyond = m_mesh.across[own];
            if (beyond == ChartMesh::none || m_mesh.is_crease(own)) {
                continue;
            }
            // The side of that neighbour which does not touch the corner.
            std::uint32_t base = 3 * (beyond / 3);
            while (m_mesh.vertices[last_corner(base)] != far) {
                ++base;
            }
            const auto a = m_places.find(m_mesh.vertices[base]);
            const auto b = m_places.find(m_mesh.vertices[next_corner(base)]);
            if (a != m_places.end() && b != m_places.end() && a->second != b->second) {
                sum += third_place(lay_down(m_mesh, base), a->second, b->second);
                count += 1.0;
            }
        }
        return sum / count;
    }

    void try_triangle(std::uint32_t side) {
        const LaidTriangle laid = lay_down(m_mesh, side);
        const std::uint32_t far = m_mesh.vertices[last_corner(side)];
        const auto known = m_places.find(far);
        const glm::dvec2 place = known != m_places.end() ? known->second : foretell(side, laid);
        const Distortion bent = distortion(laid, m_places.at(m_mesh.vertices[side]),
                                           m_places.at(m_mesh.vertices[next_corner(side)]), place);
        // Written so that what is not a number is refused.
        if (!(bent.product > 0.0 && bent.energy() <= m_limits.triangle_energy)) {
            return;
        }
        // A patch stays round and leaves some of what it may be bent for its neighbours.
        constexpr double own_share = 0.4;
        constexpr double facing = 0.3; // about 72°
        const double area = 0.5 * laid.x1 * laid.y2;
        if (m_patch.energy + area * bent.energy() > own_share * m_limits.mean_energy * (m_patch.area + area) ||
            glm::dot(m_mesh.normals[side / 3], m_facing) < facing * glm::length(m_facing)) {
            return;
        }
        const glm::dvec2 a = m_places.at(m_mesh.vertices[side]);
        const glm::dvec2 b = m_places.at(m_mesh.vertices[next_corner(side)]);
        const PlaneTriangle triangle{a, b, place};
        if (m_grid.meets(triangle, 1e-7 * std::max(glm::length(b - a), glm::length(place - a)))) {
            return;
        }
        m_grid.add(triangle);
        m_places.emplace(far, place);
        take(side, laid);
    }

    Patches& m_all;
    const ChartMesh& m_mesh;
    const PatchLimits& m_limits;
    double m_side_length;
    PlaneGrid m_grid;
    std::uint32_t m_name = 0;
    Patch m_patch;
    glm::dvec3 m_facing{0.0}; ///< Σ area · normal
    glm::dvec2 m_begin{0.0};
    std::unordered_map<std::uint32_t, glm::dvec2> m_places; ///< by vertex; looked up only, so its order decides nothing
    std::priority_queue<Open> m_open;
};

} // namespace

void grow_patches(Patches& patches, const std::vector<std::uint32_t>& component, const PatchLimits& limits,
                  std::vector<Patch>& pieces) {
    double length = 0.0;
    for (const std::uint32_t triangle : component) {
        for (std::uint32_t side = 3 * triangle; side < 3 * triangle + 3; ++side) {
            length += glm::length(patches.mesh->corner(next_corner(side)) - patches.mesh->corner(side));
        }
    }
    PatchGrower grower(patches, limits, length / (3.0 * static_cast<double>(component.size())));
    for (const std::uint32_t seed : component) {
        if (patches.patch_of[seed] == ChartMesh::none && patches.mesh->normals[seed] != glm::dvec3(0.0)) {
            pieces.push_back(grower.grow(seed, static_cast<std::uint32_t>(pieces.size())));
        }
    }
}

} // namespace vkbake
