// Lamps where their light is known: the laws of a point, a cone, a disc and a sphere.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "amount.hpp"
#include "bounces.hpp"
#include "hand_made.hpp"
#include "highway_targets.hpp"
#include "host_bake.hpp"
#include "lamp_scenes.hpp"
#include "same_bits.hpp"
#include "stage_clock.hpp"
#include "trace/tracer.hpp"
#include "vkbake/error.hpp"

namespace vkbake {
namespace {

using test::black_sky;
using test::LitFloor;
using test::pi;
using test::point_lamp;
using test::spot_lamp;
using test::sun;
using test::with_rays;

TEST(Lamps, APointsLightFallsWithTheSquareAndTheCosine) {
    LitFloor floor;
    const glm::dvec3 place(0.5, 1.5, -0.25);
    std::vector<double> expected;
    for (int i = 0; i < 40; ++i) {
        const double x = -3.9 + 0.2 * i;
        const double z = 0.1 * (i % 7);
        floor.add_texel(x, z);
        const double square = glm::dot(place - glm::dvec3(x, 0, z), place - glm::dvec3(x, 0, z));
        expected.push_back(10.0 * (place.y / std::sqrt(square)) / square / pi);
    }
    const std::vector<double> found = floor.light({point_lamp(place)});
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_NEAR(found[i], expected[i], 2e-5 * expected[i]) << i;
    }
}

TEST(Lamps, ColoursAndLampsAddUp) {
    LitFloor floor;
    floor.add_texel(0.0, 0.0);
    Lamp red = point_lamp({0, 2, 0}, 8.0);
    red.color = {1.0, 0.5, 0.0};
    Lamp blue = sun({0, -1, 0}, 3.0);
    blue.color = {0.0, 0.0, 1.0};
    const glm::vec4 found = floor.trace({red, blue}).image.texels[0];
    EXPECT_NEAR(found.r, 8.0 / 4.0 / pi, 1e-5);
    EXPECT_NEAR(found.g, 4.0 / 4.0 / pi, 1e-5);
    EXPECT_NEAR(found.b, 3.0 / pi, 1e-5);
}

TEST(Lamps, ASpotHasAConeWithASoftEdge) {
    constexpr double height = 2.0;
    constexpr double inner = 0.3;
    constexpr double outer = 0.6;
    const std::array<double, 9> angles{0.0, 0.15, 0.29, 0.35, 0.45, 0.55, 0.59, 0.61, 0.9};
    LitFloor floor;
    for (const double angle : angles) {
        floor.add_texel(height * std::tan(angle), 0.0);
    }
    const std::vector<double> found = floor.light({spot_lamp({0, height, 0}, {0, -1, 0}, inner, outer)});
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const double cosine = std::cos(angles[i]);
        const double full = 10.0 * cosine * (cosine * cosine / (height * height)) / pi;
        const double ramp = std::clamp((cosine - std::cos(outer)) / (std::cos(inner) - std::cos(outer)), 0.0, 1.0);
        EXPECT_NEAR(found[i], full * ramp * ramp, 2e-5 * full) << angles[i];
        EXPECT_EQ(found[i] == 0.0, angles[i] > outer) << angles[i];
    }
}

TEST(Lamps, ARangeEndsALight) {
    LitFloor floor;
    for (const double x : {0.0, 1.0, 2.0, 2.7, 3.0}) {
        floor.add_texel(x, 0.0);
    }
    Lamp lamp = point_lamp({0, 1, 0});
    lamp.range = 3.0;
    const std::vector<double> found = floor.light({lamp});
    std::size_t texel = 0;
    for (const double x : {0.0, 1.0, 2.0, 2.7, 3.0}) {
        const double square = x * x + 1.0;
        const double full = 10.0 / (square * std::sqrt(square)) / pi;
        EXPECT_NEAR(found[texel], full * std::max(1.0 - square * square / 81.0, 0.0), 2e-5 * full) << x;
        ++texel;
    }
    EXPECT_EQ(found[4], 0.0);
}

