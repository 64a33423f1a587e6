#include "bvh/accelerator.hpp"

#include <array>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <glm/common.hpp>

#include "unit/bvh/ray_scenes.hpp"
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

constexpr std::array kinds{Accelerator::brute, Accelerator::clusters, Accelerator::bvh};

ErrorKind error_of(const AcceleratorSettings& settings) {
    const std::vector<std::uint32_t> order{0};
    try {
        const TriangleAccelerator accelerator(unit_triangle, order, settings);
    } catch (const Error& error) {
        return error.kind();
    }
    return ErrorKind::interrupted;
}

TEST(Accelerator, RefusesSettingsThatContradict) {
    const TriangleTest fast = TriangleTest::moller_trumbore;
    EXPECT_EQ(error_of({Accelerator::bvh, fast, 4, 0}), ErrorKind::usage);
    EXPECT_EQ(error_of({Accelerator::clusters, TriangleTest::watertight, 0, 0}), ErrorKind::usage);
    EXPECT_EQ(error_of({Accelerator::clusters, TriangleTest::watertight, 65, 0}), ErrorKind::usage);
    EXPECT_EQ(error_of({Accelerator::clusters, fast, 64, 0}), ErrorKind::interrupted); // none
    EXPECT_EQ(error_of({Accelerator::brute, fast, 4, 0}), ErrorKind::interrupted);
}

TEST(Accelerator, RefusesAnOrderThatDoesNotFit) {
    const std::vector<std::uint32_t> too_long{0, 1};
    const std::vector<std::uint32_t> beyond{1};
    EXPECT_THROW(TriangleAccelerator(unit_triangle, too_long, brute), Error);
    EXPECT_THROW(TriangleAccelerator(unit_triangle, beyond, brute), Error);
}

TEST(Accelerator, NoTrianglesMeetNothing) {
    for (const Accelerator kind : kinds) {
        const TriangleAccelerator accelerator = test::accelerate({}, kind);
        EXPECT_FALSE(accelerator.occluded({{0, 0, 0}, {0, 0, 1}}));
        EXPECT_FALSE(accelerator.nearest({{0, 0, 0}, {0, 0, 1}}));
        EXPECT_EQ(accelerator.statistics().triangles, 0U);
    }
}

TEST(Accelerator, RaysOutsideTheContractMeetNothing) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    for (const Accelerator kind : kinds) {
        const TriangleAccelerator accelerator = test::accelerate(test::sphere(1, 1.0F, glm::vec3(0.0F)), kind);
        EXPECT_TRUE(accelerator.occluded({{0, 0, 0}, {0, 0, 0x1p-60F}}));
        EXPECT_TRUE(accelerator.occluded({{0, 0, 0}, {0, 0, -0x1p60F}}));
        EXPECT_FALSE(accelerator.occluded({{0, 0, 0}, {0, 0, 0}}));
        EXPECT_FALSE(accelerator.occluded({{0, 0, 0}, {0, 0, 0x1p-61F}}));
        EXPECT_FALSE(accelerator.occluded({{0, 0, 0}, {0, 0, 0x1p61F}}));
        EXPECT_FALSE(accelerator.occluded({{0, 0, 0}, {nan, 0, 1}}));
        EXPECT_FALSE(accelerator.occluded({{0, 0, 0}, {infinity, 0, 1}}));
        EXPECT_FALSE(accelerator.occluded({{nan, 0, 0}, {0, 0, 1}}));
        EXPECT_FALSE(accelerator.occluded({{0, infinity, 0}, {0, 0, 1}}));
        EXPECT_FALSE(accelerator.occluded({{0, 0, 0}, {0, 0, 1}, nan}));
        EXPECT_FALSE(accelerator.occluded({{0, 0, 0}, {0, 0, 1}, 0.0F}));
        EXPECT_FALSE(accelerator.occluded({{0, 0, 0}, {0, 0, 1}, -1.0F}));
        EXPECT_FALSE(accelerator.nearest({{0, 0, 0}, {0, nan, 1}}));
    }
}

// Points, doubled corners, and three corners on a line that is oblique to every axis.
std::vector<glm::vec3> without_area() {
    std::vector<glm::vec3> positions;
    test::Random random(11);
    for (int i = 0; i < 50; ++i) {
        const glm::vec3 a = random.point();
        const glm::vec3 b = random.point();
        const glm::vec3 grid = glm::round(b * 1024.0F) / 1024.0F;
        positions.insert(positions.end(), {a, a, a, a, b, b, a, a, b, a, b, a, -grid, grid, 3.0F * grid});
    }
    return positions;
}

