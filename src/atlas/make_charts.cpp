#include "atlas/make_charts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <glm/vec3.hpp>

#include "atlas/edge_graph.hpp"
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
class ChartMaker {
public:
    ChartMaker(const Surface& surface, std::span<const std::uint32_t> triangles)
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
            m_chart_of[seed] = 0; // only "taken"; numbered below
            auto piece = m_flood.collect(seed, [&](std::uint32_t triangle) {
                const bool admitted = m_chart_of[triangle] == none && m_axes[triangle] == m_axes[seed];
                m_chart_of[triangle] = admitted ? 0 : m_chart_of[triangle];
                return admitted;
            });
            cut_overlaps(std::move(piece));
        }
        std::sort(m_charts.begin(), m_charts.end());
        for (std::uint32_t chart = 0; chart < m_charts.size(); ++chart) {
            for (const std::uint32_t triangle : m_charts[chart]) {
                m_chart_of[triangle] = chart;
            }
        }
        attach_triangles_without_area();
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
        bool overlaps = false;
        for (std::size_t i = 0; i < piece.size() && !overlaps; ++i) {
            tree.visit_overlaps(piece[i], [&](std::uint32_t) {
                overlaps = true;
                return false;
            });
        }
        if (!overlaps) {
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

    void attach_triangles_without_area() {
        std::vector<std::uint32_t> corner_at(m_ids.size(),
                                             none); // by id: the first corner there of a triangle in a chart
        std::uint32_t any_corner = none;
        for (std::uint32_t corner = 0; corner < m_ids.size(); ++corner) {
            if (m_chart_of[corner / 3] != none) {
                corner_at[m_ids[corner]] = std::min(corner_at[m_ids[corner]], corner);
                any_corner = std::min(any_corner, corner);
            }
        }
        std::vector<std::uint32_t> homeless;
        for (std::uint32_t triangle = 0; triangle < m_axes.size(); ++triangle) {
            if (m_axes[triangle] != HalfAxis::flat_only) {
                continue;
            }
            std::uint32_t at = none;
            for (std::uint32_t corner = 3 * triangle; corner < 3 * triangle + 3; ++corner) {
                at = std::min(at, corner_at[m_ids[corner]]);
            }
            at = at == none ? any_corner : at;
            const glm::vec2 place = at == none ? glm::vec2(0.0F) : m_flat[at];
            std::fill_n(m_flat.begin() + 3 * static_cast<std::ptrdiff_t>(triangle), 3, place);
            if (at == none) {
                homeless.push_back(triangle);
            } else {
                m_charts[m_chart_of[at / 3]].push_back(triangle);
            }
        }
        if (!homeless.empty()) {
            m_charts.push_back(std::move(homeless));
        }
        for (auto& chart : m_charts) {
            std::sort(chart.begin(), chart.end());
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

Chart bounded_chart(std::vector<std::uint32_t> triangles, std::span<const glm::vec2> flat) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Chart chart{std::move(triangles), glm::dvec2(infinity), glm::dvec2(-infinity), 1.0};
    for (const std::uint32_t triangle : chart.triangles) {
        for (std::size_t c = 0; c < 3; ++c) {
            for (int axis = 0; axis < 2; ++axis) {
                const double value = flat[3 * std::size_t{triangle} + c][axis];
                chart.lower[axis] = std::min(chart.lower[axis], value);
                chart.upper[axis] = std::max(chart.upper[axis], value);
            }
        }
    }
    return chart;
}

std::vector<Chart> make_charts(const Surface& surface, std::span<const std::uint32_t> triangles,
                               std::span<glm::vec2> flat) {
    ChartMaker maker(surface, triangles);
    maker.run();
    for (std::size_t local = 0; local < triangles.size(); ++local) {
        std::copy_n(maker.flat().begin() + static_cast<std::ptrdiff_t>(3 * local), 3,
                    flat.begin() + 3 * static_cast<std::ptrdiff_t>(triangles[local]));
    }
    std::vector<Chart> charts;
    charts.reserve(maker.charts().size());
    for (const auto& members : maker.charts()) {
        std::vector<std::uint32_t> numbers(members.size());
        std::transform(members.begin(), members.end(), numbers.begin(),
                       [&](std::uint32_t local) { return triangles[local]; });
        charts.push_back(bounded_chart(std::move(numbers), flat));
    }
    return charts;
}

} // namespace vkbake
