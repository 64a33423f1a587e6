#include "bvh/ray_caster.hpp"

#include "bvh/each_ray.hpp"

namespace vkbake {

BlockedRays RayCaster::blocked(const RayBlock& block, const IgnoredRanks& ignored, const Box& bounds,
                               BlockScratch& /*scratch*/) const {
    return ask_one_by_one(block, [&](const Ray& ray, std::size_t lane) {
        PreparedRay prepared(ray, bounds);
        prepared.ignored_rank = ignored[lane];
        return prepared.valid && occluded(prepared);
    });
}

} // namespace vkbake
