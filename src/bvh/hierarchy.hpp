// The layout of the bounding-volume hierarchy while rays are traced.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "bvh/ray_block.hpp"
#include "bvh/triangle_list.hpp"
#include "bvh/uninitialised.hpp"

namespace vkbake {

constexpr std::size_t node_width = 16; ///< children of a node
constexpr std::size_t leaf_width = 16; ///< most triangles in a leaf; they have at most 16 vertices together

/// Inner nodes on the way from the root to a leaf, at most; the builder keeps to it whatever the triangles are.
constexpr std::size_t greatest_depth = 64;
/// Each node on the way down leaves all of its children but one on the stack.
constexpr std::size_t stack_size = greatest_depth * (node_width - 1) + 1;

/// A child is the index of a node, or a leaf: this bit, the number of its triangles less one, and its index.
constexpr std::uint32_t leaf_bit = 0x80000000U;
constexpr unsigned leaf_count_shift = 27;
constexpr std::uint32_t greatest_leaf_count = 1U << leaf_count_shift;

[[nodiscard]] constexpr std::uint32_t leaf_child(std::size_t index, std::size_t triangles) {
    return leaf_bit | static_cast<std::uint32_t>(triangles - 1) << leaf_count_shift | static_cast<std::uint32_t>(index);
}
[[nodiscard]] constexpr std::uint32_t leaf_index(std::uint32_t child) { return child & (greatest_leaf_count - 1); }
[[nodiscard]] constexpr std::size_t triangles_of(std::uint32_t child) {
    return (child >> leaf_count_shift & (leaf_width - 1)) + 1;
}

/// The boxes of the children as rows. A slot without a child has an inverted box, beyond all that is finite and
/// small: which no ray and no beam passes, and which gives no infinity to be subtracted.
constexpr float empty_low = 0x1p100F;
constexpr float empty_high = -0x1p100F;
struct alignas(64) WideNode {
    std::array<std::array<float, node_width>, 6> planes; ///< low x, y, z, high x, y, z
    std::array<std::uint32_t, node_width> children;
};

constexpr std::size_t leaf_vertices = 16; ///< most vertices in a leaf

/// Neighbouring triangles share vertices, so these stand once: half the memory, a third of the work.
struct alignas(64) Leaf {
    std::array<std::array<float, leaf_vertices>, 3> vertices; ///< [axis][vertex]; those not used are as the first
    /// For each triangle its corners' vertices, four bits each, the first corner lowest. What is beyond the triangles'
    /// number (see above) is 0.
    std::array<std::uint16_t, leaf_width> corners;
    std::uint32_t first_place; ///< of its triangles in Hierarchy::ranks, where they stand one after the other
    std::uint32_t vertex_count;
};
static_assert(sizeof(Leaf) == 256);

[[nodiscard]] constexpr std::size_t vertex_of(const Leaf& leaf, std::size_t triangle, std::size_t corner) {
    return static_cast<std::size_t>(leaf.corners[triangle]) >> (4 * corner) & 15U;
}

[[nodiscard]] inline Triangle triangle_in(const Leaf& leaf, std::size_t lane) {
    Triangle triangle{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::size_t vertex = vertex_of(leaf, lane, corner);
        triangle.corners[corner] = {leaf.vertices[0][vertex], leaf.vertices[1][vertex], leaf.vertices[2][vertex]};
    }
    return triangle;
}

/// The leaf's triangles, a bit each, but for the one at this place if it is among them.
[[nodiscard]] inline unsigned triangles_but(const Leaf& leaf, std::uint32_t child, std::uint32_t place) {
    const std::uint32_t lane = place - leaf.first_place;
    const unsigned all = (2U << (triangles_of(child) - 1)) - 1;
    return all & ~(static_cast<unsigned>(lane < leaf_width) << (lane % leaf_width));
}

struct Hierarchy {
    UninitialisedVector<WideNode> nodes; ///< the root first; none if there are no triangles
    UninitialisedVector<Leaf> leaves;
    UninitialisedVector<std::uint32_t> ranks;  ///< of the triangles by place: those of a leaf stand together
    UninitialisedVector<std::uint32_t> places; ///< its inverse: by rank
    std::size_t clusters = 0;
    std::size_t depth = 0;
};

/// `rank` may be no_triangle, whose place is that of none.
[[nodiscard]] inline std::uint32_t place_of(const Hierarchy& hierarchy, std::uint32_t rank) {
    return rank < hierarchy.places.size() ? hierarchy.places[rank] : no_triangle;
}

/// Clusters at the top (see clusters.hpp), binned surface-area heuristic over the clusters and in each of them. The
/// result does not depend on `threads`. Throws Error{bad_input} for more than 2³⁰ triangles.
[[nodiscard]] Hierarchy build_hierarchy(const ListedTriangles& triangles, int cluster_splits, int threads);

} // namespace vkbake
