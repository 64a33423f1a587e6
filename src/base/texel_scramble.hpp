// Which points of the square each texel of a map samples, so that neighbours' errors cancel.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/random.hpp"
#include "base/sampling_sobol.hpp"

namespace vkbake {

/// Texels of an aligned square of 4 × 4 have one key, squares have keys that are independent of each other. A square's
/// texels differ by a digital shift each. Under a nested scramble a shifted sequence is as good as any, so a texel by
/// itself cannot tell; but shifts can be chosen so that where one texel has a sample too many on one side of an
/// occluder's edge, its neighbours have one too few: they all see nearly the same edge. The mean over several texels
/// (a renderer's bilinear filter, a mip level, the denoiser) then errs less than that of independent ones, and what
/// error is left looks finer than theirs, "blue". That sequences of neighbours be parts of one is the thought of Ahmed
/// and Wonka 2020 ("Screen-Space Blue-Noise Diffusion of Monte Carlo Sampling Error via Hierarchical Ordering of
/// Pixels"); theirs fixes the number of samples beforehand, these shifts serve every power of two.
///
/// Bit b of a texel's place along Morton's curve through its square adds square_shifts[b] (the lowest is x's or, in
/// every other square by chance, y's: else what neighbours to the right have in common would show as streaks). What two
/// texels have in common depends on the exclusive or of their places alone. Found by tools/accuracy/search_shifts.cpp.
constexpr unsigned square_bits = 2;
constexpr std::array<DigitalShift, std::size_t{2} * square_bits> square_shifts{{
    {0x006B5U, 0x33D68U},
    {0x05961U, 0x002FBU},
    {0x00072U, 0x33DADU},
    {0x00CC7U, 0x33E0AU},
}};

/// Of texel (x, y): depends on the seed and the texel's place in its map, and on nothing else (no index of a triangle,
/// node or map), so that a scene that is cut up or ordered otherwise keeps its bits.
[[nodiscard]] constexpr SobolScramble texel_scramble(std::uint64_t seed, std::uint32_t x, std::uint32_t y) {
    SobolScramble scramble;
    const auto square = (static_cast<std::uint64_t>(x >> square_bits) << 32U) | (y >> square_bits);
    scramble.key = mix64(mix64(seed + 0x9E3779B97F4A7C15ULL) ^ square);
    const bool turned = (mix64(scramble.key) & 1U) != 0;
    for (unsigned bit = 0; bit < square_bits; ++bit) {
        if ((((turned ? y : x) >> bit) & 1U) != 0) {
            scramble.shift ^= square_shifts[std::size_t{2} * bit];
        }
        if ((((turned ? x : y) >> bit) & 1U) != 0) {
            scramble.shift ^= square_shifts[std::size_t{2} * bit + 1];
        }
    }
    return scramble;
}

} // namespace vkbake
