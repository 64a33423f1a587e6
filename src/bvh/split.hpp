// How one set of boxes is cut in two.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "bvh/box.hpp"

namespace vkbake {

/// What a hierarchy is built over: a triangle, or a cluster of `weight` triangles.
struct BuildItem {
    Box box;
    std::uint32_t index = 0;
    std::uint32_t weight = 1;
};

/// Reorders the items (at least two) and returns how many belong to the first half, neither none nor all. Binned
/// surface-area heuristic (Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007); the median
/// where that finds no cut, or where fewer than `depth_left` further levels might not do: `items.size() ≤ 2^depth_left`
/// holds for both halves with one level less.
[[nodiscard]] std::size_t split(std::span<BuildItem> items, std::size_t depth_left);

} // namespace vkbake
