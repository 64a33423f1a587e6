#include "base/sampling_sobol.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "base/random.hpp"
#include "base/texel_scramble.hpp"
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
    for (std::uint32_t texel = 0; texel < 32; ++texel) {
        const ScrambledSobol points(texel_scramble(3, texel, 5 * texel));
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
        const ScrambledSobol points(texel_scramble(seed, x, y));
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

TEST(Sobol, TexelsOfUnlikeSquaresAreIndependent) {
    // Two texels' points of one number in 4 × 4 cells each: 256 cells of pairs, 64 pairs expected in each.
    struct Step {
        std::uint32_t x, y, index;
    };
    constexpr std::array<Step, 6> steps{{{1, 0, 0}, {0, 1, 0}, {1, 0, 5}, {0, 1, 5}, {1, 1, 255}, {8, 0, 255}}};
    for (const Step& step : steps) {
        std::vector<std::uint32_t> counts(256, 0);
        for (std::uint32_t y = 0; y < 128; ++y) {
            for (std::uint32_t x = 0; x < 128; ++x) {
                // A square's last texel; pairs lie 16 texels apart: no texel serves twice.
                const std::uint32_t left = 16 * x + 3;
                const std::uint32_t top = 16 * y + 3;
                const SquarePoint a = ScrambledSobol(texel_scramble(0, left, top)).point(step.index);
                const SquarePoint b = ScrambledSobol(texel_scramble(0, left + step.x, top + step.y)).point(step.index);
                ++counts[((a.x >> 22U) << 6U) | ((a.y >> 22U) << 4U) | ((b.x >> 22U) << 2U) | (b.y >> 22U)];
            }
        }
        EXPECT_GT(test::uniform_p_value(counts), test::corrected_level(0.01, static_cast<int>(steps.size())))
            << "step " << step.x << ", " << step.y << " sample " << step.index;
    }
}

/// The share of the unit square in which cos · (x − ½) + sin · (y − ½) < offset: the cut cone above a line, as the sum
/// of the squares of the corners' depths with the signs of an inclusion and exclusion.
double area_before_edge(double cosine, double sine, double offset) {
    const double a = std::abs(cosine);
    const double b = std::abs(sine);
    const double depth = offset + (a + b) / 2.0;
    const auto squared = [](double some) { return some > 0.0 ? some * some : 0.0; };
    return (squared(depth) - squared(depth - a) - squared(depth - b) + squared(depth - a - b)) / (2.0 * a * b);
}

constexpr std::uint32_t square_side = 1U << square_bits;
using SquareErrors = std::array<std::array<double, square_side>, square_side>;

/// Of a square's texels that all see the same edge, by `rays` samples each.
SquareErrors errors_at_edge(std::uint32_t square, std::uint32_t rays) {
    const auto random = [&](std::uint64_t salt) {
        return static_cast<double>(mix64(mix64(square) ^ salt) >> 11U) * 0x1p-53;
    };
    const double angle = 6.283185307179586 * random(1);
    const double cosine = std::cos(angle);
    const double sine = std::sin(angle);
    const double offset = (random(2) - 0.5) * (std::abs(cosine) + std::abs(sine));
    SquareErrors errors{};
    for (std::uint32_t y = 0; y < square_side; ++y) {
        for (std::uint32_t x = 0; x < square_side; ++x) {
            const ScrambledSobol points(texel_scramble(11, square_side * square + x, square_side * square + y));
            std::uint32_t count = 0;
            for (std::uint32_t i = 0; i < rays; ++i) {
                const SquarePoint point = points.point(i);
                const double depth =
                    cosine * ((point.x + 0.5) * 0x1p-24 - 0.5) + sine * ((point.y + 0.5) * 0x1p-24 - 0.5);
                count += depth < offset ? 1 : 0;
            }
            errors[y][x] = static_cast<double>(count) / rays - area_before_edge(cosine, sine, offset);
        }
    }
    return errors;
}

/// The mean square of the errors of means over aligned blocks of side × side texels.
double mean_square(const SquareErrors& errors, std::size_t side) {
    double squares = 0.0;
    for (std::size_t top = 0; top < square_side; top += side) {
        for (std::size_t left = 0; left < square_side; left += side) {
            double sum = 0.0;
            for (std::size_t i = 0; i < side * side; ++i) {
                sum += errors[top + i / side][left + i % side];
            }
            const double mean = sum / static_cast<double>(side * side);
            squares += mean * mean;
        }
    }
    return squares * static_cast<double>(side * side) / (square_side * square_side);
}

TEST(Sobol, ErrorsOfNeighboursCancelAtEdges) {
    // Independent texels would leave 1 in each. tools/accuracy/search_shifts.cpp foretells the shifts' mean over all
    // these blocks and ways to lie: about a half.
    constexpr std::array<double, 2> most{1.0, 0.5}; // of 2 and 4 texels a side
    for (const std::uint32_t rays : {16U, 32U, 64U, 128U, 256U, 512U}) {
        double texel = 0.0;
        std::array<double, 2> block{};
        for (std::uint32_t square = 0; square < 1600; ++square) {
            const SquareErrors errors = errors_at_edge(square, rays);
            texel += mean_square(errors, 1);
            for (std::size_t level = 0; level < block.size(); ++level) {
                block[level] += mean_square(errors, std::size_t{2} << level);
            }
        }
        for (std::size_t level = 0; level < block.size(); ++level) {
            const auto texels = static_cast<double>(std::size_t{4} << (2 * level));
            EXPECT_LT(texels * block[level] / texel, most[level]) << rays << " rays, " << texels << " texels";
        }
    }
}

} // namespace
} // namespace vkbake
