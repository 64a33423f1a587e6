// Triangles put into a leaf.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "bvh/hierarchy.hpp"

namespace vkbake {

/// Finds out which triangles share a leaf, and which of its vertices are whose.
class LeafBuilder {
public:
    LeafBuilder();

    /// False, and nothing is changed, where the triangle or its vertices find no room.
    bool add(const Triangle& triangle);
    [[nodiscard]] std::size_t count() const { return m_count; }
    /// As Leaf::corners, of the triangle that was added at this place.
    [[nodiscard]] std::uint16_t corners(std::size_t lane) const { return m_corners[lane]; }

private:
    void forget_from(std::uint32_t vertex);

    std::array<std::array<float, leaf_vertices>, 3> m_vertices; // an x that none can have where there is none yet
    std::array<std::uint16_t, leaf_width> m_corners{};
    std::uint32_t m_vertex_count = 0;
    std::size_t m_count = 0;
};

/// Writes the leaf of the triangles of these ranks, which a LeafBuilder has given these corners.
void write_leaf(Leaf& leaf, const ListedTriangles& triangles, std::span<const std::uint32_t> ranks,
                const std::uint16_t* corners, std::uint32_t first_place);

} // namespace vkbake
