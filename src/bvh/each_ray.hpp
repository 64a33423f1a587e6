// The rays of a block, one by one.
#pragma once

#include <bit>
#include <cstddef>

#include "bvh/accelerator.hpp"

namespace vkbake {

[[nodiscard]] inline Ray ray_of(const RayBlock& block, std::size_t stratum, std::size_t lane) {
    const auto& [x, y, z] = block.direction[stratum];
    return {{block.origin[0][lane], block.origin[1][lane], block.origin[2][lane]},
            {x[lane], y[lane], z[lane]},
            block.max_distance,
            block.ignored_triangle[lane]};
}

/// `met(ray, lane)` is asked of each active ray.
template<typename Met>
[[nodiscard]] BlockedRays ask_one_by_one(const RayBlock& block, const Met& met) {
    BlockedRays blocked{};
    for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
        unsigned bits = 0;
        for (unsigned left = block.active[stratum]; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            bits |= met(ray_of(block, stratum, lane), lane) ? 1U << lane : 0U;
        }
        blocked[stratum] = static_cast<RayBlock::LaneBits>(bits);
    }
    return blocked;
}

} // namespace vkbake
