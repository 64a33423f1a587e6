// Which triangles share which edges.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace vkbake {

/// Numbers the distinct points 0, 1, … in lexicographic order of their coordinates; −0 and 0 are one.
template<typename Point>
[[nodiscard]] std::vector<std::uint32_t> weld(std::span<const Point> points) {
    const auto less = [&](std::uint32_t a, std::uint32_t b) {
        for (int axis = 0; axis < Point::length(); ++axis) {
            if (points[a][axis] != points[b][axis]) {
                return points[a][axis] < points[b][axis];
            }
        }
        return false;
    };
    std::vector<std::uint32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), less);
    std::vector<std::uint32_t> ids(points.size());
    std::uint32_t id = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        id += i > 0 && less(order[i - 1], order[i]) ? 1U : 0U;
        ids[order[i]] = id;
    }
    return ids;
}

/// Edges between welded corners. An edge whose two ends are one point joins nothing.
class EdgeGraph {
public:
    static constexpr std::uint32_t no_edge = 0xFFFFFFFFU;

    /// Triangle t has the corners 3·t … 3·t + 2. Edges are numbered in the order of their corners' ids.
    explicit EdgeGraph(std::span<const std::uint32_t> corner_ids);

    [[nodiscard]] std::size_t triangle_count() const { return m_edges_of.size() / 3; }
    [[nodiscard]] std::size_t edge_count() const { return m_first.size() - 1; }

    /// The triangle's edges, `no_edge` for one that joins nothing.
    [[nodiscard]] std::span<const std::uint32_t, 3> edges_of(std::uint32_t triangle) const {
        return std::span<const std::uint32_t, 3>(&m_edges_of[3 * std::size_t{triangle}], 3);
    }

    /// The triangles at an edge, ascending. Any number: surfaces need not be manifold.
    [[nodiscard]] std::span<const std::uint32_t> triangles_at(std::uint32_t edge) const {
        return std::span(m_triangles).subspan(m_first[edge], m_first[edge + 1] - m_first[edge]);
    }

private:
    std::vector<std::uint32_t> m_edges_of; ///< 3 a triangle
    std::vector<std::uint32_t> m_first;    ///< 1 an edge, and the end: where its triangles start
    std::vector<std::uint32_t> m_triangles;
};

/// Collects sets of triangles that hang together by edges.
class EdgeFlood {
public:
    explicit EdgeFlood(const EdgeGraph& graph) : m_graph(graph), m_reached(graph.edge_count(), 0) {}

    /// Breadth first from `seed`, which is taken; a triangle is taken where `admit` (asked when an edge first reaches
    /// it, and again by its other edges while it is refused) says so. Returns those taken, ascending.
    template<typename Admit>
    [[nodiscard]] std::vector<std::uint32_t> collect(std::uint32_t seed, Admit admit) {
        ++m_round;
        std::vector<std::uint32_t> taken{seed};
        for (std::size_t next = 0; next < taken.size(); ++next) {
            for (const std::uint32_t edge : m_graph.edges_of(taken[next])) {
                if (edge == EdgeGraph::no_edge || m_reached[edge] == m_round) {
                    continue;
                }
                m_reached[edge] = m_round;
                for (const std::uint32_t triangle : m_graph.triangles_at(edge)) {
                    if (admit(triangle)) {
                        taken.push_back(triangle);
                    }
                }
            }
        }
        std::sort(taken.begin(), taken.end());
        return taken;
    }

private:
    const EdgeGraph& m_graph;
    std::vector<std::uint32_t> m_reached; ///< 1 an edge: the last round that came by
    std::uint32_t m_round = 0;
};

} // namespace vkbake
