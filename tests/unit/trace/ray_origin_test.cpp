#include "trace/ray_origin.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "base/random.hpp"

namespace vkbake {
namespace {

using Triangle = std::array<glm::vec3, 3>;

glm::dvec3 normal_of(const Triangle& t) {
    return glm::normalize(glm::cross(glm::dvec3(t[1]) - glm::dvec3(t[0]), glm::dvec3(t[2]) - glm::dvec3(t[0])));
}

/// The distances of a point from the three edges' lines, positive inside.
std::array<double, 3> edge_distances(const Triangle& t, const glm::dvec3& point) {
    std::array<double, 3> distances{};
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 start(t[(k + 1) % 3]);
        const glm::dvec3 along = glm::normalize(glm::dvec3(t[(k + 2) % 3]) - start);
        distances[k] = glm::dot(glm::cross(normal_of(t), along), point - start);
    }
    return distances;
}

float number(std::uint64_t key) {
    return static_cast<float>(static_cast<double>(mix64(key) >> 11U) * 0x1p-53 * 2.0 - 1.0);
}

TEST(RayOrigin, LeavesPointsAwayFromEdgesWhereTheyAreButForTheNormal) {
    const Triangle triangle{{{0, 0, 0}, {0.5F, 0, 0}, {0, 0, -0.5F}}};
    EXPECT_EQ(ray_origin(triangle, {0.125F, 0, -0.125F}, {0, 1, 0}),
              glm::vec3(0.125F, static_cast<float>(origin_off_surface), -0.125F));
}

TEST(RayOrigin, KeepsItsDistanceFromEdgesAndPlane) {
    // 1e-7 bounds what rounding the origin to floats moves it.
    for (std::uint64_t i = 0; i < 3000; ++i) {
        const float size = i % 3 == 0 ? 1.0F : (i % 3 == 1 ? 0.01F : 1e-4F);
        const auto corner = [&](std::uint64_t k) {
            return glm::vec3(0.4F * number(100 * i)) +
                   size * 0.5F *
                       glm::vec3(number(100 * i + 3 * k), number(100 * i + 3 * k + 1), number(100 * i + 3 * k + 2));
        };
        const Triangle triangle{corner(1), corner(2), corner(3)};
        const glm::dvec3 normal = normal_of(triangle);
        const glm::dvec3 centroid = (glm::dvec3(triangle[0]) + glm::dvec3(triangle[1]) + glm::dvec3(triangle[2])) / 3.0;
        const std::array<double, 3> room = edge_distances(triangle, centroid);
        // Corners, edges' middles, and places just outside as rounding may put them.
        for (std::size_t k = 0; k < 6; ++k) {
            const glm::vec3 place = k < 3 ? triangle[k] : 0.5F * (triangle[k - 3] + triangle[(k - 2) % 3]);
            const glm::vec3 origin = ray_origin(triangle, place, glm::vec3(normal));
            const glm::dvec3 offset = glm::dvec3(origin) - glm::dvec3(triangle[0]);
            EXPECT_NEAR(glm::dot(offset, normal), origin_off_surface, 2e-7);
            const std::array<double, 3> distances = edge_distances(triangle, glm::dvec3(origin));
            for (std::size_t edge = 0; edge < 3; ++edge) {
                EXPECT_GE(distances[edge], std::min(origin_from_edges, room[edge]) - 1e-7)
                    << i << " " << k << " " << edge;
            }
        }
    }
}

TEST(RayOrigin, NeedlesAndPointsStayFinite) {
    const Triangle needle{{{-0.9F, 0, 0}, {0.9F, 0, 0}, {0, 0, -1e-6F}}};
    const glm::vec3 origin = ray_origin(needle, {-0.9F, 0, 0}, {0, 1, 0});
    // No place keeps the distance: the centroid.
    EXPECT_NEAR(origin.x, 0.0F, 1e-6F);
    EXPECT_NEAR(origin.z, -1e-6F / 3.0F, 1e-9F);
    const Triangle point{{{0.25F, 0, 0}, {0.25F, 0, 0}, {0.25F, 0, 0}}};
    EXPECT_EQ(ray_origin(point, {0.25F, 0, 0}, {0, 1, 0}), glm::vec3(0.25F, static_cast<float>(origin_off_surface), 0));
}

} // namespace
} // namespace vkbake