TEST(Lamps, ADirectionalLampGivesItsLuxTimesTheCosine) {
    LitFloor floor;
    floor.add_texel(-3.0, 2.0);
    floor.add_texel(0.0, 0.0);
    floor.add_texel(3.9, -3.9);
    for (const double found : floor.light({sun({3, -4, 0}, 5.0)})) {
        EXPECT_NEAR(found, 5.0 * 0.8 / pi, 1e-6);
    }
    for (const double found : floor.light({sun({3, 1, 0}, 5.0)})) { // from below
        EXPECT_EQ(found, 0.0);
    }
}

TEST(Lamps, LieNeitherBelowTheSurfaceNorBehindTheShadingNormal) {
    LitFloor floor;
    floor.add_texel(0.0, 0.0);
    floor.turn_shading_normal({-1, 0.2F, 0}); // the lamp is above the surface, behind this
    floor.add_texel(1.0, 0.0);
    floor.turn_shading_normal({1, 1, 0});
    const std::vector<double> from_right = floor.light({sun({-1, -0.5, 0}, 1.0), sun({-1, -0.5, 0}, 1.0, 5.0)});
    EXPECT_EQ(from_right[0], 0.0);
    EXPECT_NEAR(from_right[1], 2.0 * (1.5 / std::sqrt(2.5)) / pi, 1e-3); // the shading normal's cosine
    // Above what it is shaded by, below the surface that it lies on.
    EXPECT_EQ(floor.light({sun({-1, 0.1, 0}, 1.0), sun({-1, 0.1, 0}, 1.0, 5.0)})[1], 0.0);
}

TEST(Lamps, AWallHidesALamp) {
    LitFloor floor;
    floor.add_quad({0, 0, 3}, {0, 0, -3}, {0, 2, -3}, {0, 2, 3});
    floor.add_texel(1.0, 0.0);
    floor.add_texel(-1.0, 0.0);
    for (Lamp lamp : {point_lamp({1, 1, 0}), spot_lamp({1, 1, 0}, {-1, -1, 0}, 0.7, 1.5), sun({-1, -1, 0}, 1.0)}) {
        for (const bool soft : {false, true}) {
            lamp.radius = soft ? 0.05 : 0.0;
            lamp.angular_diameter = soft ? 1.0 : 0.0;
            const LightMap map = floor.trace({lamp}, with_rays(16));
            EXPECT_GT(map.image.texels[0].r, 0.0F);
            EXPECT_EQ(map.image.texels[1].r, 0.0F);
        }
    }
}

TEST(Lamps, ALampInASurfaceIsNotHiddenByIt) {
    LitFloor floor;
    floor.add_quad({-2, 2, -2}, {2, 2, -2}, {2, 2, 2}, {-2, 2, 2}); // faces down
    for (int i = 0; i < 64; ++i) {
        floor.add_texel(0.03 * i, 0.017 * i);
    }
    for (const double found : floor.light({point_lamp({0.1, 2, 0.1})})) {
        EXPECT_GT(found, 0.0);
    }
}

TEST(Lamps, ALampInAClosedBoxLightsItAndNothingElse) {
    test::SurfaceMaker maker;
    const std::uint32_t inside = maker.add_box({-0.5F, 0.0F, -0.5F}, {0.5F, 0.5F, 0.5F}, true);
    const std::uint32_t floor = maker.add_quad({-1, -0.25F, 1}, {1, -0.25F, 1}, {1, -0.25F, -1}, {-1, -0.25F, -1});
    const Surface surface = maker.finish(test::lit_exponent);
    std::vector<test::SamplePoint> points;
    for (std::uint32_t face = 0; face < 12; ++face) {
        points.push_back(test::point_on(surface, inside + face, glm::dvec3(1.0 / 3.0)));
    }
    points.push_back(test::point_on(surface, floor, {0.5, 0.25, 0.25}));
    Lamp soft = point_lamp({0, 1, 0});
    soft.radius = 0.2;
    for (const Lamp& lamp : {point_lamp({0, 1, 0}), soft}) {
        const LightMap map =
            Tracer(surface, black_sky(), {}, std::vector<Lamp>{lamp}).trace(test::geometry_image(points, 16));
        for (std::size_t face = 0; face < 12; ++face) {
            EXPECT_GT(map.image.texels[face].r, 0.1F) << face;
        }
        EXPECT_EQ(map.image.texels[12].r, 0.0F);
    }
}

