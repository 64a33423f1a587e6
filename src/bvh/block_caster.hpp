// Blocks of rays through the hierarchy.
#pragma once

#include <cstddef>

#include "bvh/hierarchy.hpp"
#include "bvh/ray_caster.hpp"

namespace vkbake {

// Chosen by measurement, see docs/tracing.md.
inline constexpr std::size_t rays_for_queue = 64; ///< so few rays that pass a box go on alone
inline constexpr std::size_t ray_batch = 32;
inline constexpr std::size_t leaf_batch = 16;

/// For each lane of a block the place of the triangle that its rays never meet.
using IgnoredPlaces = std::array<std::uint32_t, RayBlock::lanes>;

/// For each active ray of the block whether it meets a triangle, as PreparedRay and test_watertight have it.
/// `bounds` holds all triangles; `scratch` has the capacity below.
[[nodiscard]] BlockedRays blocked_rays(const Hierarchy& hierarchy, const RayBlock& block, const IgnoredPlaces& ignored,
                                       const Box& bounds, BlockScratch& scratch);

/// The entries that a queue of rays can ever hold.
[[nodiscard]] std::size_t queue_capacity(const Hierarchy& hierarchy);

} // namespace vkbake
