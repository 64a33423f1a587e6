#include "base/elementary.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace vkbake {
namespace {

TEST(Elementary, SineAndCosineKeepTheirBound) {
    for (int i = -10000; i <= 10000; ++i) {
        const double angle = i * (std::numbers::pi / 4.0 / 10000.0);
        EXPECT_NEAR(sine_cosine(angle).sine, std::sin(angle), 1e-11) << angle;
        EXPECT_NEAR(sine_cosine(angle).cosine, std::cos(angle), 1e-11) << angle;
    }
}

TEST(Elementary, DegreesOfAnySizeKeepTheBoundAndQuarterTurnsAreExact) {
    for (int i = -800; i <= 800; ++i) {
        const double angle = i * std::numbers::pi / 180.0;
        EXPECT_NEAR(sine_cosine_degrees(i).sine, std::sin(angle), 1e-11) << i;
        EXPECT_NEAR(sine_cosine_degrees(i).cosine, std::cos(angle), 1e-11) << i;
    }
    for (int turns = -3; turns <= 3; ++turns) {
        EXPECT_EQ(sine_cosine_degrees(360.0 * turns).cosine, 1.0);
        EXPECT_EQ(sine_cosine_degrees(360.0 * turns + 90.0).sine, 1.0);
        EXPECT_EQ(sine_cosine_degrees(360.0 * turns + 90.0).cosine, 0.0);
        EXPECT_EQ(sine_cosine_degrees(360.0 * turns + 180.0).cosine, -1.0);
        EXPECT_EQ(sine_cosine_degrees(360.0 * turns + 270.0).sine, -1.0);
    }
}

} // namespace
} // namespace vkbake
