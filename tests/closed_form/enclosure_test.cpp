// Closed rooms are black to the last texel: no ray leaves through an edge or a corner, and none starts behind a wall.
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <gtest/gtest.h>

#include "amount.hpp"
#include "base/random.hpp"
#include "hand_made.hpp"
#include "trace/tracer.hpp"

namespace vkbake {
namespace {

using test::white_sky;

/// Points all over every triangle: inside, on its edges, on its corners; off the exact place by up to 4 · 2⁻²⁴ an axis,
/// as a geometry image's may be.
std::vector<test::SamplePoint> points_all_over(const Surface& surface) {
    std::vector<test::SamplePoint> points;
    std::uint64_t key = 0;
    for (std::uint32_t triangle = 0; triangle < surface.triangle_count(); ++triangle) {
        constexpr int steps = 6;
        for (int i = 0; i <= steps; ++i) {
            for (int j = 0; i + j <= steps; ++j) {
                const glm::dvec3 weights(i, j, steps - i - j);
                test::SamplePoint point = test::point_on(surface, triangle, weights / static_cast<double>(steps));
                points.push_back(point);
                for (int axis = 0; axis < 3; ++axis) {
                    const double error = static_cast<double>(mix64(++key) % 9) - 4.0;
                    point.position[axis] += static_cast<float>(error * 0x1p-24);
                }
                points.push_back(point);
            }
        }
    }
    return points;
}

void expect_black(const Surface& surface, const Settings& settings) {
    const std::vector<test::SamplePoint> points = points_all_over(surface);
    const LightMap map = Tracer(surface, white_sky(), settings).trace(test::geometry_image(points, 32));
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_EQ(map.image.texels[i], glm::vec4(0, 0, 0, 1))
            << "triangle " << points[i].triangle << " at " << points[i].position.x << " " << points[i].position.y << " "
            << points[i].position.z;
        EXPECT_EQ(map.image.coverage[i], 1.0F);
    }
    EXPECT_EQ(map.statistics.occluded_rays, map.statistics.rays);
    EXPECT_GT(map.statistics.probed_hits, 0U);
    EXPECT_EQ(map.statistics.back_side_hits, 0U);
}

Surface turned(Surface surface, const glm::dmat3& turn) {
    for (glm::vec3& position : surface.positions) {
        position = glm::vec3(turn * glm::dvec3(position));
    }
    for (std::size_t triangle = 0; triangle < surface.triangle_count(); ++triangle) {
        const glm::dvec3 a(surface.positions[3 * triangle]);
        surface.geometric_normals[triangle] = glm::vec3(glm::normalize(glm::cross(
            glm::dvec3(surface.positions[3 * triangle + 1]) - a, glm::dvec3(surface.positions[3 * triangle + 2]) - a)));
    }
    return surface;
}

TEST(Enclosure, BoxesOfManyShapesAreBlackInside) {
    const std::vector<std::array<glm::vec3, 2>> boxes{
        {{{-1, -1, -1}, {1, 1, 1}}},
        {{{0.7F, 0.7F, 0.7F}, {0.9F, 0.8F, 0.75F}}},
        {{{-0.001F, 0, 0}, {0.001F, 0.002F, 0.003F}}},
        {{{-1, 0.3F, -1}, {1, 0.302F, 1}}}, // wide and low
        {{{-0.9F, 0.3F, 0.3F}, {0.9F, 0.31F, 0.31F}}},
    };
    // About an axis that is none of the frame's, and short enough to stay in it.
    const glm::dmat3 turn = 0.55 * glm::dmat3({0.36, 0.48, -0.8}, {-0.8, 0.6, 0.0}, {0.48, 0.64, 0.6});
    for (const auto& box : boxes) {
        test::SurfaceMaker maker;
        maker.add_box(box[0], box[1], true);
        const Surface surface = maker.finish();
        for (const Sampler sampler : {Sampler::cosine, Sampler::thesis}) {
            Settings settings;
            settings.sampler = sampler;
            settings.rays = test::amount(128U, 32U);
            expect_black(surface, settings);
            expect_black(turned(surface, turn), settings);
        }
    }
}

TEST(Enclosure, TentsWithSlopingWallsAreBlackInside) {
    // A prism whose walls lean over the floor by 15°: the sharpest crease that 4 : 1 would still hold.
    const float width = 0.5F;
    const float height = width * static_cast<float>(std::tan(0.2618));
    const glm::vec3 a(-width, 0, 0.6F);
    const glm::vec3 b(width, 0, 0.6F);
    const glm::vec3 c(0, height, 0.6F);
    const glm::vec3 behind(0, 0, -1.2F);
    test::SurfaceMaker maker;
    maker.add(a, c, b);
    maker.add(a + behind, b + behind, c + behind);
    maker.add_quad(a, b, b + behind, a + behind);
    maker.add_quad(b, c, c + behind, b + behind);
    maker.add_quad(c, a, a + behind, c + behind);
    expect_black(maker.finish(), {});
}

/// Outside of a box's faces, but under them: the floor on which it stands.
TEST(Enclosure, WhatLiesUnderABoxSeesBackSidesOnly) {
    test::SurfaceMaker maker;
    maker.add_box({-0.5F, 0, -0.5F}, {0.5F, 0.5F, 0.5F}, false);
    const std::uint32_t floor = maker.add_quad({-0.9F, 0, 0.9F}, {0.9F, 0, 0.9F}, {0.9F, 0, -0.9F}, {-0.9F, 0, -0.9F});
    const Surface surface = maker.finish();
    const glm::vec3 up(0, 1, 0);
    const std::vector<test::SamplePoint> points(64, {{0.1F, 0, 0.2F}, up, up, floor});
    const LightMap map = Tracer(surface, white_sky(), {}).trace(test::geometry_image(points, 8));
    EXPECT_EQ(map.image.texels[9], glm::vec4(0, 0, 0, 1));
    EXPECT_EQ(map.statistics.probed_hits, 64U); // one probe a texel
    EXPECT_EQ(map.statistics.back_side_hits, map.statistics.probed_hits);
}

} // namespace
} // namespace vkbake
