// The first two dimensions of Sobol's sequence under a nested uniform (Owen 1995) scramble.
#pragma once

#include <cstdint>

#include "base/sampling.hpp"

namespace vkbake {

[[nodiscard]] constexpr std::uint32_t reverse_bits(std::uint32_t word) {
    word = ((word & 0x55555555U) << 1U) | ((word >> 1U) & 0x55555555U);
    word = ((word & 0x33333333U) << 2U) | ((word >> 2U) & 0x33333333U);
    word = ((word & 0x0F0F0F0FU) << 4U) | ((word >> 4U) & 0x0F0F0F0FU);
    word = ((word & 0x00FF00FFU) << 8U) | ((word >> 8U) & 0x00FF00FFU);
    return (word << 16U) | (word >> 16U);
}

/// Dimension 1 of Sobol's sequence with its digits reversed: bit j of the result is the digit of weight 2⁻⁽ʲ⁺¹⁾.
/// Its generator matrix is Pascal's triangle modulo 2, whose entry (j, k) is 1 where j's bits are among k's (Lucas), so
/// the product is five butterflies over the bits of the bit's number. (Dimension 0, reversed likewise, is `index`
/// itself.)
[[nodiscard]] constexpr std::uint32_t sobol_dimension_1_reversed(std::uint32_t index) {
    index ^= (index & 0xAAAAAAAAU) >> 1U;
    index ^= (index & 0xCCCCCCCCU) >> 2U;
    index ^= (index & 0xF0F0F0F0U) >> 4U;
    index ^= (index & 0xFF00FF00U) >> 8U;
    return index ^ ((index & 0xFFFF0000U) >> 16U);
}

/// A permutation of 32-bit words in which a bit is changed only by the bits below it: on reversed digits, a nested
/// uniform scramble. The idea is Laine and Karras's (2011, "Stratified Sampling for Stochastic Transparency"), its use
/// Burley's (2020, "Practical Hash-based Owen Scrambling"); the constants are those of Vegdahl 2021 ("Building a Better
/// LK Hash"), chosen for less bias than the first ones.
[[nodiscard]] constexpr std::uint32_t nested_scramble_reversed(std::uint32_t word, std::uint32_t seed) {
    word ^= word * 0x3D20ADEAU;
    word += seed;
    word *= (seed >> 16U) | 1U;
    word ^= word * 0x05526C56U;
    word ^= word * 0x53A22864U;
    return word;
}

/// What is added, exclusive or, to all points of a sequence before it is scrambled: their coordinates' digits,
/// reversed.
struct DigitalShift {
    std::uint32_t x = 0;
    std::uint32_t y = 0;

    constexpr DigitalShift& operator^=(const DigitalShift& other) {
        x ^= other.x;
        y ^= other.y;
        return *this;
    }
};

/// What makes points of one's own out of the sequence. Keys that are unlike give independent scrambles; take them from
/// a mixing function (base/random.hpp).
struct SobolScramble {
    std::uint64_t key = 0;
    DigitalShift shift;
};

/// One texel's points. Any first 2^m of them, and any aligned block of 2^m, hold exactly one point in each of the
/// elementary intervals of area 2⁻ᵐ (a (0, 2)-sequence in base 2); each single point is uniform over keys.
class ScrambledSobol {
public:
    explicit constexpr ScrambledSobol(const SobolScramble& scramble)
        : m_seed_x(static_cast<std::uint32_t>(scramble.key >> 32U)), m_seed_y(static_cast<std::uint32_t>(scramble.key)),
          m_shift(scramble.shift) {}

    [[nodiscard]] constexpr SquarePoint point(std::uint32_t index) const {
        const std::uint32_t x = index ^ m_shift.x;
        const std::uint32_t y = sobol_dimension_1_reversed(index) ^ m_shift.y;
        return {reverse_bits(nested_scramble_reversed(x, m_seed_x)) >> 8U,
                reverse_bits(nested_scramble_reversed(y, m_seed_y)) >> 8U};
    }

private:
    std::uint32_t m_seed_x;
    std::uint32_t m_seed_y;
    DigitalShift m_shift;
};

} // namespace vkbake
