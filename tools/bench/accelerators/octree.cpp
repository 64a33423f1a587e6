#include "bench/accelerators/octree.hpp"

#include <algorithm>
#include <numeric>

namespace vkbake::bench {

Octree::Octree(const std::vector<Triangle>& triangles, const Box& bounds) : m_triangles(triangles) {
    const glm::vec3 size = bounds.high - bounds.low;
    const float half = 0.5F * std::max({size.x, size.y, size.z}) + reach_of_rounding;
    const glm::vec3 centre = 0.5F * (bounds.low + bounds.high);
    m_nodes.push_back({.box = {centre - half, centre + half}});
    std::vector<std::uint32_t> all(triangles.size());
    std::iota(all.begin(), all.end(), 0U);
    divide(0, all, 0);
}

void Octree::divide(std::uint32_t node, const std::vector<std::uint32_t>& held, int depth) {
    const Box box = m_nodes[node].box;
    if (held.size() > leaf_triangles && depth < greatest_depth) {
        const glm::vec3 middle = 0.5F * (box.low + box.high);
        std::array<std::vector<std::uint32_t>, 8> parts;
        std::array<Box, 8> boxes;
        std::size_t total = 0;
        for (std::size_t child = 0; child < parts.size(); ++child) {
            for (int axis = 0; axis < 3; ++axis) {
                const bool upper = (child >> axis & 1U) != 0;
                boxes[child].low[axis] = upper ? middle[axis] : box.low[axis];
                boxes[child].high[axis] = upper ? box.high[axis] : middle[axis];
            }
            std::copy_if(held.begin(), held.end(), std::back_inserter(parts[child]),
                         [&](std::uint32_t rank) { return touches(m_triangles[rank], boxes[child]); });
            total += parts[child].size();
        }
        // Where many triangles share a corner, cutting would go on for ever and tell nothing apart.
        if (total < 4 * held.size()) {
            const auto first = static_cast<std::uint32_t>(m_nodes.size());
            m_nodes[node].children = first;
            for (const Box& child : boxes) {
                m_nodes.push_back({.box = child});
            }
            for (std::uint32_t child = 0; child < parts.size(); ++child) {
                divide(first + child, parts[child], depth + 1);
            }
            return;
        }
    }
    m_nodes[node].begin = static_cast<std::uint32_t>(m_indices.size());
    m_indices.insert(m_indices.end(), held.begin(), held.end());
    m_nodes[node].end = static_cast<std::uint32_t>(m_indices.size());
}

bool Octree::occluded_below(std::uint32_t index, const PreparedRay& ray, std::uint32_t nearest_child) const {
    const Node& node = m_nodes[index];
    if (node.children == 0) {
        return std::any_of(m_indices.begin() + node.begin, m_indices.begin() + node.end, [&](std::uint32_t rank) {
            return rank != ray.ignored_rank && test_watertight(ray, m_triangles[rank]).hit;
        });
    }
    for (std::uint32_t k = 0; k < 8; ++k) { // in an order in which no cube comes before one that hides it
        const std::uint32_t child = node.children + (k ^ nearest_child);
        if (m_nodes[child].children == 0 && m_nodes[child].begin == m_nodes[child].end) {
            continue;
        }
        const Interval inside = pass(ray, m_nodes[child].box);
        if (inside.entry <= inside.exit && occluded_below(child, ray, nearest_child)) {
            return true;
        }
    }
    return false;
}

bool Octree::occluded(const PreparedRay& ray) const {
    std::uint32_t nearest_child = 0;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
        nearest_child |= ray.negative[axis] ? 1U << axis : 0U;
    }
    const Interval inside = pass(ray, m_nodes[0].box);
    return inside.entry <= inside.exit && occluded_below(0, ray, nearest_child);
}

std::size_t Octree::bytes() const {
    return sizeof(*this) + m_nodes.capacity() * sizeof(Node) + m_indices.capacity() * sizeof(std::uint32_t) +
           m_triangles.capacity() * sizeof(Triangle);
}

} // namespace vkbake::bench
