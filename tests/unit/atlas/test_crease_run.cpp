#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "atlas/crease_run.hpp"

namespace vkbake {
namespace {

glm::dvec2 direction(double degrees) {
    const double angle = degrees * std::numbers::pi / 180.0;
    return {std::cos(angle), std::sin(angle)};
}

TEST(CreaseRun, quarter_turns_are_straight_and_others_are_not) {
    CreaseRun creases;
    EXPECT_TRUE(creases.are_straight());
    creases.add(3.0 * direction(20.0));
    creases.add(0.5 * direction(110.0));
    creases.add(direction(-70.0));
    EXPECT_TRUE(creases.are_straight());
    creases.add(direction(50.0));
    EXPECT_FALSE(creases.are_straight());
}

TEST(CreaseRun, a_patch_is_added_as_it_is_turned) {
    CreaseRun patch;
    patch.add(direction(10.0));
    CreaseRun creases;
    creases.add(direction(0.0));
    CreaseRun straight = creases;
    straight.add(patch, direction(80.0));
    EXPECT_TRUE(straight.are_straight());
    creases.add(patch, direction(20.0));
    EXPECT_FALSE(creases.are_straight());
}

} // namespace
} // namespace vkbake
