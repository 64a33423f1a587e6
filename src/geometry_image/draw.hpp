// The graphics pass that writes positions and normals into UV space.
#pragma once

#include <cstdint>

#include "vkbake/atlas.hpp"
#include "vkbake/geometry_image.hpp"
#include "vkbake/surface.hpp"

namespace vkbake {

namespace gpu {
class Context;
}

struct DrawSettings {
    int tile = 2048; ///< side of the largest attachment, texels; the result does not depend on it
};

/// Every closed texel square that a triangle meets is covered. A triangle that holds the centre wins over one that does
/// not, then the nearest sample point, then the canonical order.
[[nodiscard]] GeometryImage draw_geometry_image(gpu::Context& context, const Surface& surface, const Atlas& atlas,
                                                std::uint32_t page, const DrawSettings& settings = {});

} // namespace vkbake
