// The geometry image computed on the CPU, for tests: what the pass must give to the bit.
#pragma once

#include <cstdint>

#include "vkbake/atlas.hpp"
#include "vkbake/geometry_image.hpp"
#include "vkbake/surface.hpp"

namespace vkbake {

/// The same result as draw_geometry_image on a device that rounds correctly. Written apart from the shader: whole
/// numbers decide what is covered, and triangles compete in a loop instead of a depth test. One thread, time by boxes'
/// texels.
[[nodiscard]] GeometryImage reference_geometry_image(const Surface& surface, const Atlas& atlas, std::uint32_t page);

} // namespace vkbake
