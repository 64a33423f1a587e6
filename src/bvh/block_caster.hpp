// Blocks of rays through the hierarchy.
#pragma once

#include <cstddef>

#include "bvh/hierarchy.hpp"
#include "bvh/ray_caster.hpp"

namespace vkbake {

// Chosen by measurement, see docs/tracing.md.
inline constexpr std::size_t strata_for_rays = 6;  ///< with so few strata left in a box their rays are tested each
inline constexpr std::size_t rays_for_queue = 256; ///< so few rays go on alone
inline constexpr std::size_t packet_gain = 2;      ///< with fewer triangles than so many a ray they are tested together
inline constexpr std::size_t ray_batch = 32;
inline constexpr std::size_t leaf_batch = 16;

/// For each active ray of the block whether it meets a triangle, as PreparedRay and test_watertight have it.
/// `bounds` holds all triangles; `scratch` has the capacity below.
[[nodiscard]] BlockedRays blocked_rays(const Hierarchy& hierarchy, const RayBlock& block, const IgnoredRanks& ignored,
                                       const Box& bounds, BlockScratch& scratch);

/// The entries that a queue of rays can ever hold.
[[nodiscard]] std::size_t queue_capacity(const Hierarchy& hierarchy);

} // namespace vkbake
