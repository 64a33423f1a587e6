// A sky's sun, sampled on its own: the light that it is known to give, and how little noise is left.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "amount.hpp"
#include "hand_made.hpp"
#include "highway_targets.hpp"
#include "same_bits.hpp"
#include "trace/tracer.hpp"

namespace vkbake {
namespace {

constexpr int sky_width = 128;
constexpr int sky_height = 64;
constexpr int sun_x = 100;
constexpr int sun_y = 20;

/// A grey sky, one texel of it the sun.
Sky sunny_sky(float grey, float bright) {
    Image image{.width = sky_width, .height = sky_height};
    for (int y = 0; y < sky_height; ++y) {
        for (int x = 0; x < sky_width; ++x) {
            image.texels.emplace_back(glm::vec3(x == sun_x && y == sun_y ? bright : grey), 1.0F);
        }
    }
    return {.source = EquirectangularSky{std::move(image)}, .name = "sunny"};
}

/// The sun's share of E/π of an open surface that faces `normal`: the bilinear tent of its texel, summed up in double.
double light_of_sun(double excess, const glm::dvec3& normal) {
    constexpr int steps = 400;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        for (int j = 0; j < steps; ++j) {
            const double right = 2.0 * (i + 0.5) / steps - 1.0;
            const double down = 2.0 * (j + 0.5) / steps - 1.0;
            const double around = 2.0 * std::numbers::pi * ((sun_x + right + 0.5) / sky_width - 0.5);
            const double polar = std::numbers::pi * (sun_y + down + 0.5) / sky_height;
            const glm::dvec3 direction(std::sin(polar) * std::cos(around), std::cos(polar),
                                       std::sin(polar) * std::sin(around));
            sum += (1.0 - std::abs(right)) * (1.0 - std::abs(down)) * std::sin(polar) *
                   std::max(glm::dot(direction, normal), 0.0);
        }
    }
    const double area = 2.0 * std::numbers::pi / sky_width * std::numbers::pi / sky_height * 4.0 / (steps * steps);
    return excess * sum * area / std::numbers::pi;
}

struct Yard {
    Surface surface;
    GeometryImage geometry;
};

/// A floor, and on it, where asked for, a block whose shadow crosses it.
Yard make_yard(bool with_block) {
    test::SurfaceMaker maker;
    const std::uint32_t floor = maker.add_quad({-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1});
    if (with_block) {
        maker.add_box({-0.2F, 0.0F, -0.2F}, {0.2F, 0.5F, 0.2F}, false);
    }
    Yard yard{.surface = maker.finish()};
    std::vector<test::SamplePoint> points;
    const int side = test::amount(16, 8);
    for (int i = 0; i < side * side; ++i) {
        const double a = (i % side + 0.5) / side;
        const int row = i / side;
        const double b = (1.0 - a) * (row + 0.5) / side;
        points.push_back(test::point_on(yard.surface, floor + (i % 2 == 0 ? 0U : 1U), {a, b, 1.0 - a - b}));
    }
    yard.geometry = test::geometry_image(points, side);
    return yard;
}

Settings rays_of(std::uint32_t rays, Switch sun) {
    Settings settings;
    settings.rays = rays;
    settings.sun = sun;
    return settings;
}

LightMap trace(const Yard& yard, const Sky& sky, const Settings& settings) {
    return Tracer(yard.surface, sky, settings).trace(yard.geometry);
}

double rms_difference(const LightMap& a, const LightMap& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.image.texels.size(); ++i) {
        const double difference = double{a.image.texels[i].g} - double{b.image.texels[i].g};
        sum += difference * difference;
    }
    return std::sqrt(sum / static_cast<double>(a.image.texels.size()));
}

TEST(Sun, LightsAnOpenFloorByItsTexelsTent) {
    const Yard yard = make_yard(false);
    const double sun = light_of_sun(9999.0, {0, 1, 0});
    EXPECT_GT(sun, 1.0);
    for (const double intensity : {1.0, 0.25}) {
        Sky sky = sunny_sky(1.0F, 10000.0F);
        sky.intensity = intensity;
        const LightMap map = trace(yard, sky, rays_of(256, Switch::on));
        EXPECT_GT(map.statistics.peak_rays, 0U);
        for (const glm::vec4& texel : map.image.texels) {
            EXPECT_NEAR(texel.g, intensity * (1.0 + sun), intensity * 2e-3 * sun);
        }
    }
}

