#include "atlas/polypacks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <glm/vec3.hpp>

#include "atlas/edge_graph.hpp"
#include "atlas/fold_in.hpp"
#include "atlas/predicates.hpp"
#include "atlas/triangle_tree.hpp"

namespace vkbake {

namespace {

constexpr std::uint32_t none = 0xFFFFFFFFU;

enum class HalfAxis : std::uint8_t { pos_x, neg_x, pos_y, neg_y, pos_z, neg_z, flat_only };

HalfAxis half_axis(const glm::vec3& normal) {
    constexpr float tolerance = 1e-4F;
    const float greatest = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
    if (!(greatest > 0.0F)) {
        return HalfAxis::flat_only;
    }
    const float enough = greatest * (1.0F - tolerance);
    if (std::abs(normal.y) >= enough) {
        return normal.y > 0.0F ? HalfAxis::pos_y : HalfAxis::neg_y;
    }
    if (std::abs(normal.x) >= enough) {
        return normal.x > 0.0F ? HalfAxis::pos_x : HalfAxis::neg_x;
    }
    return normal.z > 0.0F ? HalfAxis::pos_z : HalfAxis::neg_z;
}

/// Drops a coordinate and turns signs, so the result is exact.
glm::vec2 project(const glm::vec3& p, HalfAxis axis) {
    switch (axis) {
    case HalfAxis::pos_x:
        return {-p.z, -p.y};
    case HalfAxis::neg_x:
        return {p.z, -p.y};
    case HalfAxis::pos_y:
        return {p.x, p.z};
    case HalfAxis::neg_y:
        return {p.x, -p.z};
    case HalfAxis::pos_z:
        return {p.x, -p.y};
    case HalfAxis::neg_z:
        return {-p.x, -p.y};
    case HalfAxis::flat_only:
        break;
    }
    return {0.0F, 0.0F};
}

/// One object's triangles, numbered by their place in canonical order.
class PolypackMaker {
public:
    PolypackMaker(const Surface& surface, std::span<const std::uint32_t> triangles)
        : m_axes(triangles.size()), m_flat(3 * triangles.size()), m_ids(weld_corners(surface, triangles)),
          m_graph(m_ids), m_flood(m_graph), m_chart_of(triangles.size(), none) {
        for (std::size_t local = 0; local < triangles.size(); ++local) {
            project_triangle(surface, triangles[local], local);
        }
    }

    void run() {
        for (std::uint32_t seed = 0; seed < m_axes.size(); ++seed) {
            if (m_axes[seed] == HalfAxis::flat_only || m_chart_of[seed] != none) {
                continue;
            }
            m_chart_of[seed] = 0; // only "taken"
            auto piece = m_flood.collect(seed, [&](std::uint32_t triangle) {
                const bool admitted = m_chart_of[triangle] == none && m_axes[triangle] == m_axes[seed];
                m_chart_of[triangle] = admitted ? 0 : m_chart_of[triangle];
                return admitted;
            });
            cut_overlaps(std::move(piece));
        }
        std::sort(m_charts.begin(), m_charts.end());
        fold_in(m_ids, m_flat, m_charts);
    }

    [[nodiscard]] const std::vector<std::vector<std::uint32_t>>& charts() const { return m_charts; }
    [[nodiscard]] const std::vector<glm::vec2>& flat() const { return m_flat; }

private:
    static std::vector<std::uint32_t> weld_corners(const Surface& surface, std::span<const std::uint32_t> triangles) {
        std::vector<glm::vec3> corners;
        corners.reserve(3 * triangles.size());
        for (const std::uint32_t triangle : triangles) {
            const auto first = surface.positions.begin() + 3 * static_cast<std::ptrdiff_t>(triangle);
            corners.insert(corners.end(), first, first + 3);
        }
        return weld(std::span<const glm::vec3>(corners));
    }

    void project_triangle(const Surface& surface, std::uint32_t triangle, std::size_t local) {
        HalfAxis axis = half_axis(surface.geometric_normals[triangle]);
        FlatTriangle corners{};
        for (std::size_t c = 0; c < 3; ++c) {
            corners[c] = project(surface.positions[3 * std::size_t{triangle} + c], axis);
        }
        // v runs down, so a front turns clockwise in (u, v). A sliver whose normal is lost in rounding may not: it has
        // no area worth a texel, and is treated as one that has none.
        if (axis != HalfAxis::flat_only && orientation(corners) >= 0) {
            axis = HalfAxis::flat_only;
        }
        m_axes[local] = axis;
        std::copy(corners.begin(), corners.end(), m_flat.begin() + static_cast<std::ptrdiff_t>(3 * local));
    }

    void cut_overlaps(std::vector<std::uint32_t> piece) {
        if (piece.size() == 1) {
            m_charts.push_back(std::move(piece));
            return;
        }
        TriangleTree tree(m_flat, piece);
        if (std::ranges::none_of(piece, [&](std::uint32_t triangle) { return tree.overlaps_any(triangle); })) {
            m_charts.push_back(std::move(piece));
            return;
        }
        for (const std::uint32_t triangle : piece) {
            m_chart_of[triangle] = none;
        }
        // Triangles of other pieces are taken, of another half-axis, or not joined by edges to this one.
        for (const std::uint32_t seed : piece) {
            if (m_chart_of[seed] != none) {
                continue;
            }
            const auto group = static_cast<std::uint32_t>(m_charts.size());
            const auto take = [&](std::uint32_t triangle) {
                m_chart_of[triangle] = 0;
                tree.mark(triangle, group);
            };
            take(seed);
            m_charts.push_back(m_flood.collect(seed, [&](std::uint32_t triangle) {
                const bool admitted = m_chart_of[triangle] == none && m_axes[triangle] == m_axes[seed] &&
                                      !tree.overlaps_group(triangle, group);
                if (admitted) {
                    take(triangle);
                }
                return admitted;
            }));
        }
    }

    std::vector<HalfAxis> m_axes;
    std::vector<glm::vec2> m_flat;
    std::vector<std::uint32_t> m_ids;
    EdgeGraph m_graph;
    EdgeFlood m_flood;
    std::vector<std::uint32_t> m_chart_of;
    std::vector<std::vector<std::uint32_t>> m_charts;
};

} // namespace

std::vector<Chart> make_polypacks(const Surface& surface, std::span<const std::uint32_t> triangles,
                                  std::span<glm::vec2> flat) {
    PolypackMaker maker(surface, triangles);
    maker.run();
    return charts_of(maker.charts(), maker.flat(), triangles, flat);
}

} // namespace vkbake
