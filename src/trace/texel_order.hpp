// In which order a map's texels are traced.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "vkbake/geometry_image.hpp"

namespace vkbake {

/// The covered texels (index y · width + x) in tiles of 4 × 4, so that texels traced one after the other lie near each
/// other and find the same triangles in the caches. Throws Error{bake_failed} where the image's arrays differ in size
/// or it names a triangle that is not below `triangle_count`.
[[nodiscard]] std::vector<std::uint32_t> covered_texels_in_tiles(const GeometryImage& geometry,
                                                                 std::size_t triangle_count);

} // namespace vkbake
