#include "finish/shading_sides.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>

#include "base/disjoint_sets.hpp"

namespace vkbake {

namespace {

/// Of a triangle; its ends ordered by UV, so that neighbours name it alike.
struct Edge {
    std::uint32_t chart = 0;
    std::array<float, 4> uv{};      ///< of both ends
    std::array<float, 6> normals{}; ///< likewise
    std::uint32_t place = 0;        ///< of the triangle in those given

    [[nodiscard]] auto name() const { return std::tie(chart, uv); }
};

Edge edge_of(const Surface& surface, const Atlas& atlas, std::uint32_t triangle, std::size_t corner) {
    std::size_t a = 3 * std::size_t{triangle} + corner;
    std::size_t b = 3 * std::size_t{triangle} + (corner + 1) % 3;
    const auto uv = [&](std::size_t entry) { return std::array{atlas.uvs[entry].x, atlas.uvs[entry].y}; };
    if (uv(b) < uv(a)) {
        std::swap(a, b);
    }
    const glm::vec3& at_a = surface.normals[a];
    const glm::vec3& at_b = surface.normals[b];
    return {.chart = atlas.chart[triangle],
            .uv = {atlas.uvs[a].x, atlas.uvs[a].y, atlas.uvs[b].x, atlas.uvs[b].y},
            .normals = {at_a.x, at_a.y, at_a.z, at_b.x, at_b.y, at_b.z}};
}

bool is_smooth(const Edge& one, const Edge& other) {
    const auto cosine = [&](std::size_t end) {
        return one.normals[end] * other.normals[end] + one.normals[end + 1] * other.normals[end + 1] +
               one.normals[end + 2] * other.normals[end + 2];
    };
    return std::min(cosine(0), cosine(3)) >= crease_cosine;
}

} // namespace

std::vector<std::uint32_t> shading_sides(const Surface& surface, const Atlas& atlas,
                                         std::span<const std::uint32_t> triangles) {
    std::vector<Edge> edges;
    edges.reserve(3 * triangles.size());
    for (std::size_t place = 0; place < triangles.size(); ++place) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            edges.push_back(edge_of(surface, atlas, triangles[place], corner));
            edges.back().place = static_cast<std::uint32_t>(place);
        }
    }
    // Where more than two meet, as UVs that lie on each other make them, those are compared whose normals are next.
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
        return std::tie(a.chart, a.uv, a.normals) < std::tie(b.chart, b.uv, b.normals);
    });
    DisjointSets sets(triangles.size());
    for (std::size_t i = 1; i < edges.size(); ++i) {
        if (edges[i].name() == edges[i - 1].name() && is_smooth(edges[i], edges[i - 1])) {
            sets.join(edges[i].place, edges[i - 1].place);
        }
    }
    std::vector<std::uint32_t> sides(triangles.size());
    for (std::uint32_t place = 0; place < sides.size(); ++place) {
        sides[place] = sets.find(place);
    }
    return sides;
}

} // namespace vkbake
