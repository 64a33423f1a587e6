// Pictures whose texels are packed into four bytes.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include "highway_targets.hpp"
#include "sky_looked_up.hpp"

namespace vkbake {
namespace {

using test::picture;
using test::pseudo_random;
using test::pseudo_random_direction;
using test::radiances;

TEST(PackedPictures, TakeTheNearestValueOrTheOneBelow) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        const glm::vec3 value =
            static_cast<float>(std::exp2(60.0 * pseudo_random(i) - 30.0)) * glm::abs(pseudo_random_direction(i + 5000));
        const glm::vec3 near = packed_near(value);
        const glm::vec3 below = packed_below(value);
        const float step = std::max({value.x, value.y, value.z}) / 128.0F;
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_NEAR(near[channel], value[channel], step);
            EXPECT_LE(below[channel], value[channel]);
            EXPECT_GT(below[channel], value[channel] - step);
        }
        EXPECT_EQ(packed_below(near), near);
        EXPECT_EQ(packed_near(below), below);
    }
}

} // namespace
} // namespace vkbake