TEST(Sun, IsFoundWhereverTheSkyIsTurned) {
    // Upright texels that face the sun's azimuth, whichever way it is turned, and one that faces away.
    Sky sky = sunny_sky(0.0F, 10000.0F);
    for (const double degrees : {0.0, 90.0, 200.0}) {
        sky.rotation_degrees = degrees;
        // Counter-clockwise seen from above: what was towards +X comes towards −Z.
        const double around = 2.0 * std::numbers::pi * ((sun_x + 0.5) / sky_width - 0.5);
        const double turned = around - degrees * std::numbers::pi / 180.0;
        test::SurfaceMaker maker;
        const std::uint32_t triangle = maker.add({-0.1F, 0, 0}, {0.1F, 0, 0}, {0, 0.1F, 0});
        const Surface surface = maker.finish();
        test::SamplePoint facing = test::point_on(surface, triangle, glm::dvec3(1.0 / 3.0));
        facing.geometric_normal = facing.shading_normal = glm::vec3(std::cos(turned), 0.0, std::sin(turned));
        test::SamplePoint away = facing;
        away.geometric_normal = away.shading_normal = -facing.shading_normal;
        const LightMap map =
            Tracer(surface, sky, rays_of(256, Switch::on)).trace(test::geometry_image({facing, away}, 2));
        const double expected = light_of_sun(10000.0, {std::cos(around), 0.0, std::sin(around)});
        EXPECT_NEAR(map.image.texels[0].g, expected, 3e-3 * expected) << degrees;
        EXPECT_EQ(map.image.texels[1].g, 0.0F);
    }
}

LightMap trace_many(const Yard& yard, const Sky& sky) {
    Settings settings = rays_of(test::amount(16384U, 2048U), Switch::on);
    settings.seed = 7;
    return trace(yard, sky, settings);
}

TEST(Sun, LeavesATenthOfTheNoiseAtEqualRays) {
    const Yard yard = make_yard(true);
    const Sky sky = sunny_sky(1.0F, 100000.0F);
    const LightMap truth = trace_many(yard, sky);
    const LightMap whole = trace(yard, sky, rays_of(512, Switch::off));
    const LightMap parted = trace(yard, sky, rays_of(256, Switch::on));
    EXPECT_EQ(whole.statistics.peak_rays, 0U);
    EXPECT_LE(parted.statistics.rays + parted.statistics.peak_rays, whole.statistics.rays);
    EXPECT_LT(rms_difference(parted, truth), 0.1 * rms_difference(whole, truth));
}

TEST(Sun, EstimatesCountItsNoise) {
    const Yard yard = make_yard(true);
    const Sky sky = sunny_sky(1.0F, 100000.0F);
    const LightMap truth = trace_many(yard, sky);
    Settings settings = rays_of(64, Switch::on);
    settings.estimate_error = true;
    double real = 0.0;
    double estimated = 0.0;
    for (std::uint64_t seed = 100; seed < 100 + test::amount<std::uint64_t>(8, 3); ++seed) {
        settings.seed = seed;
        const LightMap map = trace(yard, sky, settings);
        const double difference = rms_difference(map, truth);
        real += difference * difference;
        double mean = 0.0;
        for (const glm::vec4& texel : map.image.texels) {
            mean += double{texel.g} / static_cast<double>(map.image.texels.size());
        }
        estimated += map.error.value().relative_rmse * mean * map.error->relative_rmse * mean;
    }
    if (!test::few_samples) { // which hardly meet the shadow's border, where the noise is
        EXPECT_NEAR(std::sqrt(estimated / real), 1.0, 0.4);
    }
    settings.target_error = 0.01;
    EXPECT_TRUE(trace(yard, sky, settings).error.value().target_reached);
}

TEST(Sun, GivesTheSameBitsHoweverItIsTraced) {
    const Yard yard = make_yard(true);
    const Sky sky = sunny_sky(0.5F, 50000.0F);
    Settings settings = rays_of(50, Switch::on);
    settings.accelerator = Accelerator::brute;
    settings.threads = 1;
    const LightMap oracle = trace(yard, sky, settings);
    for (const Accelerator accelerator : {Accelerator::clusters, Accelerator::bvh}) {
        for (const int threads : {1, 2}) {
            settings.accelerator = accelerator;
            settings.threads = threads;
            const LightMap found = trace(yard, sky, settings);
            EXPECT_TRUE(test::same_bits(found.image.texels, oracle.image.texels));
            EXPECT_EQ(found.statistics.peak_rays, oracle.statistics.peak_rays);
        }
    }
    const Tracer tracer(yard.surface, sky, settings);
    test::for_every_target(
        [&] { EXPECT_TRUE(test::same_bits(tracer.trace(yard.geometry).image.texels, oracle.image.texels)); });
}

TEST(Sun, SkiesWithoutOneAreTracedAsBefore) {
    const Yard yard = make_yard(true);
    for (const Sky& sky : {sunny_sky(1.0F, 1.5F), test::white_sky(), Sky()}) {
        const LightMap on = trace(yard, sky, rays_of(32, Switch::on));
        EXPECT_EQ(on.statistics.peak_rays, 0U);
        EXPECT_TRUE(test::same_bits(on.image.texels, trace(yard, sky, rays_of(32, Switch::off)).image.texels));
    }
}

} // namespace
} // namespace vkbake
