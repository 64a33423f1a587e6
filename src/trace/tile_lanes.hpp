// What a tile's lanes have for all their rays: where these start, and about which normal.
#pragma once

#include <array>
#include <cstdint>

#include "base/sampling.hpp"
#include "bvh/ray_block.hpp"
#include "trace/lane_scrambles.hpp"
#include "trace/texel_tiles.hpp"
#include "vkbake/geometry_image.hpp"
#include "vkbake/settings.hpp"
#include "vkbake/surface.hpp"

namespace vkbake {

/// Lanes without a texel hold what lane 0 holds, so that they widen no beam; `covered` tells them.
struct TileLanes {
    using Rows = std::array<RayBlock::LaneRow, 3>; ///< [axis][lane]

    alignas(64) Rows origin{};
    alignas(64) Rows tangent{};
    alignas(64) Rows bitangent{};
    alignas(64) Rows normal{};                             ///< the frame's: the shading normal
    alignas(64) Rows geometric_normal{};                   ///< below its plane nothing is traced
    std::array<std::uint32_t, RayBlock::lanes> triangle{}; ///< that the texel lies on
    LaneScrambles scrambles;
    RayBlock::LaneBits covered = 0;
};

/// Puts a tile's texels into lanes. A triangle without area has no geometric normal; its texels' shading normals are
/// all there is to go by.
void set_lanes(const Surface& surface, const GeometryImage& geometry, const Settings& settings, const TexelTile& tile,
               TileLanes& lanes);

} // namespace vkbake
