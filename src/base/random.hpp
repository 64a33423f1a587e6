// Random numbers as a pure function of a key: no state, so no order of evaluation.
#pragma once

#include <cstdint>

namespace vkbake {

/// A bijection of 64-bit words in which every input bit changes about half of the output's bits: the finaliser of
/// SplitMix64 (Steele, Lea, Flood 2014) with Stafford's constants (variant 13).
[[nodiscard]] constexpr std::uint64_t mix64(std::uint64_t value) {
    value = (value ^ (value >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    value = (value ^ (value >> 27U)) * 0x94D049BB133111EBULL;
    return value ^ (value >> 31U);
}

} // namespace vkbake
