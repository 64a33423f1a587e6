// Small, bright surfaces: rays that seek them, against Lambert's formula for polygons.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "configuration_factors.hpp"
#include "host_bake.hpp"
#include "lit_on_host.hpp"
#include "same_bits.hpp"
#include "square_lamp.hpp"

namespace vkbake {
namespace {

using test::add_square_lamp;
using test::dark_floor;
using test::factor_of_lamp;
using test::glowing;

Settings seeking_rays(std::uint32_t rays) {
    Settings settings;
    settings.size = 48;
    settings.rays = 1;
    settings.bounces = 1;
    settings.bounce_rays = rays;
    return settings;
}

/// Of the first object's texels: root of the mean square error by the mean, and the greatest error by the mean.
struct FloorError {
    double mean = 0.0; ///< expected
    double rmse = 0.0;
    double bias = 0.0;
    double greatest = 0.0;
};

const Image& image_of(const LightMap& map) { return map.image; }

FloorError error_of_floor(const Bake& bake, const std::function<double(const glm::dvec3&)>& expected,
                          const std::function<const Image&(const LightMap&)>& image = image_of) {
    double mean = 0.0;
    std::vector<double> errors;
    for (std::uint32_t page = 0; page < bake.light_maps.size(); ++page) {
        const GeometryImage geometry = reference_geometry_image(bake.surface, bake.atlas, page);
        for (std::size_t texel = 0; texel < geometry.texel_count(); ++texel) {
            const std::uint32_t triangle = geometry.triangle[texel];
            if (triangle != GeometryImage::empty &&
                bake.surface.objects[bake.surface.parts[bake.surface.parts_of[triangle]].object].instance == 0) {
                const double value = expected(bake.surface.frame.to_world(geometry.position[texel]));
                errors.push_back(static_cast<double>(image(bake.light_maps[page]).texels[texel].g) - value);
                mean += value;
            }
        }
    }
    mean /= static_cast<double>(errors.size());
    FloorError result{.mean = mean};
    for (const double error : errors) {
        result.rmse += error * error;
        result.bias += error / mean / static_cast<double>(errors.size());
        result.greatest = std::max(result.greatest, std::abs(error) / mean);
    }
    result.rmse = std::sqrt(result.rmse / static_cast<double>(errors.size())) / mean;
    return result;
}

TEST(Emitters, ASmallLampLightsAFloorByLambertsFormula) {
    constexpr double half = 0.1;
    const glm::dvec3 lamp{0.3, 1.0, -0.4};
    Scene scene = dark_floor();
    add_square_lamp(scene, half, lamp, glowing(50.0F));
    const FloorError error = error_of_floor(test::bounced(scene, seeking_rays(16)),
                                            [&](const auto& p) { return 50.0 * factor_of_lamp(half, lamp, p); });
    // By chance: a ray in a hundred finds it, so 16 would err by more than the mean.
    EXPECT_LT(error.rmse, 0.02);
    EXPECT_LT(std::abs(error.bias), 0.003);
}

TEST(Emitters, DirectionalMapsSeekThem) {
    constexpr double half = 0.02;
    const glm::dvec3 lamp{0.3, 0.5, -0.4};
    Scene scene = dark_floor();
    add_square_lamp(scene, half, lamp, glowing(50.0F));
    Settings settings = seeking_rays(16);
    settings.directional = Switch::on;
    settings.directional_rays = 16;
    const Bake bake = test::bounced(scene, settings);
    // ∫ L ω up is what Lambert's formula gives. By chance not a ray in a thousand finds the lamp.
    const FloorError up = error_of_floor(
        bake, [&](const auto& p) { return 0.488603 * 50.0 * std::numbers::pi * factor_of_lamp(half, lamp, p); },
        [](const LightMap& map) -> const Image& { return map.directional.at(1); });
    EXPECT_LT(up.rmse, 0.02);
    EXPECT_LT(std::abs(up.bias), 0.003);
    // So small a lamp sends from one direction.
    const FloorError aside = error_of_floor(
        bake,
        [&](const glm::dvec3& p) {
            return 0.488603 * 50.0 * std::numbers::pi * factor_of_lamp(half, lamp, p) * (lamp.x - p.x) / lamp.y;
        },
        [](const LightMap& map) -> const Image& { return map.directional.at(3); });
    EXPECT_LT(std::abs(aside.rmse * aside.mean), 0.02 * up.mean);
}

TEST(Emitters, ProbesSeekThem) {
    constexpr double half = 0.02;
    Scene scene = dark_floor();
    add_square_lamp(scene, half, {0.3, 1.0, -0.4}, glowing(50.0F));
    scene.probes.push_back({.name = "below", .position = {0.3, 0.5, -0.4}});
    scene.probes.push_back({.name = "behind", .position = {0.3, 1.5, -0.4}});
    Settings settings = seeking_rays(1);
    settings.probe_rays = 256;
    const Bake bake = test::bounced(scene, settings);
    ASSERT_EQ(bake.probes.size(), 2U);
    // A square's solid angle from its axis, at half its side a and distance d: 4 asin(a² / (a² + d²)).
    const double solid_angle = 4.0 * std::asin(half * half / (half * half + 0.25));
    const double up = 4.0 * std::numbers::pi * test::element_to_parallel_rectangle(half, half, 0.5);
    const auto& below = bake.probes[0].coefficients;
    EXPECT_NEAR(double{below[0].g}, 0.282095 * 50.0 * solid_angle, 0.002 * 50.0 * solid_angle);
    EXPECT_NEAR(double{below[1].g}, 0.488603 * 50.0 * up, 0.003 * 50.0 * up);
    EXPECT_NEAR(double{below[3].g}, 0.0, 0.003 * 50.0 * up);
    EXPECT_EQ(bake.probes[1].coefficients[0], glm::vec3(0.0F));
}

TEST(Emitters, ManySmallLampsOfDifferentPowersAddUp) {
    constexpr double half = 0.025;
    std::vector<std::pair<glm::dvec3, float>> lamps;
    Scene scene = dark_floor();
    for (int x = 0; x < 6; ++x) {
        for (int z = 0; z < 6; ++z) {
            const glm::dvec3 at{0.7 * x - 1.7, 0.4 + 0.1 * ((x + 2 * z) % 5), 0.7 * z - 1.8};
            const float radiance = 20.0F + 60.0F * static_cast<float>((3 * x + z) % 4);
            lamps.emplace_back(at, radiance);
            add_square_lamp(scene, half, at, glowing(radiance));
        }
    }
    Settings settings = seeking_rays(64);
    const FloorError error = error_of_floor(test::bounced(scene, settings), [&](const glm::dvec3& point) {
        double sum = 0.0;
        for (const auto& [at, radiance] : lamps) {
            sum += static_cast<double>(radiance) * factor_of_lamp(half, at, point);
        }
        return sum;
    });
    EXPECT_LT(error.rmse, 0.05);
    EXPECT_LT(std::abs(error.bias), 0.005);
}

TEST(Emitters, ALampThatStandsOnTheFloorMakesNoSpecks) {
    // 1 × 0.5, upright at z = −0.5, looking along +Z: beside it most rays find it by themselves.
    Scene scene = dark_floor();
    Primitive lamp;
    test::add_quad(lamp, {-0.5F, 0.0F, -0.5F}, {0.5F, 0.0F, -0.5F}, {0.5F, 0.5F, -0.5F}, {-0.5F, 0.5F, -0.5F});
    test::add_object(scene, "lamp", lamp);
    test::paint(scene, 1, glowing(10.0F));
    const FloorError error = error_of_floor(test::bounced(scene, seeking_rays(64)), [](const glm::dvec3& point) {
        const double away = point.z + 0.5;
        const auto part = [&](double width) {
            return std::copysign(test::element_to_perpendicular_rectangle(0.5, std::abs(width), away), width);
        };
        return away <= 0.0 ? 0.0 : 10.0 * (part(0.5 - point.x) + part(0.5 + point.x));
    });
    EXPECT_LT(error.rmse, 0.1);
    EXPECT_LT(error.greatest, 2.0); // beside the lamp there is twenty times the mean
    EXPECT_LT(std::abs(error.bias), 0.005);
}

TEST(Emitters, ABackIsBlackUnlessItShows) {
    const glm::dvec3 lamp{0.0, 1.0, 0.0};
    const auto baked = [&](bool double_sided) {
        Scene scene = dark_floor();
        Material material = glowing(50.0F);
        material.double_sided = double_sided;
        test::add_object(scene, "lamp", test::floor_of(0.1F), lamp); // looks up
        test::paint(scene, 1, material);
        return test::bounced(scene, seeking_rays(16));
    };
    EXPECT_LT(error_of_floor(baked(true), [&](const auto& p) { return 50.0 * factor_of_lamp(0.1, lamp, p); }).rmse,
              0.02);
    const Bake dark = baked(false);
    EXPECT_TRUE(
        std::ranges::all_of(dark.light_maps[0].image.texels, [](const glm::vec4& texel) { return texel.r == 0.0F; }));
}

TEST(Emitters, BitsDependOnNoThreadAndNoAccelerator) {
    Scene scene = dark_floor();
    add_square_lamp(scene, 0.1, {0.3, 1.0, -0.4}, glowing(50.0F));
    add_square_lamp(scene, 0.05, {-0.6, 0.7, 0.2}, glowing(90.0F));
    test::add_object(scene, "post", test::box_of({-0.1F, 0.0F, -0.1F}, {0.1F, 0.5F, 0.1F}));
    Settings settings = seeking_rays(16);
    settings.threads = 1;
    const Bake one = test::bounced(scene, settings);
    settings.threads = 0;
    settings.accelerator = Accelerator::brute;
    const Bake all = test::bounced(scene, settings);
    ASSERT_EQ(one.light_maps.size(), all.light_maps.size());
    for (std::size_t page = 0; page < one.light_maps.size(); ++page) {
        EXPECT_TRUE(test::same_bits(one.light_maps[page].image.texels, all.light_maps[page].image.texels));
    }
}

} // namespace
} // namespace vkbake
