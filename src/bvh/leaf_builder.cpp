#include "bvh/leaf_builder.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "bvh/float4.hpp"

namespace vkbake {
namespace {

constexpr std::uint32_t no_coordinate = 0x7fffffffU; // no finite number has these bits

Int4 bits_of(const float* four) { return Int4(load4(four)); }

Int4 bits_of(float value) { return Int4(fill4(value)); }

// The vertex's number and 1, or 0. By bits: 0 and −0 are two vertices, since a test may tell them apart. All of them
// are compared, without a branch: which one it is cannot be foretold.
std::uint32_t find(const std::array<std::array<float, leaf_vertices>, 3>& vertices, const glm::vec3& corner) {
    const Int4 x = bits_of(corner.x);
    const Int4 y = bits_of(corner.y);
    const Int4 z = bits_of(corner.z);
    Int4 numbers{1, 2, 3, 4};
    Int4 found{0, 0, 0, 0};
    for (std::size_t first = 0; first < leaf_vertices; first += 4) {
        const Int4 same = (bits_of(&vertices[0][first]) == x) & (bits_of(&vertices[1][first]) == y) &
                          (bits_of(&vertices[2][first]) == z);
        found |= same & numbers;
        numbers += 4;
    }
    return static_cast<std::uint32_t>(found[0] | found[1] | found[2] | found[3]);
}

} // namespace

LeafBuilder::LeafBuilder() { // NOLINT(cppcoreguidelines-pro-type-member-init): y and z are read where x is right
    forget_from(0);
}

bool LeafBuilder::add(const Triangle& triangle) {
    if (m_count == leaf_width) {
        return false;
    }
    const std::uint32_t before = m_vertex_count;
    std::uint32_t packed = 0;
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
        const glm::vec3& position = triangle.corners[corner];
        std::uint32_t number = find(m_vertices, position);
        if (number == 0) {
            if (m_vertex_count == leaf_vertices) {
                forget_from(before);
                return false;
            }
            for (std::size_t axis = 0; axis < 3; ++axis) {
                m_vertices[axis][m_vertex_count] = position[static_cast<int>(axis)];
            }
            number = ++m_vertex_count;
        }
        packed |= (number - 1) << (4 * corner);
    }
    m_corners[m_count++] = static_cast<std::uint16_t>(packed);
    return true;
}

void LeafBuilder::forget_from(std::uint32_t vertex) {
    std::fill(m_vertices[0].begin() + vertex, m_vertices[0].end(), std::bit_cast<float>(no_coordinate));
    m_vertex_count = vertex;
}

void write_leaf(Leaf& leaf, const ListedTriangles& triangles, std::span<const std::uint32_t> ranks,
                const std::uint16_t* corners, std::uint32_t first_place) {
    leaf.corners.fill(0);
    leaf.first_place = first_place;
    leaf.vertex_count = 0;
    for (std::size_t lane = 0; lane < ranks.size(); ++lane) {
        const Triangle triangle = triangles[ranks[lane]];
        leaf.corners[lane] = corners[lane];
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            const auto vertex = static_cast<std::uint32_t>(vertex_of(leaf, lane, corner));
            for (std::size_t axis = 0; axis < 3; ++axis) {
                leaf.vertices[axis][vertex] = triangle.corners[corner][static_cast<int>(axis)];
            }
            leaf.vertex_count = std::max(leaf.vertex_count, vertex + 1);
        }
    }
    for (auto& row : leaf.vertices) {
        std::fill(row.begin() + leaf.vertex_count, row.end(), row[0]);
    }
}

} // namespace vkbake
