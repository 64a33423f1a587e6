// What a map with bounces says of its own error, held against the truth.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "amount.hpp"
#include "bounce_error.hpp"
#include "lit_on_host.hpp"
#include "square_lamp.hpp"
#include "trace/contrasts.hpp"
#include "trace/known_light.hpp"

namespace vkbake {
namespace {

/// A black floor under a square lamp, which hides its part of a sky. The lamp is turned, so that its borders lie askew
/// to all strata.
struct LampAndSky {
    double half = 0.0;
    double radiance = 0.0;
    double sky = 0.0;
    glm::dvec3 lamp{0.3, 1.0, -0.4};
    glm::dvec3 along{std::cos(0.5), 0.0, std::sin(0.5)}; ///< the lamp's own axes
    glm::dvec3 across{-std::sin(0.5), 0.0, std::cos(0.5)};

    [[nodiscard]] Bake bake(const Settings& settings) const {
        Scene scene = test::dark_floor();
        test::add_square_lamp(scene, half, lamp, test::glowing(static_cast<float>(radiance)));
        scene.instances.back().linear = glm::dmat3(along, glm::dvec3(0, 1, 0), across);
        return test::bounced(scene, settings, glm::vec3(static_cast<float>(sky)));
    }

    [[nodiscard]] double truth(const glm::dvec3& point) const {
        const glm::dvec3 from_lamp(glm::dot(point - lamp, along), 0.0, glm::dot(point - lamp, across));
        const double factor = test::factor_of_lamp(half, {0.0, lamp.y, 0.0}, from_lamp);
        return radiance * factor + sky * (1.0 - factor);
    }
};

Settings estimated(std::uint32_t rays) {
    Settings settings;
    settings.size = 48;
    settings.rays = rays;
    settings.bounces = 1;
    settings.bounce_rays = rays;
    settings.estimate_error = true;
    return settings;
}

/// Of the floor's texels.
struct FloorTally {
    double texels = 0.0;
    double right = 0.0; ///< with the truth in their interval of 95 %
    double squares = 0.0;
    double told_squares = 0.0;
    double truth = 0.0;

    void add(const Bake& bake, const LampAndSky& floor) {
        const GeometryImage geometry = reference_geometry_image(bake.surface, bake.atlas, 0);
        const LightMap& map = bake.light_maps[0];
        for (std::size_t texel = 0; texel < geometry.texel_count(); ++texel) {
            const std::uint32_t triangle = geometry.triangle[texel];
            if (triangle == GeometryImage::empty ||
                bake.surface.objects[bake.surface.parts[bake.surface.parts_of[triangle]].object].instance != 0) {
                continue;
            }
            const double expected = floor.truth(bake.surface.frame.to_world(geometry.position[texel]));
            const double off = static_cast<double>(map.image.texels[texel].g) - expected;
            const auto told = static_cast<double>(map.standard_error[texel]);
            texels += 1.0;
            right += std::abs(off) <= interval_95 * told ? 1.0 : 0.0;
            squares += off * off;
            told_squares += told * told;
            truth += expected;
        }
    }
};

TEST(BounceError, IntervalsHoldTheTruth) {
    // A small lamp that rays seek beside a dim sky; a wide one that most rays meet; one that is all the light there is.
    for (const LampAndSky& floor : {LampAndSky{0.1, 30.0, 0.2}, LampAndSky{1.0, 1.0, 0.6}, LampAndSky{0.5, 5.0, 0.0}}) {
        FloorTally tally;
        for (std::uint32_t seed = 1; seed <= test::amount(16U, 4U); ++seed) {
            Settings settings = estimated(64);
            settings.seed = seed;
            tally.add(floor.bake(settings), floor);
        }
        EXPECT_GE(tally.right / tally.texels, 0.93) << floor.half;
        if (test::few_samples) {
            continue; // how large errors are, one map's tell too roughly
        }
        const double told = std::sqrt(tally.told_squares / tally.squares);
        EXPECT_GE(told, 0.9) << floor.half;
        if (floor.half > 0.3) { // of a smaller one most texels' rays meet nothing, and what they may have missed counts
            EXPECT_LE(tally.right / tally.texels, 0.97) << floor.half;
            EXPECT_LE(told, 1.1) << floor.half;
        }
    }
}

/// Root of the mean square error over the mean.
double relative_error(const FloorTally& tally) {
    return std::sqrt(tally.squares / tally.texels) / (tally.truth / tally.texels);
}

TEST(BounceError, WhatIsAskedForIsOfAllLight) {
    const LampAndSky floor{0.5, 3.0, 0.5};
    for (const double target : {0.02, 0.005}) {
        Settings settings = estimated(64);
        settings.estimate_error = false;
        settings.target_error = target;
        FloorTally tally;
        double told = 0.0;
        const auto seeds = test::amount(16U, 4U);
        for (settings.seed = 1; settings.seed <= seeds; ++settings.seed) {
            const Bake bake = floor.bake(settings);
            ASSERT_TRUE(bake.light_maps[0].error.has_value());
            EXPECT_TRUE(bake.light_maps[0].error->target_reached);
            EXPECT_LE(bake.light_maps[0].error->relative_rmse, target);
            told += bake.light_maps[0].error->relative_rmse / seeds;
            tally.add(bake, floor);
        }
        EXPECT_GE(told, 0.9 * target);
        EXPECT_NEAR(relative_error(tally), target, 0.15 * target);
    }
}

LightMap map_of(const std::vector<float>& light, const std::vector<float>& errors, double relative_rmse) {
    LightMap map;
    map.image = {.width = static_cast<int>(light.size()), .height = 1, .texels = {}, .coverage = {}};
    for (const float value : light) {
        map.image.texels.emplace_back(value, value, value, 1.0F);
    }
    map.image.coverage.assign(light.size(), 1.0F);
    map.standard_error = errors;
    map.error = MapError{.relative_rmse = relative_rmse};
    return map;
}

TEST(BounceError, ErrorsAddUpByTheirSquares) {
    LightMap map = map_of({1.0F, 3.0F}, {0.3F, 0.0F}, 0.05);
    map.error->noise_rmse = 0.1; // before it was denoised: 0.2 of light
    const KnownLight known = known_light(map).value();
    EXPECT_NEAR(known.mean, 2.0, 1e-6);
    EXPECT_NEAR(known.variance, 0.1 * 0.1, 1e-8);
    LightMap gathered = map_of({1.0F, 1.0F}, {0.4F, 0.2F}, 0.06); // of both: 0.18
    gathered.error->target_reached = false;
    add_bounce(gathered, map);
    EXPECT_EQ(map.image.texels[1], glm::vec4(4.0F, 4.0F, 4.0F, 1.0F));
    EXPECT_FLOAT_EQ(map.standard_error[0], 0.5F);
    EXPECT_FLOAT_EQ(map.standard_error[1], 0.2F);
    EXPECT_EQ(map.error->relative_rmse, 0.06);
    EXPECT_NEAR(map.error->percentile_99, 0.5 / 3.0, 1e-6);
    EXPECT_NEAR(map.error->noise_rmse, std::sqrt(0.2 * 0.2 + 0.18 * 0.18 - 0.1 * 0.1) / 3.0, 1e-6);
    EXPECT_FALSE(map.error->target_reached);
    LightMap untold;
    EXPECT_FALSE(known_light(untold).has_value());
}

} // namespace
} // namespace vkbake
