// What a surface sees of itself, of what touches it, and of what lies in the same place.
#include <gtest/gtest.h>

#include "amount.hpp"
#include "closed_form/configuration_factors.hpp"
#include "closed_form/hand_made.hpp"
#include "host_bake.hpp"

namespace vkbake::test {
namespace {

/// A plane of n × n quads.
Primitive plane_of(int n) {
    Primitive plane;
    for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= n; ++j) {
            add_vertex(plane, {static_cast<float>(i) / static_cast<float>(n) - 0.5F, 0.0F,
                               0.5F - static_cast<float>(j) / static_cast<float>(n)});
        }
    }
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(i * (n + 1) + j); };
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            plane.indices.insert(plane.indices.end(), {at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            plane.indices.insert(plane.indices.end(), {at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return plane;
}

/// A convex pyramid of ever steeper sides: no side sees another.
Primitive dome_of(int steps) {
    Primitive dome;
    for (int step = 0; step < steps; ++step) {
        const float top = std::cos(1.5F * static_cast<float>(step) / static_cast<float>(steps));
        const float low = std::cos(1.5F * static_cast<float>(step + 1) / static_cast<float>(steps));
        const float in = std::sqrt(1.0F - top * top);
        const float out = std::sqrt(1.0F - low * low);
        add_quad(dome, {-1.0F, low, out}, {1.0F, low, out}, {1.0F, top, in}, {-1.0F, top, in});
    }
    return dome;
}

/// Whatever is convex sees nothing of itself: not one of its rays may be stopped.
TEST(Visibility, NothingConvexDarkensItselfAtAnyScaleOrPlace) {
    const std::vector<std::pair<const char*, Primitive>> shapes{{"plane", plane_of(12)},
                                                                {"sphere", sphere_of(0.5F)},
                                                                {"box", box_of(glm::vec3(-0.5F), glm::vec3(0.5F))},
                                                                {"dome", dome_of(16)}};
    const Settings settings = small_settings(amount(48, 24), amount(64, 8));
    for (const auto& [name, shape] : shapes) {
        for (const double size : {1e-6, 0.37, 1.0, 1e6}) {
            for (const double offset : {0.0, 1.0 / 3.0, 1e4, 1e7}) {
                for (const bool turned : {false, true}) {
                    SCOPED_TRACE(std::string(name) + " of " + std::to_string(size) + " m at " + std::to_string(offset));
                    const Scene scene = scene_of(shape, glm::dvec3(1.0, -0.7, 0.3) * offset * size,
                                                 (turned ? odd_rotation() : glm::dmat3(1.0)) * size);
                    const HostBake bake = bake_on_host(scene, {}, settings);
                    ASSERT_GT(bake.maps[0].statistics.rays, 1000U);
                    ASSERT_EQ(bake.maps[0].statistics.occluded_rays, 0U);
                }
            }
        }
    }
}

/// A stair that is as good as endless sideways. Its treads see the riser behind them up to the elevation atan(h/c) at a
/// distance c, which hides all the steps above; so their visibility is (1 + cos) / 2.
TEST(Visibility, TerracesHaveTheirClosedFormAtEveryScale) {
    constexpr int steps = 6;
    constexpr float depth = 1.0F;
    constexpr float height = 0.5F;
    Primitive stair;
    for (int step = 0; step < steps; ++step) {
        const float x = depth * static_cast<float>(step);
        const float y = height * static_cast<float>(step);
        add_quad(stair, {x, y, 400.0F}, {x + depth, y, 400.0F}, {x + depth, y, -400.0F}, {x, y, -400.0F});
        if (step + 1 < steps) {
            const float wall = x + depth;
            add_quad(stair, {wall, y, 400.0F}, {wall, y + height, 400.0F}, {wall, y + height, -400.0F},
                     {wall, y, -400.0F});
        }
    }
    constexpr std::uint32_t rays = amount(1024U, 256U);
    for (const double size : {1e-6, 1.0, 1e6}) {
        SCOPED_TRACE(size);
        const Scene scene = scene_of(stair, glm::dvec3(size * 1e5), glm::dmat3(size));
        const Surface surface = make_surface(scene);
        std::vector<test::SamplePoint> points;
        std::vector<double> expected;
        for (std::uint32_t triangle = 0; triangle < surface.triangle_count(); ++triangle) {
            if (surface.geometric_normals[triangle].y < 0.5F) {
                continue;
            }
            const glm::vec3* corners = &surface.positions[3 * std::size_t{triangle}];
            for (const glm::dvec3& weights : {glm::dvec3(1.0 / 3.0), glm::dvec3(0.4, 0.5, 0.1),
                                              glm::dvec3(0.1, 0.45, 0.45), glm::dvec3(0.49, 0.02, 0.49)}) {
                const glm::vec3 point(weights.x * glm::dvec3(corners[0]) + weights.y * glm::dvec3(corners[1]) +
                                      weights.z * glm::dvec3(corners[2]));
                const glm::dvec3 world = surface.frame.to_world(point) / size - glm::dvec3(1e5);
                if (std::abs(world.z) > 200.0) {
                    continue;
                }
                const glm::vec3& normal = surface.geometric_normals[triangle];
                points.push_back({point, normal, normal, triangle});
                const double distance = std::ceil(world.x) - world.x;
                const bool topmost = world.y > height * (steps - 1.5);
                expected.push_back(topmost ? 1.0 : 0.5 + 0.5 * distance / std::hypot(distance, height));
            }
        }
        ASSERT_GE(expected.size(), 20U);
        const GeometryImage texels = test::geometry_image(points, static_cast<int>(points.size()));
        const LightMap map = Tracer(surface, {}, small_settings(1, rays)).trace(texels);
        for (std::size_t i = 0; i < expected.size(); ++i) {
            // 6 deviations of N rays, and what is seen past the ends of 400 m: less than (3 / 200)² / 4.
            EXPECT_NEAR(static_cast<double>(map.image.texels[i].x), expected[i], 6.0 * std::sqrt(0.25 / rays) + 1e-4)
                << i;
        }
    }
}

/// A plate over a floor with a gap of one ten-thousandth of the scene, and a box that stands on it.
TEST(Visibility, ContactsOcclude) {
    for (const double size : {1e-3, 1.0, 1e5}) {
        for (const bool turned : {false, true}) {
            SCOPED_TRACE(size);
            const glm::dmat3 linear = (turned ? odd_rotation() : glm::dmat3(1.0)) * size;
            Scene scene = scene_of(floor_of(0.5F), {}, linear);
            add_object(scene, "plate", floor_of(0.25F, 1e-4F), {}, linear);
            Settings settings = small_settings(64, amount(64, 4));
            settings.layout = Layout::object;
            const HostBake bake = bake_on_host(scene, {}, settings);
            EXPECT_EQ(bake.maps.at(1).statistics.occluded_rays, 0U); // the plate looks up
            int inside = 0;
            for (std::size_t texel = 0; texel < bake.geometry[0].texel_count(); ++texel) {
                if (bake.geometry[0].triangle[texel] == GeometryImage::empty) {
                    continue;
                }
                const glm::dvec3 place =
                    glm::inverse(linear) * bake.surface.frame.to_world(bake.geometry[0].position[texel]);
                // 0.05 inside the plate's border the open share is some (10⁻⁴ / 0.05)² / 4 = 10⁻⁶.
                if (std::max(std::abs(place.x), std::abs(place.z)) < 0.2) {
                    ++inside;
                    ASSERT_LE(bake.maps[0].image.texels[texel].x, 1.0F / 64.0F);
                }
            }
            EXPECT_GT(inside, 300);
        }
    }
}

TEST(Visibility, AFloorIsDarkUpToTheWallThatStandsOnIt) {
    Scene scene = scene_of(floor_of(2.0F));
    add_object(scene, "wall", box_of({0.0F, 0.0F, -200.0F}, {0.5F, 200.0F, 200.0F}));
    const Surface surface = make_surface(scene);
    const std::uint32_t triangle = surface.objects[0].first_triangle; // −x side
    std::vector<test::SamplePoint> points;
    std::vector<double> expected;
    for (const double distance : {1e-3, 1e-2, 0.1, 1.0}) {
        const glm::dvec3 world(-distance, 0.0, 1.9 - distance);
        const glm::vec3 up(0.0F, 1.0F, 0.0F);
        points.push_back({(world - surface.frame.centre) * surface.frame.scale(), up, up, triangle});
        expected.push_back(1.0 - element_to_perpendicular_rectangle(200.0, 200.0 - world.z, distance) -
                           element_to_perpendicular_rectangle(200.0, 200.0 + world.z, distance));
    }
    const GeometryImage texels = test::geometry_image(points, static_cast<int>(points.size()));
    constexpr std::uint32_t rays = 1024;
    const LightMap map = Tracer(surface, {}, small_settings(1, rays)).trace(texels);
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(static_cast<double>(map.image.texels[i].x), expected[i], 6.0 * std::sqrt(0.25 / rays)) << i;
    }
}

/// Two sheets in one place, seen from both sides under a white sky. Rays leave from 2⁻²⁰ of the frame above their own
/// side; so what lies in the very same plane is behind them.
TEST(Visibility, CoincidentSurfacesBehaveAsDocumented) {
    Primitive down = floor_of(0.5F);
    for (std::size_t first = 0; first < down.indices.size(); first += 3) {
        std::swap(down.indices[first], down.indices[first + 1]);
    }
    const auto occluded = [](const Primitive& a, const Primitive& b, double lower) {
        Scene scene = scene_of(a);
        add_object(scene, "other", b, {0.0, lower, 0.0});
        Settings settings = small_settings(16, 64);
        settings.layout = Layout::object;
        const HostBake bake = bake_on_host(scene, {}, settings);
        return std::pair(bake.maps.at(0).statistics.occluded_rays, bake.maps.at(1).statistics.occluded_rays);
    };
    const std::pair<std::uint64_t, std::uint64_t> none{0, 0};
    EXPECT_EQ(occluded(floor_of(0.5F), floor_of(0.5F), 0.0), none); // twice the same: neither darkens the other
    EXPECT_EQ(occluded(floor_of(0.5F), down, 0.0), none);           // back to back: a wall with two sides
    // Face to face at a distance that the offset does not bridge: black but for the rim.
    const auto apart = occluded(floor_of(0.5F), down, 1e-3);
    EXPECT_GT(apart.first, 14U * 14U * 64U * 9U / 10U);
    EXPECT_GT(apart.second, 14U * 14U * 64U * 9U / 10U);
}

} // namespace
} // namespace vkbake::test
