// How bright a linear colour is.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace vkbake {

/// Of red, green and blue (ITU-R BT.709).
inline constexpr glm::dvec3 luminance_weights{0.2126, 0.7152, 0.0722};

[[nodiscard]] inline double luminance(const glm::dvec3& color) { return glm::dot(color, luminance_weights); }

} // namespace vkbake
