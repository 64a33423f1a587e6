// The rays that are timed.
#pragma once

#include <cstddef>
#include <vector>

#include "bench/common/ray_source.hpp"

namespace vkbake::bench {

/// Some tiles of a source with their rays made beforehand.
struct RaySet {
    const RaySource* source = nullptr; ///< outlives the set
    std::vector<std::size_t> tiles;    ///< indices in the source
    std::size_t blocks_a_tile = 0;     ///< tile i has the blocks [i, i + 1) · blocks_a_tile
    std::vector<RayBlock> blocks;
    std::size_t ray_count = 0; ///< active rays
};

/// Every k-th tile, so that every part of the map has its share: about `rays` rays, or all if there are fewer.
[[nodiscard]] RaySet choose_rays(const RaySource& source, std::size_t rays);

/// About `rays` of a set's rays, each chosen by itself, one block a tile: for who is too slow to be asked all of them.
/// It can only be asked rays that were made beforehand.
[[nodiscard]] RaySet thinned(const RaySet& set, std::size_t rays);

[[nodiscard]] std::size_t count_active(const RayBlock& block);

} // namespace vkbake::bench
