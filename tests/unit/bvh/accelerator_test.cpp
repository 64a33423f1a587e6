#include "bvh/accelerator.hpp"

#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "vkbake/error.hpp"

namespace vkbake {
namespace {

constexpr AcceleratorSettings brute{Accelerator::brute, TriangleTest::watertight, 4, 0};

// The unit right triangle in the plane z = 1; its front looks along +z.
const std::vector<glm::vec3> unit_triangle{{0.0F, 0.0F, 1.0F}, {1.0F, 0.0F, 1.0F}, {0.0F, 1.0F, 1.0F}};

TEST(Accelerator, DistanceAndSide) {
    const std::vector<std::uint32_t> order{0};
    const TriangleAccelerator accelerator(unit_triangle, order, brute);
    const auto below = accelerator.nearest({{0.25F, 0.25F, 0.0F}, {0.0F, 0.0F, 2.0F}});
    ASSERT_TRUE(below);
    EXPECT_EQ(below->triangle, 0U);
    EXPECT_EQ(below->distance, 0.5F);
    EXPECT_TRUE(below->back_side);
    const auto above = accelerator.nearest({{0.25F, 0.25F, 3.0F}, {0.0F, 0.0F, -1.0F}});
    ASSERT_TRUE(above);
    EXPECT_EQ(above->distance, 2.0F);
    EXPECT_FALSE(above->back_side);
}

TEST(Accelerator, EndsOfTheRayAreOpen) {
    const std::vector<std::uint32_t> order{0};
    const TriangleAccelerator accelerator(unit_triangle, order, brute);
    EXPECT_FALSE(accelerator.occluded({{0.25F, 0.25F, 1.0F}, {0.0F, 0.0F, 1.0F}}));
    EXPECT_FALSE(accelerator.occluded({{0.25F, 0.25F, 0.0F}, {0.0F, 0.0F, 1.0F}, 1.0F}));
    EXPECT_TRUE(accelerator.occluded({{0.25F, 0.25F, 0.0F}, {0.0F, 0.0F, 1.0F}, 1.0000001F}));
    EXPECT_FALSE(accelerator.occluded({{0.25F, 0.25F, 0.0F}, {0.0F, 0.0F, -1.0F}}));
}

} // namespace
} // namespace vkbake
