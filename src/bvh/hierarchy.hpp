// The layout of the bounding-volume hierarchy while rays are traced.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "bvh/triangle_list.hpp"

namespace vkbake {

constexpr std::size_t node_width = 8; ///< children of a node
constexpr std::size_t leaf_width = 8; ///< most triangles in a leaf

/// Inner nodes on the way from the root to a leaf, at most; the builder keeps to it whatever the triangles are.
constexpr std::size_t greatest_depth = 64;
/// Each node on the way down leaves all of its children but one on the stack.
constexpr std::size_t stack_size = greatest_depth * (node_width - 1) + 1;

/// A child is the index of a node, or of a leaf with this bit set.
constexpr std::uint32_t leaf_bit = 0x80000000U;

/// The boxes of the children as rows. A slot without a child has an inverted, infinite box, which no ray passes.
struct alignas(64) WideNode {
    std::array<std::array<float, node_width>, 6> planes; ///< low x, y, z, high x, y, z
    std::array<std::uint32_t, node_width> children;
};

/// Corners as rows. A lane without a triangle is NaN, which no test lets pass.
struct alignas(64) Leaf {
    std::array<std::array<std::array<float, leaf_width>, 3>, 3> corners; ///< [corner][axis][lane]
    std::array<std::uint32_t, leaf_width> ranks;
};

struct Hierarchy {
    std::vector<WideNode> nodes; ///< the root first; none if there are no triangles
    std::vector<Leaf> leaves;
    std::size_t clusters = 0;
    std::size_t depth = 0;
};

/// Clusters at the top (see clusters.hpp), binned surface-area heuristic over the clusters and in each of them. The
/// result does not depend on `threads`. Throws Error{bad_input} for more than 2³⁰ triangles.
[[nodiscard]] Hierarchy build_hierarchy(const std::vector<Triangle>& triangles, int cluster_splits, int threads);

} // namespace vkbake
