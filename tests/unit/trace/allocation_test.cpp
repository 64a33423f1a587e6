#include "trace/allocation.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "trace/contrasts.hpp"

namespace vkbake {
namespace {

TEST(Allocation, IsTheCheapestOfAll) {
    std::mt19937 random(1);
    for (int trial = 0; trial < 20; ++trial) {
        const double ratio = 0.35;
        std::vector<TileNeed> needs;
        double before = 0.0;
        for (int tile = 0; tile < 5; ++tile) {
            needs.push_back({16, 16U << (random() % 3), std::uniform_real_distribution<>(0.01, 1.0)(random),
                             std::uniform_real_distribution<>(0.1, 1.0)(random)});
            before += needs.back().variance;
        }
        const double wanted = before * 0.2;
        const Allocation found = allocate_for_variance(needs, ratio, wanted);
        EXPECT_LE(found.variance, wanted);
        // All ways to double five tiles up to five times.
        for (int way = 0; way < 6 * 6 * 6 * 6 * 6; ++way) {
            double variance = 0.0;
            double work = 0.0;
            int digits = way;
            for (const TileNeed& need : needs) {
                const int doublings = digits % 6;
                digits /= 6;
                variance += need.variance * std::pow(ratio, doublings);
                work += need.cost * 16.0 * need.rays * (std::pow(2.0, doublings) - 1.0);
            }
            // Lagrange's condition gives the least variance that so much work can bring.
            if (work <= found.work) {
                ASSERT_GE(variance, found.variance * (1.0 - 1e-9));
            }
        }
    }
}

TEST(Allocation, SpendsWhatItMayAndNoMore) {
    std::vector<TileNeed> needs;
    needs.reserve(500);
    for (int tile = 0; tile < 500; ++tile) {
        needs.push_back({16, 16, 1.0 + tile * 0.01});
    }
    const Allocation found = allocate_for_work(needs, 0.35, 100000.0);
    EXPECT_LE(found.work, 100000.0);
    EXPECT_GT(found.work, 100000.0 - 16.0 * 32.0);
    EXPECT_EQ(allocate_for_work(needs, 0.35, 0.0).work, 0.0);
}

TEST(Allocation, EndsWhereNothingHelps) {
    const std::vector<TileNeed> flawless(3, {16, 16, 0.0});
    EXPECT_EQ(allocate_for_variance(flawless, 0.35, 0.0).work, 0.0);
    const std::vector<TileNeed> needs(3, {16, most_rays / 2, 1.0});
    const Allocation found = allocate_for_variance(needs, 0.5, 0.0);
    EXPECT_EQ(found.doublings, std::vector<std::uint8_t>(3, 1));
    EXPECT_EQ(allocate_for_variance({}, 0.35, 0.0).doublings.size(), 0U);
}

TEST(Contrasts, AreMeanSquaresOfHalfDifferences) {
    // Parts of 2 samples with the means 1, 3, 0, 0, 4, 0, 0, 0.
    const Contrasts found = contrasts({2, 6, 0, 0, 8, 0, 0, 0}, 16);
    EXPECT_DOUBLE_EQ(found.squares[0], (1.0 + 0.0 + 4.0 + 0.0) / 4.0);
    EXPECT_DOUBLE_EQ(found.squares[1], (1.0 + 1.0) / 2.0); // of means 2, 0, 2, 0
    EXPECT_DOUBLE_EQ(found.squares[2], 0.0);               // of means 1, 1
}

/// Independent samples halve their variance with each doubling: then all seven contrasts say what the textbook says of
/// eight replicates.
TEST(Contrasts, OfIndependentSamplesAreTheSampleVariance) {
    std::mt19937 random(2);
    std::normal_distribution<double> normal;
    FallOfVariance fall;
    double by_contrasts = 0.0;
    double by_textbook = 0.0;
    for (int texel = 0; texel < 4000; ++texel) {
        std::array<float, part_count> sums{};
        double sum = 0.0;
        double squares = 0.0;
        for (float& part : sums) {
            part = static_cast<float>(normal(random));
            sum += static_cast<double>(part);
            squares += static_cast<double>(part) * static_cast<double>(part);
        }
        const Contrasts found = contrasts(sums, 8 * 16);
        fall.add(found);
        by_contrasts += variance(found, 0.5, 8 * 16);
        by_textbook += (squares - sum * sum / 8.0) / 7.0 / 8.0 / (16.0 * 16.0);
    }
    EXPECT_NEAR(fall.ratio(), 0.5, 0.02);
    EXPECT_NEAR(by_contrasts / by_textbook, 1.0, 1e-5);
}

} // namespace
} // namespace vkbake
