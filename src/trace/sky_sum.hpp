// What arrives from the sky along the rays of a block that nothing blocks.
#pragma once

#include <array>
#include <cstddef>

#include <glm/vec3.hpp>

#include "bvh/ray_block.hpp"
#include "trace/lane_harmonics.hpp"
#include "trace/sky_lookup.hpp"

namespace vkbake {

/// Of each lane, Σ weight · radiance so far. In double: the rounding of a sum stays far below a float's for any number
/// of rays. What a sky has one value for, all three channels alike, is summed in the first channel alone.
struct LaneSums {
    alignas(64) std::array<std::array<double, RayBlock::lanes>, 3> channels{};
};

/// Of each ray of a block its sky's luminance (Rec. 709), as far as the sky is not of one colour: see luminance_scale.
using LuminanceRows = std::array<RayBlock::LaneRow, RayBlock::strata>;

/// Adds the rays that are set in `open`, which must be active, in the order of the strata; so a lane's sum depends on
/// its own rays only, to the bit, on every machine. The radiance is that of a formula in float: within 1e-6 of the
/// clear sky's; a picture is looked at within 2⁻²¹ of its width of the right place. A packed map's 16 strata are added
/// up in floats first, which 9 bits a texel fit. Where `luminance` is not null it is filled for the open rays; the
/// others' values mean nothing.
void add_sky(const SkyLookup& sky, const RayBlock& block, const BlockedRays& open,
             const std::array<double, RayBlock::strata>& weights, LaneSums& sums, LuminanceRows* luminance = nullptr);

/// The radiance along each ray that is set in `open`, of the same bits as add_sky() adds; 0 for the others.
void look_up_sky(const SkyLookup& sky, const RayBlock& block, const BlockedRays& open, RadianceRows& radiance);

/// What the values of LuminanceRows are to be multiplied with.
[[nodiscard]] double luminance_scale(const SkyLookup& sky);

/// One lane's sum in full.
[[nodiscard]] glm::dvec3 total(const SkyLookup& sky, const LaneSums& sums, std::size_t lane);

/// One look-up, for what is not worth a block. `direction`: unit.
[[nodiscard]] glm::vec3 radiance(const SkyLookup& sky, const glm::vec3& direction);

} // namespace vkbake
