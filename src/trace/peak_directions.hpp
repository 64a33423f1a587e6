// Directions to the sky's brightest places, a block at a time.
#pragma once

#include <array>
#include <cstdint>

#include "bvh/ray_block.hpp"
#include "trace/sky_peaks.hpp"

namespace vkbake {

/// [stratum] of a block's samples.
struct PeakSamples {
    /// [channel][lane]: cos θ times this is on average what the peaks add to E/π.
    alignas(64) std::array<std::array<RayBlock::LaneRow, 3>, RayBlock::strata> light{};
    alignas(64) std::array<std::array<std::uint32_t, RayBlock::lanes>, RayBlock::strata> peak{}; ///< SkyPeaks::peaks()
};

/// From points that stand in the block as set_points (trace/directions.hpp) leaves them: directions to the peaks, unit
/// to 2⁻²¹, in proportion to what they send. y chooses a row of the picture, x a peak in it, and what is left of
/// both a point of the peak's tent; so points beside each other give directions beside each other, and stratified ones
/// stratified ones. The same bits on every machine. Leaves `active` as it is.
void set_peak_directions(const SkyPeaks& peaks, RayBlock& block, PeakSamples& samples);

} // namespace vkbake
