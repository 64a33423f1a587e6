// Finds the triangles of a plane that overlap a given one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "atlas/predicates.hpp"

namespace vkbake {

/// A binary tree of boxes over triangles, split at the median of the box centres. Made for finding overlaps exactly: a
/// node is left out where its box lies beyond an edge of the triangle asked for, so slivers and a few huge triangles
/// among many small ones cost little. Triangles without area overlap nothing and are not stored. A query can be
/// narrowed to triangles that were marked with a group; groups are for growing one set after the other.
class TriangleTree {
public:
    static constexpr std::uint32_t no_group = 0xFFFFFFFFU;

    /// Triangle t has the corners 3·t … 3·t + 2 of `corners`, which must outlive the tree. `triangles`: those to store.
    TriangleTree(std::span<const glm::vec2> corners, std::span<const std::uint32_t> triangles);

    /// Calls visit(other) for each stored triangle that overlaps `triangle` (itself, if it is stored, is left out)
    /// until it returns false. The order is not defined.
    template<typename Visit>
    void visit_overlaps(std::uint32_t triangle, Visit visit) const {
        visit_overlaps_of(triangle, no_group, visit);
    }

    [[nodiscard]] bool overlaps_any(std::uint32_t triangle) const {
        bool found = false;
        visit_overlaps(triangle, [&](std::uint32_t) {
            found = true;
            return false;
        });
        return found;
    }

    /// Puts a stored triangle into a group; it leaves any other that it was in. Has no effect on one without area.
    void mark(std::uint32_t triangle, std::uint32_t group);

    /// Whether `triangle` overlaps one that is marked with `group`, the last group that was marked.
    [[nodiscard]] bool overlaps_group(std::uint32_t triangle, std::uint32_t group) const;

    [[nodiscard]] FlatTriangle corners_of(std::uint32_t triangle) const {
        const std::size_t first = 3 * static_cast<std::size_t>(triangle);
        return {m_corners[first], m_corners[first + 1], m_corners[first + 2]};
    }

private:
    struct Entry {
        glm::vec2 lower;
        glm::vec2 upper;
        std::uint32_t triangle;
    };
    struct Node {
        glm::vec2 lower{0.0F};
        glm::vec2 upper{0.0F};
        std::uint32_t parent = 0;
        std::uint32_t second = 0; ///< the second child; the first is the next node. 0: a leaf
        std::uint32_t begin = 0;  ///< what lies below: m_entries[begin, end)
        std::uint32_t end = 0;
        std::uint32_t group = no_group; ///< the last group that something below was marked with
    };

    std::uint32_t build(std::uint32_t begin, std::uint32_t end, std::uint32_t parent);
    void prepare_marks();
    [[nodiscard]] static bool may_overlap(const FlatTriangle& triangle, int turn, const Node& node);

    template<typename Visit>
    void visit_overlaps_of(std::uint32_t triangle, std::uint32_t group, Visit& visit) const {
        const FlatTriangle asked = corners_of(triangle);
        const int turn = orientation(asked);
        if (turn == 0 || m_nodes.empty()) {
            return;
        }
        std::array<std::uint32_t, 33> open{0}; // halves of 2³² triangles; one waits at each depth
        std::size_t count = 1;
        while (count > 0) {
            const std::uint32_t index = open[--count];
            const Node& node = m_nodes[index];
            if ((group != no_group && node.group != group) || !may_overlap(asked, turn, node)) {
                continue;
            }
            if (node.second != 0) {
                open[count++] = node.second;
                open[count++] = index + 1;
                continue;
            }
            for (std::uint32_t i = node.begin; i < node.end; ++i) {
                const std::uint32_t other = m_entries[i].triangle;
                if (other != triangle && (group == no_group || m_groups[i] == group) &&
                    triangles_overlap(asked, corners_of(other)) && !visit(other)) {
                    return;
                }
            }
        }
    }

    std::span<const glm::vec2> m_corners;
    std::vector<Entry> m_entries;
    std::vector<Node> m_nodes;
    // Empty until something is marked.
    std::vector<std::uint32_t> m_groups; ///< one an entry
    std::vector<std::uint32_t> m_leaves; ///< one an entry: its leaf
    std::vector<std::uint32_t> m_places; ///< by triangle − m_first: its entry, or no_group
    std::uint32_t m_first = 0;           ///< the least triangle that is stored
};

} // namespace vkbake
