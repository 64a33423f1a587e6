// The directions of a block of rays, sixteen texels at a time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "bvh/ray_block.hpp"
#include "trace/cosine_strata.hpp"
#include "trace/thesis_directions.hpp"
#include "trace/tile_lanes.hpp"

namespace vkbake {

/// For each column and row of the cells, by its number with the digits reversed, each lane's part of the index of the
/// sample that lies there (CosineStrata).
struct StratumTables {
    struct Rows {
        std::array<std::uint32_t, RayBlock::lanes> index{};
        std::array<std::uint32_t, RayBlock::lanes> image{};
    };
    alignas(64) std::array<Rows, CosineStrata::most_cells> columns{};
    alignas(64) std::array<Rows, CosineStrata::most_cells> rows{};
};

/// Of a block's samples, [stratum][lane]: each one's number in its texel's sequence, and where it lies.
struct SampleIndices {
    using Rows = std::array<std::array<std::uint32_t, RayBlock::lanes>, RayBlock::strata>;

    alignas(64) Rows of{};
    alignas(64) Rows column{}; ///< of the square cut into 32 × 32 cells
    alignas(64) Rows row{};
};

/// Inverts the scrambles of a tile's texels.
void invert_scrambles(const CosineStrata& strata, const TileLanes& lanes, StratumTables& tables);

// The two below set `direction` and `active` of a block: unit vectors to about 2⁻²², in the lanes' frames; active are
// those of covered lanes that lie above the lane's geometric plane. The bits are the same on every machine.

/// Cosine-weighted directions, density cos θ / π, of some strata: the concentric map of Shirley and Chiu 1997 lifted to
/// the hemisphere (Malley). About the normal z ≥ 2⁻¹². Returns how many samples were asked for: those of covered lanes
/// whose index is in [strata.first(), strata.rays()); others are not active. Where `indices` is not null it is filled.
[[nodiscard]] std::uint32_t set_directions(const CosineStrata& strata, const StratumTables& tables,
                                           const TileLanes& lanes, const BlockStrata& numbers, RayBlock& block,
                                           SampleIndices* indices = nullptr);

/// The points of the samples of strata.block(number) in the square, before they become directions: x and y in (−1, 1)
/// stand in the first two axes of block.direction. `active` are all that were asked for.
void set_points(const CosineStrata& strata, const StratumTables& tables, const TileLanes& lanes, std::size_t number,
                RayBlock& block, SampleIndices* indices = nullptr);

/// From points that stand in the block as set_points leaves them, all in `active`: directions cosine-weighted as above
/// or, where `even`, of density 1 / 2π. Returns how many were active.
[[nodiscard]] std::uint32_t lift_points(bool even, const TileLanes& lanes, RayBlock& block);

/// The thesis's; all of the covered lanes' are asked for.
[[nodiscard]] std::uint32_t set_directions(const ThesisDirections& directions, const TileLanes& lanes,
                                           std::size_t number, RayBlock& block);

} // namespace vkbake
