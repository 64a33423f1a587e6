// The triangles an accelerator is built from.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "bvh/box.hpp"

namespace vkbake {

struct Triangle {
    std::array<glm::vec3, 3> corners;

    [[nodiscard]] Box bounds() const {
        Box box;
        for (const glm::vec3& corner : corners) {
            box.add(corner);
        }
        return box;
    }
};

/// Triangles in canonical order: a triangle's index here is its rank, so of equal distances the least index wins.
struct TriangleList {
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> numbers; ///< 1 a triangle: its number in the positions that were given
    Box bounds;
};

/// Orders the triangles and leaves out those whose corners lie on one line: rounding could make them block, and they
/// have no area to block with. Throws Error{bake_failed} where the order does not fit the positions.
[[nodiscard]] TriangleList list_triangles(std::span<const glm::vec3> positions,
                                          std::span<const std::uint32_t> canonical_order);

} // namespace vkbake
