// The geometry image computed on the CPU: whole for tests, which hold the pass to it, in part where there is no device.
#pragma once

#include <cstdint>
#include <functional>

#include "vkbake/atlas.hpp"
#include "vkbake/geometry_image.hpp"
#include "vkbake/surface.hpp"

namespace vkbake {

/// The same result as draw_geometry_image on a device that rounds correctly. Written apart from the shader: whole
/// numbers decide what is covered, and triangles compete in a loop instead of a depth test. One thread, time by boxes'
/// texels.
[[nodiscard]] GeometryImage reference_geometry_image(const Surface& surface, const Atlas& atlas, std::uint32_t page);

/// Of those squares of side × side texels that `takes` is true for (x, y: 0, 1 … of the squares of a page), which it is
/// asked of row by row: one beside the other in one row of squares. `side` is ≥ 1.
[[nodiscard]] GeometryImage sampled_geometry_image(const Surface& surface, const Atlas& atlas, std::uint32_t page,
                                                   int side, const std::function<bool(int x, int y)>& takes);

} // namespace vkbake
