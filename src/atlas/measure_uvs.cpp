#include "atlas/measure_uvs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "atlas/edge_graph.hpp"
#include "atlas/predicates.hpp"
#include "atlas/triangle_tree.hpp"
#include "base/disjoint_sets.hpp"

namespace vkbake {

namespace {

/// Sums over triangles from which the stretch follows.
struct StretchSum {
    double energy = 0.0; ///< Σ area · (σ₁² + σ₂²) / 2, σ: how far the map from UVs to space stretches
    double area = 0.0;
    double uv_area = 0.0;

    /// False where the UVs have no area.
    bool add(const glm::vec3* position, const std::array<glm::dvec2, 3>& uv) {
        const glm::dvec3 e = glm::dvec3(position[1]) - glm::dvec3(position[0]);
        const glm::dvec3 f = glm::dvec3(position[2]) - glm::dvec3(position[0]);
        const glm::dvec2 s = uv[1] - uv[0];
        const glm::dvec2 t = uv[2] - uv[0];
        const double ee = e.x * e.x + e.y * e.y + e.z * e.z;
        const double ff = f.x * f.x + f.y * f.y + f.z * f.z;
        const double ef = e.x * f.x + e.y * f.y + e.z * f.z;
        const double own_area = 0.5 * std::sqrt(std::max(0.0, ee * ff - ef * ef));
        const double turned = s.x * t.y - s.y * t.x;
        if (turned == 0.0) {
            return own_area == 0.0;
        }
        // The squares of the two partial derivatives of position, summed: the trace of the metric.
        const double trace =
            (ee * (t.x * t.x + t.y * t.y) + ff * (s.x * s.x + s.y * s.y) - 2.0 * ef * (s.x * t.x + s.y * t.y)) /
            (turned * turned);
        energy += own_area * 0.5 * trace;
        area += own_area;
        uv_area += 0.5 * std::abs(turned);
        return true;
    }

    [[nodiscard]] double stretch() const { return area > 0.0 ? std::sqrt(energy / area * uv_area / area) : 1.0; }
};

DisjointSets join_charts(const MeasuredUvs& uvs) {
    const std::vector<std::uint32_t> ids = weld(uvs.positions);
    const EdgeGraph graph(ids);
    DisjointSets sets(uvs.page.size());
    const auto place_of = [&](std::uint32_t triangle, std::uint32_t id) {
        std::uint32_t corner = 3 * triangle;
        while (ids[corner] != id) {
            ++corner;
        }
        return uvs.texel(corner);
    };
    const auto near = [](const glm::dvec2& a, const glm::dvec2& b) {
        constexpr double enough = 1.0 / 16.0;
        return std::abs(a.x - b.x) <= enough && std::abs(a.y - b.y) <= enough;
    };
    for (std::uint32_t triangle = 0; triangle < uvs.page.size(); ++triangle) {
        for (std::uint32_t side = 0; side < 3; ++side) {
            const std::uint32_t edge = graph.edges_of(triangle)[side];
            if (edge == EdgeGraph::no_edge) {
                continue;
            }
            const std::uint32_t from = ids[3 * triangle + side];
            const std::uint32_t to = ids[3 * triangle + (side + 1) % 3];
            for (const std::uint32_t other : graph.triangles_at(edge)) {
                if (other > triangle && uvs.page[other] == uvs.page[triangle] &&
                    near(place_of(triangle, from), place_of(other, from)) &&
                    near(place_of(triangle, to), place_of(other, to))) {
                    sets.join(triangle, other);
                }
            }
        }
    }
    return sets;
}

std::size_t count_overlapping(const MeasuredUvs& uvs) {
    std::vector<std::vector<std::uint32_t>> pages;
    for (std::uint32_t triangle = 0; triangle < uvs.page.size(); ++triangle) {
        pages.resize(std::max<std::size_t>(pages.size(), uvs.page[triangle] + std::size_t{1}));
        pages[uvs.page[triangle]].push_back(triangle);
    }
    std::size_t count = 0;
    for (const auto& triangles : pages) {
        const TriangleTree tree(uvs.uvs, triangles);
        count += static_cast<std::size_t>(
            std::ranges::count_if(triangles, [&](std::uint32_t triangle) { return tree.overlaps_any(triangle); }));
    }
    return count;
}

} // namespace

UvFigures measure_uvs(const MeasuredUvs& uvs) {
    UvFigures figures;
    DisjointSets sets = join_charts(uvs);
    StretchSum sum;
    std::vector<double> signed_area(uvs.page.size(), 0.0); // by the chart's least triangle
    std::vector<bool> is_chart(uvs.page.size(), false);
    const auto texels_of = [&](std::uint32_t triangle) {
        const std::size_t corner = 3 * std::size_t{triangle};
        return std::array{uvs.texel(corner), uvs.texel(corner + 1), uvs.texel(corner + 2)};
    };
    const auto doubled_area = [&](std::uint32_t triangle) {
        const auto [a, b, c] = texels_of(triangle);
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    };
    for (std::uint32_t triangle = 0; triangle < uvs.page.size(); ++triangle) {
        signed_area[sets.find(triangle)] += doubled_area(triangle);
        if (doubled_area(triangle) != 0.0) {
            is_chart[sets.find(triangle)] = true;
        }
        figures.unmapped += sum.add(&uvs.positions[3 * std::size_t{triangle}], texels_of(triangle)) ? 0 : 1;
    }
    // What has no area in the map is no chart.
    figures.charts = static_cast<std::size_t>(std::count(is_chart.begin(), is_chart.end(), true));
    for (std::uint32_t triangle = 0; triangle < uvs.page.size(); ++triangle) {
        figures.mirrored += doubled_area(triangle) * signed_area[sets.find(triangle)] < 0.0 ? 1 : 0;
    }
    figures.overlapping = count_overlapping(uvs);
    figures.uv_area = sum.uv_area;
    figures.stretch = sum.stretch();
    return figures;
}

double l2_stretch(std::span<const glm::vec3> positions, std::span<const glm::vec2> flat,
                  std::span<const std::uint32_t> triangles) {
    StretchSum sum;
    for (const std::uint32_t triangle : triangles) {
        const glm::vec2* const own = &flat[3 * std::size_t{triangle}];
        (void)sum.add(&positions[3 * std::size_t{triangle}],
                      {glm::dvec2(own[0]), glm::dvec2(own[1]), glm::dvec2(own[2])});
    }
    return sum.stretch();
}

} // namespace vkbake
