#include "base/sampling_sobol.hpp"

#include <array>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "base/random.hpp"
#include "chi_squared.hpp"

namespace vkbake {
namespace {

TEST(Sobol, DimensionOneFollowsTheRecurrenceOfItsDirectionNumbers) {
    // Sobol' 1967 with the primitive polynomial x + 1: v₀ = 1/2, vₖ₊₁ = vₖ xor vₖ / 2.
    for (const std::uint32_t index : {0U, 1U, 2U, 3U, 77U, 1023U, 65535U, 0x12345678U, 0xFFFFFFFFU}) {
        std::uint32_t expected = 0;
        std::uint32_t direction = 0x80000000U;
        for (unsigned bit = 0; bit < 32; ++bit) {
            expected ^= ((index >> bit) & 1U) != 0 ? direction : 0U;
            direction ^= direction >> 1U;
        }
        EXPECT_EQ(reverse_bits(sobol_dimension_1_reversed(index)), expected) << index;
    }
}

TEST(Sobol, EveryElementaryIntervalHoldsOnePointUnderEveryScramble) {
    for (std::uint64_t texel = 0; texel < 32; ++texel) {
        const ScrambledSobol points(mix64(texel + 1));
        for (unsigned m = 0; m <= 10; ++m) {
            const std::uint32_t size = 1U << m;
            for (const std::uint32_t first : {0U, size, 5U * size}) {
                for (unsigned across = 0; across <= m; ++across) {
                    std::vector<int> held(size, 0);
                    for (std::uint32_t i = first; i < first + size; ++i) {
                        const SquarePoint point = points.point(i);
                        const std::uint32_t column = point.x >> (24U - across);
                        const std::uint32_t row = point.y >> (24U - (m - across));
                        ++held[(column << (m - across)) | row];
                    }
                    ASSERT_EQ(held, std::vector<int>(size, 1)) << "2^" << m << " points from " << first;
                }
            }
        }
    }
}

/// Owen's scramble permutes each digit by a rule that depends on the digits above it alone: what agreed in its first
/// digits agrees in them afterwards, and what first differed in digit k still does.
TEST(Sobol, ScrambleIsNested) {
    for (std::uint32_t i = 0; i < 2000; ++i) {
        const std::uint32_t seed = static_cast<std::uint32_t>(mix64(i));
        const std::uint32_t word = static_cast<std::uint32_t>(mix64(i + 1000000U));
        const unsigned digit = i % 32U;
        const std::uint32_t other = word ^ (1U << digit) ^ (digit < 31U ? (0xFFFFFFFEU << digit) & 0x5A5A5A5AU : 0U);
        const std::uint32_t changed = nested_scramble_reversed(word, seed) ^ nested_scramble_reversed(other, seed);
        EXPECT_EQ(changed & ((2U << digit) - 1U), 1U << digit) << "digit " << digit;
    }
}

TEST(Sobol, ScramblesDependOnSeedAndTexelAndNothingElse) {
    const auto first_points = [](std::uint64_t seed, std::uint32_t x, std::uint32_t y) {
        const ScrambledSobol points(texel_key(seed, x, y));
        std::array<std::uint32_t, 8> values{};
        for (std::uint32_t i = 0; i < 4; ++i) {
            values[2 * i] = points.point(i).x;
            values[2 * i + 1] = points.point(i).y;
        }
        return values;
    };
    const auto here = first_points(7, 12, 34);
    EXPECT_EQ(here, first_points(7, 12, 34));
    EXPECT_NE(here, first_points(8, 12, 34));
    EXPECT_NE(here, first_points(7, 13, 34));
    EXPECT_NE(here, first_points(7, 12, 35));
    EXPECT_NE(here, first_points(7, 34, 12));
}

TEST(Sobol, NeighbouringTexelsAreIndependent) {
    // Two texels' points of one number in 4 × 4 cells each: 256 cells of pairs, 64 pairs expected in each.
    struct Step {
        std::uint32_t x, y, index;
    };
    constexpr std::array<Step, 6> steps{{{1, 0, 0}, {0, 1, 0}, {1, 0, 5}, {0, 1, 5}, {1, 1, 255}, {8, 0, 255}}};
    for (const Step& step : steps) {
        std::vector<std::uint32_t> counts(256, 0);
        for (std::uint32_t y = 0; y < 128; ++y) {
            for (std::uint32_t x = 0; x < 128; ++x) {
                // Pairs lie 16 texels apart: no texel serves twice.
                const std::uint32_t left = 16 * x;
                const std::uint32_t top = 16 * y;
                const SquarePoint a = ScrambledSobol(texel_key(0, left, top)).point(step.index);
                const SquarePoint b = ScrambledSobol(texel_key(0, left + step.x, top + step.y)).point(step.index);
                ++counts[((a.x >> 22U) << 6U) | ((a.y >> 22U) << 4U) | ((b.x >> 22U) << 2U) | (b.y >> 22U)];
            }
        }
        EXPECT_GT(test::uniform_p_value(counts), test::corrected_level(0.01, static_cast<int>(steps.size())))
            << "step " << step.x << ", " << step.y << " sample " << step.index;
    }
}

} // namespace
} // namespace vkbake
