#include "bvh/triangle_test.hpp"

#include <gtest/gtest.h>

#include "amount.hpp"
#include "unit/bvh/double_reference.hpp"

namespace vkbake::test {
namespace {

constexpr double unit_roundoff = 0x1p-24;
// What PreparedRay's comment allows a sheared corner to be off, and the rounded distance in addition.
constexpr double corner_error = 6.5 * unit_roundoff;

// Half of the rays aim at a point of an edge as well as floats allow.
Ray ray_at(Random& random, const std::array<glm::vec3, 3>& triangle) {
    const glm::vec3 origin = random.point(2.0F);
    const float s = random.between(0.0F, 1.0F);
    const float t = random.below(2) == 0 ? 0.0F : random.between(0.0F, 1.2F - s);
    const std::size_t first = random.below(3);
    const glm::vec3& a = triangle[first];
    const glm::vec3 target = a + s * (triangle[(first + 1) % 3] - a) + t * (triangle[(first + 2) % 3] - a);
    return {origin, target - origin};
}

struct Comparison {
    int hits = 0;
    int differences = 0;
    int unexplained = 0;
    double worst_distance = 0.0; ///< error ÷ allowed error
};

void compare(Comparison& comparison, const Ray& ray, const std::array<glm::vec3, 3>& corners) {
    Box bounds;
    for (const glm::vec3& corner : corners) {
        bounds.add(corner);
    }
    const PreparedRay prepared(ray, bounds);
    const TriangleHit hit = test_watertight(prepared, {corners});
    const Reference reference = refer(ray, corners);
    // two axes are off, each by the corner's error at most
    const double allowed_shift = std::sqrt(2.0) * corner_error * reference.extent;
    const double allowed_distance =
        2.0 * reference.steepness * allowed_shift + 2.0 * unit_roundoff * std::abs(reference.distance);
    const bool expected = reference.inside && reference.distance > 0.0;
    comparison.hits += expected ? 1 : 0;
    if (hit.hit != expected) {
        ++comparison.differences;
        const bool near_edge = reference.margin <= allowed_shift;
        const bool near_end = reference.inside && std::abs(reference.distance) <= allowed_distance;
        comparison.unexplained += near_edge || near_end ? 0 : 1;
    } else if (expected) {
        comparison.worst_distance =
            std::max(comparison.worst_distance, std::abs(hit.distance - reference.distance) / allowed_distance);
    }
}

Comparison compare_with_double(const Triangles& triangles, int rays) {
    Comparison comparison;
    Random random(21);
    for (int i = 0; i < rays; ++i) {
        const std::array<glm::vec3, 3> corners = triangles.corners(random.below(triangles.count()));
        compare(comparison, ray_at(random, corners), corners);
    }
    return comparison;
}

TEST(WatertightTest, DiffersFromDoublePrecisionOnlyWithinRoundingOfAnEdge) {
    for (const float size : {1.0F, 0.1F, 0.001F}) {
        const Comparison comparison = compare_with_double(soup(1000, size, 22), 100000);
        EXPECT_GT(comparison.hits, 40000);
        EXPECT_GT(comparison.differences, 0); // else the rays were not near enough to test anything
        EXPECT_EQ(comparison.unexplained, 0);
        EXPECT_LE(comparison.worst_distance, 1.0);
    }
    const Comparison comparison = compare_with_double(needles(1000, 23), 100000);
    EXPECT_GT(comparison.hits, 1000);
    EXPECT_EQ(comparison.unexplained, 0);
    EXPECT_LE(comparison.worst_distance, 1.0);
}

TEST(WatertightTest, BruteForceFindsWhatDoublePrecisionFinds) {
    const Triangles triangles = soup(200, 0.3F, 24);
    const TriangleAccelerator accelerator = accelerate(triangles, Accelerator::brute);
    Random random(25);
    int differences = 0;
    for (int i = 0; i < amount(8000, 1000); ++i) {
        const Ray ray{random.point(), random.direction()};
        double nearest = std::numeric_limits<double>::infinity();
        std::size_t found = 0;
        for (std::size_t triangle = 0; triangle < triangles.count(); ++triangle) {
            const Reference reference = refer(ray, triangles.corners(triangle));
            if (reference.inside && reference.distance > 0.0 && reference.distance < nearest) {
                nearest = reference.distance;
                found = triangle;
            }
        }
        const auto hit = accelerator.nearest(ray);
        const bool expected = std::isfinite(nearest);
        differences += hit.has_value() != expected || (hit && hit->triangle != found) ? 1 : 0;
        EXPECT_EQ(accelerator.occluded(ray), hit.has_value());
    }
    // About 10⁻⁷ of a triangle's width is in doubt, with 200 triangles: 8000 random rays meet it less than once.
    EXPECT_LE(differences, 2);
}

TEST(WatertightTest, EdgesAndCornersBelongToTheTriangle) {
    const Triangle triangle{{glm::vec3(0, 0, 1), glm::vec3(1, 0, 1), glm::vec3(0, 1, 1)}};
    for (const glm::vec2& at : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(0, 1), glm::vec2(0.5F, 0.0F),
                                glm::vec2(0.0F, 0.5F), glm::vec2(0.5F, 0.5F)}) {
        const PreparedRay ray({{at.x, at.y, 0.0F}, {0, 0, 1}}, triangle.bounds());
        EXPECT_TRUE(test_watertight(ray, triangle).hit);
        EXPECT_EQ(test_watertight(ray, triangle).distance, 1.0F);
    }
    for (const glm::vec2& at : {glm::vec2(-0x1p-24F, 0.5F), glm::vec2(0.5F, -0x1p-24F), glm::vec2(0.5F, 0.50000006F)}) {
        const PreparedRay ray({{at.x, at.y, 0.0F}, {0, 0, 1}}, triangle.bounds());
        EXPECT_FALSE(test_watertight(ray, triangle).hit);
    }
}

TEST(WatertightTest, InThePlaneOfTheTriangleNothingIsMet) {
    const Triangle triangle{{glm::vec3(0, 0, 1), glm::vec3(1, 0, 1), glm::vec3(0, 1, 1)}};
    EXPECT_FALSE(test_watertight(PreparedRay({{-1, 0.25F, 1}, {1, 0, 0}}, triangle.bounds()), triangle).hit);
    EXPECT_FALSE(test_watertight(PreparedRay({{0.25F, 0.25F, 1}, {1, -1, 0}}, triangle.bounds()), triangle).hit);
}

TEST(MollerTrumbore, AgreesWithTheWatertightTestAwayFromEdges) {
    const Triangles triangles = soup(1000, 0.5F, 26);
    Random random(27);
    int compared = 0;
    for (int i = 0; i < 100000; ++i) {
        const std::array<glm::vec3, 3> corners = triangles.corners(random.below(triangles.count()));
        const Ray ray = ray_at(random, corners);
        const Reference reference = refer(ray, corners);
        // seen too obliquely, or too near an edge, its float determinants say nothing
        if (reference.margin < 1e-4 || reference.steepness > 50.0 || std::abs(reference.distance) < 1e-3) {
            continue;
        }
        ++compared;
        const Triangle triangle{corners};
        const PreparedRay prepared(ray, triangle.bounds());
        const TriangleHit plain = test_moller_trumbore(prepared, triangle);
        const TriangleHit watertight = test_watertight(prepared, triangle);
        ASSERT_EQ(plain.hit, watertight.hit);
        if (plain.hit) {
            EXPECT_EQ(plain.back_side, watertight.back_side);
            EXPECT_NEAR(plain.distance, watertight.distance, 1e-4F * (1.0F + watertight.distance));
        }
    }
    EXPECT_GT(compared, 30000);
}

TEST(PreparedRay, LargerBoxesGiveNoSmallerInterval) {
    Random random(28);
    Box scene;
    scene.add(glm::vec3(-1.0F));
    scene.add(glm::vec3(1.0F));
    for (int i = 0; i < 20000; ++i) {
        const PreparedRay ray({random.point(), random.direction()}, scene);
        Box inner;
        inner.add(random.point());
        inner.add(random.point());
        Box outer = inner;
        outer.add(random.point());
        const Interval a = pass(ray, inner);
        const Interval b = pass(ray, outer);
        ASSERT_LE(b.entry, a.entry);
        ASSERT_GE(b.exit, a.exit);
    }
}

} // namespace
} // namespace vkbake::test
