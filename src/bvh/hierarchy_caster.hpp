// The default accelerator: a wide hierarchy, one ray against all children of a node, or all triangles of a leaf, at
// once.
#pragma once

#include "bvh/hierarchy.hpp"
#include "bvh/ray_caster.hpp"

namespace vkbake {

class HierarchyCaster final : public RayCaster {
public:
    explicit HierarchyCaster(Hierarchy hierarchy);

    [[nodiscard]] bool occluded(const PreparedRay& ray) const override;
    [[nodiscard]] NearestHit nearest(const PreparedRay& ray) const override;
    [[nodiscard]] bool filter(const PreparedRay& ray, const RankedFilter& filter) const override;
    [[nodiscard]] BlockedRays blocked(const RayBlock& block, const IgnoredRanks& ignored, const Box& bounds,
                                      BlockScratch& scratch) const override;
    [[nodiscard]] BlockScratch make_scratch() const override;
    [[nodiscard]] AcceleratorStatistics statistics() const override;

private:
    Hierarchy m_hierarchy;
};

} // namespace vkbake
