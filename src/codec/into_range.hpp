// What image formats of fewer values than floats have do to a value.
#pragma once

#include <cstdint>

namespace vkbake {

/// NaN → 0, else the nearest value in [0, largest]. Counts the values that were outside.
[[nodiscard]] inline float into_range(float value, float largest, std::uint64_t& changed) {
    const bool inside = value >= 0.0F && value <= largest; // false for NaN
    changed += inside ? 0U : 1U;
    return inside ? value : (value > largest ? largest : 0.0F);
}

} // namespace vkbake
