#include "bvh/ray_caster.hpp"

#include <bit>

namespace vkbake {

BlockedRays RayCaster::blocked(const RayBlock& block, const IgnoredRanks& ignored, const Box& bounds,
                               BlockScratch& /*scratch*/) const {
    BlockedRays blocked{};
    for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
        const auto& [x, y, z] = block.direction[stratum];
        for (unsigned left = block.active[stratum]; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            PreparedRay ray({{block.origin[0][lane], block.origin[1][lane], block.origin[2][lane]},
                             {x[lane], y[lane], z[lane]},
                             block.max_distance,
                             no_triangle},
                            bounds);
            ray.ignored_rank = ignored[lane];
            if (ray.valid && occluded(ray)) {
                blocked[stratum] = static_cast<RayBlock::LaneBits>(blocked[stratum] | 1U << lane);
            }
        }
    }
    return blocked;
}

} // namespace vkbake