TEST(Lamps, TheSkysIntensityIsNotTheirs) {
    LitFloor floor;
    floor.add_texel(0.0, 0.0);
    Sky sky = black_sky();
    for (const double intensity : {0.0, 1.0, 3.0}) {
        sky.intensity = intensity;
        EXPECT_NEAR(floor.trace({point_lamp({0, 1, 0})}, {}, sky).image.texels[0].r, 10.0 / pi, 1e-4) << intensity;
    }
    EXPECT_NEAR(floor.trace({point_lamp({0, 1, 0})}, {}, test::white_sky()).image.texels[0].r, 1.0 + 10.0 / pi, 1e-4);
}

TEST(Lamps, EverySamplerGivesTheSameLight) {
    LitFloor floor;
    floor.add_texel(1.0, 0.5);
    Settings thesis;
    thesis.sampler = Sampler::thesis;
    Lamp soft = point_lamp({0, 1, 0});
    soft.radius = 0.1;
    for (const Lamp& lamp : {point_lamp({0, 1, 0}), soft}) {
        EXPECT_NEAR(floor.light({lamp}, thesis)[0], floor.light({lamp})[0], 1e-5);
    }
}

TEST(Lamps, AreLeftOutWhereTheyAreNotAskedFor) {
    LitFloor floor;
    floor.add_texel(0.0, 0.0);
    Settings settings;
    settings.lamps = Switch::off;
    EXPECT_EQ(floor.light({point_lamp({0, 1, 0})}, settings)[0], 0.0);
    settings.lamps = Switch::on;
    settings.mode = Mode::ao;
    EXPECT_EQ(floor.light({point_lamp({0, 1, 0})}, settings)[0], 1.0);
}

TEST(Lamps, ThatCannotBeAreRefused) {
    LitFloor floor;
    floor.add_texel(0.0, 0.0);
    const auto refused = [&](const auto& change) {
        Lamp lamp = point_lamp({0, 1, 0});
        change(lamp);
        EXPECT_THROW((void)floor.trace({lamp}), Error);
    };
    refused([](Lamp& l) { l.intensity = -1.0; });
    refused([](Lamp& l) { l.intensity = NAN; });
    refused([](Lamp& l) { l.intensity = 1e38; }); // beside it more than a float holds
    refused([](Lamp& l) { l.position.x = INFINITY; });
    refused([](Lamp& l) { l.direction = {0, 2, 0}; });
    refused([](Lamp& l) { l.inner_cone = 1.0; });
    refused([](Lamp& l) { l.range = 0.0; });
    refused([](Lamp& l) { l.radius = -1.0; });
}

std::vector<Lamp> many_lamps() {
    std::vector<Lamp> lamps;
    for (int i = 0; i < 20; ++i) {
        lamps.push_back(point_lamp({0.4 * i - 3.5, 0.5 + 0.1 * i, 0.3 * (i % 5)}, 1.0 + i));
        lamps.back().radius = i % 6 == 0 ? 0.15 : 0.0;
        lamps.back().range = 2.5 + 0.1 * i;
    }
    lamps.push_back(spot_lamp({1, 3, 1}, {-1, -2, 0}, 0.2, 0.5));
    lamps.push_back(spot_lamp({-1, 3, 1}, {1, -2, 0}, 0.2, 0.5));
    lamps.back().radius = 0.3;
    lamps.push_back(sun({1, -1, 0.5}, 2.0));
    lamps.push_back(sun({-1, -1, 0.5}, 2.0, 4.0));
    return lamps;
}

