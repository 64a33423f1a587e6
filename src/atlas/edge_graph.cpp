#include "atlas/edge_graph.hpp"

#include <utility>

namespace vkbake {

EdgeGraph::EdgeGraph(std::span<const std::uint32_t> corner_ids) : m_edges_of(corner_ids.size(), no_edge) {
    struct Side {
        std::uint32_t low;
        std::uint32_t high;
        std::uint32_t place; ///< in m_edges_of

        bool operator<(const Side& other) const {
            return std::array{low, high, place} < std::array{other.low, other.high, other.place};
        }
    };
    std::vector<Side> sides;
    sides.reserve(corner_ids.size());
    for (std::uint32_t place = 0; place < corner_ids.size(); ++place) {
        const std::uint32_t from = corner_ids[place];
        const std::uint32_t to = corner_ids[place % 3 == 2 ? place - 2 : place + 1];
        if (from != to) {
            sides.push_back({std::min(from, to), std::max(from, to), place});
        }
    }
    std::sort(sides.begin(), sides.end());

    m_triangles.reserve(sides.size());
    for (std::size_t i = 0; i < sides.size(); ++i) {
        if (i == 0 || sides[i - 1].low != sides[i].low || sides[i - 1].high != sides[i].high) {
            m_first.push_back(static_cast<std::uint32_t>(i));
        }
        m_edges_of[sides[i].place] = static_cast<std::uint32_t>(m_first.size() - 1);
        m_triangles.push_back(sides[i].place / 3);
    }
    m_first.push_back(static_cast<std::uint32_t>(sides.size()));
}

} // namespace vkbake
