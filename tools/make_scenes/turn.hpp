// Sine and cosine whose bits are the same with every C library: the checked-in scenes are compared to the byte.
#pragma once

#include <glm/vec2.hpp>

namespace vkbake::scenes {

/// (cos, sin) of an angle given in whole turns; any finite value. The error is below 1e-14.
[[nodiscard]] glm::dvec2 on_circle(double turns);

} // namespace vkbake::scenes