TEST(Lamps, GiveTheSameBitsHoweverTheyAreTraced) {
    test::SurfaceMaker maker;
    const std::uint32_t floor = maker.add_quad({-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1});
    maker.add_box({-0.3F, 0.1F, -0.2F}, {-0.1F, 0.3F, 0.2F}, false);
    maker.add_box({0.2F, 0.0F, -0.2F}, {0.3F, 0.5F, 0.1F}, false);
    const Surface surface = maker.finish(test::lit_exponent);
    std::vector<test::SamplePoint> points;
    points.reserve(150);
    for (int i = 0; i < 150; ++i) {
        points.push_back(test::point_on(surface, floor, {0.6 - 0.004 * i, 0.3, 0.1 + 0.004 * i}));
    }
    const GeometryImage geometry = test::geometry_image(points, 16);
    const std::vector<Lamp> lamps = many_lamps();
    std::vector<Lamp> reversed = lamps;
    std::ranges::reverse(reversed);
    Settings settings = with_rays(test::amount(50U, 10U));
    settings.accelerator = Accelerator::brute;
    settings.threads = 1;
    const LightMap oracle = Tracer(surface, {}, settings, lamps).trace(geometry);
    EXPECT_GT(oracle.statistics.lamp_rays, 1000U);
    for (const Accelerator accelerator : {Accelerator::brute, Accelerator::clusters, Accelerator::bvh}) {
        for (const int threads : {1, 2}) {
            settings.accelerator = accelerator;
            settings.threads = threads;
            const LightMap found = Tracer(surface, {}, settings, lamps).trace(geometry);
            EXPECT_TRUE(test::same_bits(found.image.texels, oracle.image.texels));
            EXPECT_EQ(found.statistics.lamp_rays, oracle.statistics.lamp_rays);
            EXPECT_EQ(found.statistics.lamps_reached, oracle.statistics.lamps_reached);
            const LightMap other = Tracer(surface, {}, settings, reversed).trace(geometry);
            EXPECT_TRUE(test::same_bits(other.image.texels, oracle.image.texels));
        }
    }
    const Tracer tracer(surface, {}, settings, lamps);
    test::for_every_target(
        [&] { EXPECT_TRUE(test::same_bits(tracer.trace(geometry).image.texels, oracle.image.texels)); });
}

TEST(Lamps, InAClosedRoomAllFluxArrivesAndIsReflectedAsBounces) {
    // ∫ E dA over the walls is the flux of the lamp, 4 π I; of a bounce ρ times the last.
    Primitive walls = test::box_of({-2, 0, -1}, {2, 2, 1});
    for (std::size_t first = 0; first < walls.indices.size(); first += 3) {
        std::swap(walls.indices[first + 1], walls.indices[first + 2]);
    }
    Scene room = test::scene_of(walls);
    test::paint(room, 0, {.base_color = {0.5F, 0.5F, 0.5F, 1.0F}});
    room.lamps = {point_lamp({0.3, 1.1, -0.1}, 3.0)};
    Settings settings = with_rays(16);
    settings.size = test::amount(128, 48);
    settings.bounces = 1;
    settings.bounce_rays = test::amount(64U, 16U);
    Bake bake{.settings = settings};
    bake.surface = make_surface(room);
    bake.atlas = make_atlas(room, bake.surface, settings);
    const Tracer tracer(bake.surface, black_sky(), settings, room.lamps);
    const GeometryImage geometry = reference_geometry_image(bake.surface, bake.atlas, 0);
    bake.light_maps.push_back(tracer.trace(geometry));
    const auto mean = [&] {
        double sum = 0.0;
        for (const glm::vec4& texel : bake.light_maps[0].image.texels) {
            sum += double{texel.g};
        }
        return sum / static_cast<double>(bake.light_maps[0].statistics.covered_texels);
    };
    const double direct = mean();
    const double area = 2.0 * (4.0 * 2.0 + 2.0 * 2.0 + 4.0 * 2.0);
    EXPECT_NEAR(direct * pi * area, 4.0 * pi * 3.0, test::amount(0.03, 0.1) * 4.0 * pi * 3.0);
    const Progress silent;
    StageClock clock(silent);
    add_bounces(
        room, tracer, [&](std::size_t) -> const GeometryImage& { return geometry; }, clock, bake);
    EXPECT_NEAR((mean() - direct) / direct, 0.5, test::amount(0.02, 0.06));
}

} // namespace
} // namespace vkbake
