// A floor for scenes that float.
#pragma once

#include "vkbake/scene.hpp"

namespace vkbake::bench {

/// Adds a square of two triangles, facing up, three times as wide as the scene and a thousandth of that width below its
/// lowest point.
void add_ground(Scene& scene);

} // namespace vkbake::bench
