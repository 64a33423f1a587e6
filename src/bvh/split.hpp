// How one set of boxes is cut in two.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "bvh/box.hpp"

namespace vkbake {

/// What a hierarchy is built over: a triangle, or a cluster of `weight` triangles. Not initialised by itself: there
/// are as many as triangles, and all are written.
struct alignas(16) BuildItem {
    glm::vec3 low;
    glm::vec3 high;
    std::uint32_t index;  ///< below 2³⁰
    std::uint32_t weight; ///< the weights of all together below 2³¹

    [[nodiscard]] Box box() const { return {low, high}; }
};

/// The first half of the items, neither none nor all of them, and the tight boxes of both.
struct Halves {
    std::size_t first_count = 0;
    Box first;
    Box second;
};

/// Reorders the items (at least two) so that the first half stands first. Binned surface-area heuristic (Wald, "On fast
/// Construction of SAH-based Bounding Volume Hierarchies", 2007); the median where that finds no cut, or where fewer
/// than `depth_left` further levels might not do: `items.size() ≤ 2^depth_left` holds for both halves with one level
/// less. The order that results depends on the given one only.
[[nodiscard]] Halves split(std::span<BuildItem> items, std::size_t depth_left);

} // namespace vkbake
