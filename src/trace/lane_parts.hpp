// What is kept of a tile's samples beside their sum.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "bvh/ray_block.hpp"
#include "trace/contrasts.hpp"

namespace vkbake {

/// Of each lane, what the estimate of its error is made from.
struct LaneParts {
    alignas(64) std::array<std::array<double, RayBlock::lanes>, part_count> luminance{}; ///< Σ L of the part's samples
    std::array<double, RayBlock::lanes> of_lights{};   ///< Σ L of what has rays of its own: lamps, the sky's peaks
    std::array<std::uint32_t, RayBlock::lanes> open{}; ///< rays along which light came
    std::array<std::uint32_t, RayBlock::lanes> blocked{};

    /// Adds the light of a sample of those that a texel has; `shift`: part_shift of their number. Those beyond the
    /// largest power of two are of no part.
    void add(std::size_t lane, std::uint32_t sample, unsigned shift, double light) {
        if (const std::uint32_t part = sample >> shift; part < part_count) {
            luminance[part][lane] += light;
        }
    }
};

} // namespace vkbake
