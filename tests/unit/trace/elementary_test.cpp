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

TEST(Elementary, ArcTangentKeepsItsBoundAllAround) {
    for (int i = 0; i < 40000; ++i) {
        const double angle = (i - 20000 + 0.37) * (std::numbers::pi / 20000.0);
        const double radius = i % 3 == 0 ? 1e-30 : 3.0;
        const double y = radius * std::sin(angle);
        const double x = radius * std::cos(angle);
        EXPECT_NEAR(arc_tangent(y, x), std::atan2(y, x), 1e-8) << angle;
    }
    EXPECT_TRUE(std::isfinite(arc_tangent(0.0, 0.0)));
    EXPECT_NEAR(arc_tangent(1.0, 0.0), std::numbers::pi / 2.0, 1e-15);
    EXPECT_NEAR(arc_tangent(0.0, -1.0), std::numbers::pi, 1e-15);
}

TEST(Elementary, ExponentialKeepsItsRelativeBound) {
    for (int i = -70000; i <= 70000; ++i) {
        const double x = i * 0.01;
        EXPECT_NEAR(exponential(x) / std::exp(x), 1.0, 3e-10) << x;
    }
    EXPECT_EQ(exponential(-1e300), 0.0);
    EXPECT_EQ(exponential(0.0), 1.0);
}

} // namespace
} // namespace vkbake
