// Which texels of a map are traced together.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "bvh/ray_block.hpp"
#include "vkbake/geometry_image.hpp"

namespace vkbake {

/// Up to 16 covered texels that lie near each other and face alike: the lanes of a RayBlock.
struct TexelTile {
    std::array<std::uint32_t, RayBlock::lanes> texels{}; ///< y · width + x; the first `count` of them
    std::uint32_t count = 0;                             ///< ≥ 1
};

/// Every covered texel in one tile. A 4 × 4 square of the map is a tile as it stands where all of it is covered, faces
/// alike and hangs together; what is left over (small charts, their borders, creases) is gathered by place and normal
/// in the bake frame, wherever in the map it lies, so that small charts fill lanes too. Neighbouring tiles follow each
/// other. Throws Error{bake_failed} where the image's arrays differ in size or it names a triangle that is not below
/// `triangle_count`.
[[nodiscard]] std::vector<TexelTile> make_tiles(const GeometryImage& geometry, std::size_t triangle_count);

/// The share of lanes that hold a texel; 1 of no tiles.
[[nodiscard]] double occupancy(std::span<const TexelTile> tiles);

} // namespace vkbake
