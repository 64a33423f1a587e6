// Orders that depend on geometry alone.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "vkbake/surface.hpp"

namespace vkbake {

/// Which corner comes first when a triangle's corners are rotated so that the sequence of positions, then normals, is
/// lexicographically least.
[[nodiscard]] int first_corner(const std::array<glm::vec3, 3>& positions, const std::array<glm::vec3, 3>& normals);

/// Surface::canonical_order from positions and normals. Equal triangles keep their order.
[[nodiscard]] std::vector<std::uint32_t> canonical_order(const std::vector<glm::vec3>& positions,
                                                         const std::vector<glm::vec3>& normals);

} // namespace vkbake
