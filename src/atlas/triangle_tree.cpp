#include "atlas/triangle_tree.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace vkbake {

namespace {

constexpr std::uint32_t leaf_size = 4;

} // namespace

TriangleTree::TriangleTree(std::span<const glm::vec2> corners, std::vector<std::uint32_t> triangles)
    : m_corners(corners), m_triangles(std::move(triangles)) {
    std::erase_if(m_triangles, [&](std::uint32_t triangle) { return orientation(corners_of(triangle)) == 0; });
    if (m_triangles.empty()) {
        return;
    }
    m_groups.assign(m_triangles.size(), no_group);
    m_leaves.assign(m_triangles.size(), 0);
    m_nodes.reserve(2 * m_triangles.size() / leaf_size + 2);
    build(0, static_cast<std::uint32_t>(m_triangles.size()), 0);

    const auto [least, greatest] = std::minmax_element(m_triangles.begin(), m_triangles.end());
    m_first = *least;
    m_places.assign(std::size_t{*greatest} - m_first + 1, no_group);
    for (std::uint32_t i = 0; i < m_triangles.size(); ++i) {
        m_places[m_triangles[i] - m_first] = i;
    }
}

std::uint32_t TriangleTree::build(std::uint32_t begin, std::uint32_t end, std::uint32_t parent) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    glm::vec2 lower{infinity};
    glm::vec2 upper{-infinity};
    glm::vec2 centre_lower{infinity};
    glm::vec2 centre_upper{-infinity};
    const auto centre = [&](std::uint32_t triangle, int axis) {
        const FlatTriangle t = corners_of(triangle);
        const auto [low, high] = std::minmax({t[0][axis], t[1][axis], t[2][axis]});
        return 0.5F * low + 0.5F * high;
    };
    for (std::uint32_t i = begin; i < end; ++i) {
        const FlatTriangle t = corners_of(m_triangles[i]);
        for (int axis = 0; axis < 2; ++axis) {
            lower[axis] = std::min({lower[axis], t[0][axis], t[1][axis], t[2][axis]});
            upper[axis] = std::max({upper[axis], t[0][axis], t[1][axis], t[2][axis]});
            const float middle = centre(m_triangles[i], axis);
            centre_lower[axis] = std::min(centre_lower[axis], middle);
            centre_upper[axis] = std::max(centre_upper[axis], middle);
        }
    }

    const auto index = static_cast<std::uint32_t>(m_nodes.size());
    m_nodes.push_back({lower, upper, parent, 0, begin, end, no_group});
    if (end - begin <= leaf_size) {
        std::fill(m_leaves.begin() + begin, m_leaves.begin() + end, index);
        return index;
    }
    const glm::vec2 extent = centre_upper - centre_lower;
    const int axis = extent.x >= extent.y ? 0 : 1;
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(m_triangles.begin() + begin, m_triangles.begin() + middle, m_triangles.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) { return centre(a, axis) < centre(b, axis); });
    build(begin, middle, index);
    const std::uint32_t second = build(middle, end, index);
    m_nodes[index].second = second;
    return index;
}

bool TriangleTree::may_overlap(const FlatTriangle& triangle, int turn, const Node& node) {
    for (int axis = 0; axis < 2; ++axis) {
        const auto [low, high] = std::minmax({triangle[0][axis], triangle[1][axis], triangle[2][axis]});
        if (high <= node.lower[axis] || node.upper[axis] <= low) {
            return false;
        }
    }
    // For each edge the one corner of the box that lies farthest inside decides.
    for (unsigned edge = 0; edge < 3; ++edge) {
        const glm::vec2& from = triangle[edge];
        const glm::vec2& to = triangle[(edge + 1) % 3];
        const bool rises = (to.y > from.y) == (turn > 0);
        const bool right = (to.x > from.x) == (turn > 0);
        const glm::vec2 corner{rises ? node.lower.x : node.upper.x, right ? node.upper.y : node.lower.y};
        if (turn * orientation(from, to, corner) <= 0) {
            return false;
        }
    }
    return true;
}

void TriangleTree::mark(std::uint32_t triangle, std::uint32_t group) {
    if (triangle < m_first || triangle - m_first >= m_places.size() || m_places[triangle - m_first] == no_group) {
        return;
    }
    const std::uint32_t place = m_places[triangle - m_first];
    m_groups[place] = group;
    for (std::uint32_t index = m_leaves[place]; m_nodes[index].group != group; index = m_nodes[index].parent) {
        m_nodes[index].group = group;
        if (index == 0) {
            break;
        }
    }
}

bool TriangleTree::overlaps_group(std::uint32_t triangle, std::uint32_t group) const {
    bool found = false;
    auto visit = [&found](std::uint32_t) {
        found = true;
        return false;
    };
    visit_overlaps_of(triangle, group, visit);
    return found;
}

} // namespace vkbake
