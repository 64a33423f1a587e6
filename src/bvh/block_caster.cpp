#include "bvh/block_caster.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <type_traits>

#include "base/simd_targets.hpp"
#include "bvh/each_ray.hpp"
#include "bvh/lane_sets.hpp"
#include "bvh/triangle_test.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bvh/block_caster.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace vkbake::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#include "bvh/row.inl"
// each needs those before it
#include "bvh/leaf_test.inl"

#include "bvh/block_rays.inl"

#include "bvh/beams.inl"

#include "bvh/block_traversal.inl"

void trace_block(const Hierarchy& hierarchy, const RayBlock& block, const IgnoredPlaces& ignored, const Box& bounds,
                 BlockScratch& scratch, BlockedRays& blocked) {
    BlockTraversal traversal(hierarchy, block, ignored, bounds, scratch);
    traversal.run();
    blocked = traversal.blocked();
}

} // namespace vkbake::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vkbake {

HWY_EXPORT(trace_block);

BlockedRays blocked_rays(const Hierarchy& hierarchy, const RayBlock& block, const IgnoredPlaces& ignored,
                         const Box& bounds, BlockScratch& scratch) {
    BlockedRays blocked{};
    if (block.max_distance > 0.0F && !hierarchy.nodes.empty()) {
        HWY_DYNAMIC_DISPATCH(trace_block)(hierarchy, block, ignored, bounds, scratch, blocked);
    }
    return blocked;
}

// What waits in the queue has been put there by at most one batch for each level of the hierarchy: a batch takes
// entries from the top and puts their children in their place, so what lies on the rest of an older batch has fewer
// levels under it than that. Each puts back at most ray_batch · node_width; below all lies what the beams have put
// there.
std::size_t queue_capacity(const Hierarchy& hierarchy) {
    return (hierarchy.depth + 1) * ray_batch * node_width + ray_batch + RayBlock::rays + node_width;
}

} // namespace vkbake
#endif
