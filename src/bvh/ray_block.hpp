// Rays that are asked together.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace vkbake {

/// In place of a triangle's number where there is none.
inline constexpr std::uint32_t no_triangle = 0xFFFFFFFFU;

/// Up to 16 origins (lanes) that look into up to 16 parts of the hemisphere (strata), one ray each. How much is won
/// over single rays depends on how alike they are: origins beside each other, directions of one stratum beside each
/// other, and the strata of a block beside each other. The answers do not depend on it.
struct RayBlock {
    static constexpr std::size_t lanes = 16;
    static constexpr std::size_t strata = 16;
    static constexpr std::size_t rays = lanes * strata;
    using LaneRow = std::array<float, lanes>;
    using LaneBits = std::uint16_t; ///< bit l: lane l

    alignas(64) std::array<LaneRow, 3> origin{};                            ///< [axis][lane]
    std::array<std::uint32_t, lanes> ignored_triangle = filled_with_none(); ///< as in Ray; usually the one a ray leaves
    alignas(64) std::array<std::array<LaneRow, 3>, strata> direction{};     ///< [stratum][axis][lane]; as in Ray
    std::array<LaneBits, strata> active{};                                  ///< the rays that are asked for
    float max_distance = std::numeric_limits<float>::infinity();            ///< as in Ray; the same for all

    static constexpr std::array<std::uint32_t, lanes> filled_with_none() {
        std::array<std::uint32_t, lanes> none{};
        none.fill(no_triangle);
        return none;
    }
};

/// For each stratum the lanes whose ray meets something; a subset of RayBlock::active.
using BlockedRays = std::array<RayBlock::LaneBits, RayBlock::strata>;

} // namespace vkbake
