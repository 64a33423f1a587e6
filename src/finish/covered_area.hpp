// How much of a texel a triangle covers.
#pragma once

#include <array>

#include <glm/vec2.hpp>

namespace vkbake {

/// The area of the triangle in the square [0,1]², whichever way the triangle turns.
[[nodiscard]] double covered_area(const std::array<glm::dvec2, 3>& triangle);

} // namespace vkbake
