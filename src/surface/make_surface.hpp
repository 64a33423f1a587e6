// Scene → triangles in the bake frame.
#pragma once

#include "vkbake/scene.hpp"
#include "vkbake/surface.hpp"

namespace vkbake {

/// Throws Error{bad_input} where an index, position or transform is out of range or not finite.
[[nodiscard]] Surface make_surface(const Scene& scene);

} // namespace vkbake
