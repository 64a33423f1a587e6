#include "bvh/leaf_builder.hpp"

#include <array>
#include <bit>

namespace vkbake {
namespace {

// By bits: 0 and −0 are two vertices, since a test may tell them apart.
bool same_vertex(const Leaf& leaf, std::size_t vertex, const glm::vec3& corner) {
    bool same = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        same = same && std::bit_cast<std::uint32_t>(leaf.vertices[axis][vertex]) ==
                           std::bit_cast<std::uint32_t>(corner[static_cast<int>(axis)]);
    }
    return same;
}

} // namespace

LeafBuilder::LeafBuilder() = default;

bool LeafBuilder::add(const Triangle& triangle) {
    if (m_count == leaf_width) {
        return false;
    }
    const std::uint32_t before = m_leaf.vertex_count;
    std::size_t packed = 0;
    for (std::size_t corner = 0; corner < 3; ++corner) {
        std::size_t vertex = 0;
        while (vertex < m_leaf.vertex_count && !same_vertex(m_leaf, vertex, triangle.corners[corner])) {
            ++vertex;
        }
        if (vertex == leaf_vertices) {
            m_leaf.vertex_count = before;
            return false;
        }
        if (vertex == m_leaf.vertex_count) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                m_leaf.vertices[axis][vertex] = triangle.corners[corner][static_cast<int>(axis)];
            }
            ++m_leaf.vertex_count;
        }
        packed |= vertex << (4 * corner);
    }
    m_leaf.corners[m_count++] = static_cast<std::uint16_t>(packed);
    return true;
}

Leaf LeafBuilder::take(std::uint32_t first_place) const {
    Leaf leaf = m_leaf;
    leaf.first_place = first_place;
    for (auto& row : leaf.vertices) {
        for (std::size_t vertex = leaf.vertex_count; vertex < leaf_vertices; ++vertex) {
            row[vertex] = row[0];
        }
    }
    return leaf;
}

} // namespace vkbake