TEST(Accelerator, TrianglesWithoutAreaNeverBlock) {
    const std::vector<glm::vec3> positions = without_area();
    for (const Accelerator kind : kinds) {
        const TriangleAccelerator accelerator = test::accelerate(test::make_triangles("", positions), kind);
        EXPECT_EQ(accelerator.statistics().triangles, 0U);
        test::Random random(12);
        for (const glm::vec3& corner : positions) {
            const glm::vec3 origin = random.point();
            EXPECT_FALSE(accelerator.occluded({origin, corner - origin}));
        }
    }
}

TEST(Accelerator, TrianglesWithoutAreaDoNotDisturbTheOthers) {
    std::vector<glm::vec3> positions = test::soup_positions(100, 0.3F, 13);
    const test::Triangles clean = test::make_triangles("", positions);
    const std::vector<glm::vec3> lines = without_area();
    positions.insert(positions.end(), lines.begin(), lines.end());
    const test::Triangles mixed = test::make_triangles("", positions);
    for (const Accelerator kind : kinds) {
        const TriangleAccelerator a = test::accelerate(clean, kind);
        const TriangleAccelerator b = test::accelerate(mixed, kind);
        EXPECT_EQ(b.statistics().triangles, 100U);
        test::Random random(14);
        for (int i = 0; i < 500; ++i) {
            const Ray ray{random.point(), random.direction()};
            const auto hit_a = a.nearest(ray);
            const auto hit_b = b.nearest(ray);
            ASSERT_EQ(hit_a.has_value(), hit_b.has_value());
            if (hit_a) {
                EXPECT_EQ(hit_a->triangle, hit_b->triangle);
                EXPECT_EQ(hit_a->distance, hit_b->distance);
            }
        }
    }
}

TEST(Accelerator, OfEqualDistancesTheFirstInCanonicalOrderWins) {
    // the same triangle five times; the order, not the number, decides
    std::vector<glm::vec3> positions;
    for (int i = 0; i < 5; ++i) {
        positions.insert(positions.end(), unit_triangle.begin(), unit_triangle.end());
    }
    for (const Accelerator kind : kinds) {
        for (std::uint32_t first = 0; first < 5; ++first) {
            const std::vector<std::uint32_t> order{first, (first + 3) % 5, (first + 1) % 5, (first + 4) % 5,
                                                   (first + 2) % 5};
            const TriangleAccelerator accelerator(positions, order, {kind, TriangleTest::watertight, 4, 0});
            const auto hit = accelerator.nearest({{0.25F, 0.25F, 0.0F}, {0.0F, 0.0F, 1.0F}});
            ASSERT_TRUE(hit);
            EXPECT_EQ(hit->triangle, first);
        }
    }
}

TEST(Accelerator, TiesAcrossClustersAreDecidedByOrderToo) {
    // two triangles of different cells that meet the ray at the same point, on their shared edge x = 0
    const std::vector<glm::vec3> positions{{-1, 0, 1}, {0, -1, 1}, {0, 1, 1}, {0, -1, 1}, {1, 0, 1}, {0, 1, 1}};
    for (const Accelerator kind : kinds) {
        for (std::uint32_t first = 0; first < 2; ++first) {
            const std::vector<std::uint32_t> order{first, 1 - first};
            const TriangleAccelerator accelerator(positions, order, {kind, TriangleTest::watertight, 2, 0});
            const auto hit = accelerator.nearest({{0, 0, 0}, {0, 0, 1}});
            ASSERT_TRUE(hit);
            EXPECT_EQ(hit->triangle, first);
        }
    }
}

TEST(Accelerator, AnswersDoNotDependOnTheOrderOfTheInput) {
    const std::vector<glm::vec3> positions = test::soup_positions(300, 0.3F, 15);
    std::vector<glm::vec3> reversed;
    for (std::size_t triangle = 300; triangle-- > 0;) {
        const auto begin = positions.begin() + static_cast<std::ptrdiff_t>(3 * triangle);
        reversed.insert(reversed.end(), begin, begin + 3);
    }
    const test::Triangles forward = test::make_triangles("", positions);
    const test::Triangles backward = test::make_triangles("", reversed);
    for (const Accelerator kind : kinds) {
        const TriangleAccelerator a = test::accelerate(forward, kind);
        const TriangleAccelerator b = test::accelerate(backward, kind);
        test::Random random(16);
        for (int i = 0; i < 500; ++i) {
            const Ray ray{random.point(), random.direction()};
            const auto hit_a = a.nearest(ray);
            const auto hit_b = b.nearest(ray);
            ASSERT_EQ(hit_a.has_value(), hit_b.has_value());
            if (hit_a) {
                EXPECT_EQ(hit_a->triangle, 299 - hit_b->triangle);
                EXPECT_EQ(hit_a->distance, hit_b->distance);
            }
        }
    }
}

} // namespace
} // namespace vkbake
