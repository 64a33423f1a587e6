#include "atlas/triangle_tree.hpp"

#include <algorithm>

#include <glm/common.hpp>

namespace vkbake {

namespace {

constexpr std::uint32_t leaf_size = 4;

} // namespace

TriangleTree::TriangleTree(std::span<const glm::vec2> corners, std::span<const std::uint32_t> triangles)
    : m_corners(corners) {
    m_entries.reserve(triangles.size());
    for (const std::uint32_t triangle : triangles) {
        const FlatTriangle t = corners_of(triangle);
        if (orientation(t) != 0) {
            m_entries.push_back({glm::min(glm::min(t[0], t[1]), t[2]), glm::max(glm::max(t[0], t[1]), t[2]), triangle});
        }
    }
    if (!m_entries.empty()) {
        m_nodes.reserve(2 * m_entries.size() / leaf_size + 2);
        build(0, static_cast<std::uint32_t>(m_entries.size()), 0);
    }
}

std::uint32_t TriangleTree::build(std::uint32_t begin, std::uint32_t end, std::uint32_t parent) {
    const auto index = static_cast<std::uint32_t>(m_nodes.size());
    m_nodes.push_back({.parent = parent, .begin = begin, .end = end});
    const std::span<Entry> own = std::span(m_entries).subspan(begin, end - begin);
    if (own.size() <= leaf_size) {
        m_nodes[index].lower = own[0].lower;
        m_nodes[index].upper = own[0].upper;
        for (const Entry& entry : own.subspan(1)) {
            m_nodes[index].lower = glm::min(m_nodes[index].lower, entry.lower);
            m_nodes[index].upper = glm::max(m_nodes[index].upper, entry.upper);
        }
        return index;
    }
    const auto centre = [](const Entry& entry) { return 0.5F * entry.lower + 0.5F * entry.upper; };
    glm::vec2 least = centre(own[0]);
    glm::vec2 greatest = least;
    for (const Entry& entry : own) {
        least = glm::min(least, centre(entry));
        greatest = glm::max(greatest, centre(entry));
    }
    const int axis = greatest.x - least.x >= greatest.y - least.y ? 0 : 1;
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(own.begin(), own.begin() + (middle - begin), own.end(),
                     [&](const Entry& a, const Entry& b) { return centre(a)[axis] < centre(b)[axis]; });
    build(begin, middle, index);
    const std::uint32_t second = build(middle, end, index);
    Node& node = m_nodes[index];
    node.second = second;
    node.lower = glm::min(m_nodes[index + 1].lower, m_nodes[second].lower);
    node.upper = glm::max(m_nodes[index + 1].upper, m_nodes[second].upper);
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

void TriangleTree::prepare_marks() {
    m_groups.assign(m_entries.size(), no_group);
    m_leaves.resize(m_entries.size());
    std::uint32_t greatest = 0;
    m_first = no_group;
    for (std::uint32_t index = 0; index < m_nodes.size(); ++index) {
        const Node& node = m_nodes[index];
        if (node.second == 0) {
            std::fill(m_leaves.begin() + node.begin, m_leaves.begin() + node.end, index);
        }
    }
    for (const Entry& entry : m_entries) {
        m_first = std::min(m_first, entry.triangle);
        greatest = std::max(greatest, entry.triangle);
    }
    m_places.assign(std::size_t{greatest} - m_first + 1, no_group);
    for (std::uint32_t i = 0; i < m_entries.size(); ++i) {
        m_places[m_entries[i].triangle - m_first] = i;
    }
}

void TriangleTree::mark(std::uint32_t triangle, std::uint32_t group) {
    if (m_entries.empty()) {
        return;
    }
    if (m_groups.empty()) {
        prepare_marks();
    }
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
