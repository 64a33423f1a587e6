// Which texels get more rays.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace vkbake {

inline constexpr std::uint32_t most_rays = 1U << 16U; ///< a texel, where the program chooses

/// What one more ray is worth in a tile is seen from this.
struct TileNeed {
    std::uint32_t texels = 0;
    std::uint32_t rays = 0; ///< a texel: a power of two
    double variance = 0.0;  ///< Σ σ² over the texels with so many rays
    double cost = 1.0;      ///< of one more sample
};

struct Allocation {
    std::vector<std::uint8_t> doublings; ///< of each tile's rays
    double variance = 0.0;               ///< Σ over all tiles thereafter, as foretold
    double work = 0.0;                   ///< that it takes: samples over all texels, each times its cost
};

/// What a sample takes away from a tile's variance for what it costs, on average over its next doubling.
[[nodiscard]] double gain_a_sample(const TileNeed& need, double ratio);

// Doubling a tile's rays takes (1 − ratio) of its variance away for texels · rays samples: the tiles in which a sample
// takes most away come first (Lagrange's condition, in powers of two). Both below give the cheapest such allocation.

/// That brings the variance down to `variance`, or as far as most_rays allows.
[[nodiscard]] Allocation allocate_for_variance(std::span<const TileNeed> needs, double ratio, double variance);

/// That takes at most `work`.
[[nodiscard]] Allocation allocate_for_work(std::span<const TileNeed> needs, double ratio, double work);

} // namespace vkbake
