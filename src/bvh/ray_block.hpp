// Rays that are asked together.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace vkbake {

/// Up to 16 origins (lanes) that look into up to 16 parts of the hemisphere (strata), one ray each. How much is won
/// over single rays depends on how alike they are: origins beside each other, directions of one stratum beside each
/// other, and the strata of a block beside each other. The answers do not depend on it.
struct RayBlock {
    static constexpr std::size_t lanes = 16;
    static constexpr std::size_t strata = 16;
    static constexpr std::size_t rays = lanes * strata;
    using LaneRow = std::array<float, lanes>;
    using LaneBits = std::uint16_t; ///< bit l: lane l

    alignas(64) std::array<LaneRow, 3> origin{};                        ///< [axis][lane]
    alignas(64) std::array<std::array<LaneRow, 3>, strata> direction{}; ///< [stratum][axis][lane]; as in Ray
    std::array<LaneBits, strata> active{};                              ///< the rays that are asked for
    float max_distance = std::numeric_limits<float>::infinity();        ///< as in Ray; the same for all
};

/// For each stratum the lanes whose ray meets something; a subset of RayBlock::active.
using BlockedRays = std::array<RayBlock::LaneBits, RayBlock::strata>;

} // namespace vkbake
