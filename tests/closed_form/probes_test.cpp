// Light probes where the light is known.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "amount.hpp"
#include "host_bake.hpp"
#include "lamp_scenes.hpp"
#include "lit_on_host.hpp"
#include "panorama.hpp"
#include "vkbake_light.h"

namespace vkbake {
namespace {

Settings few_probe_rays(std::uint32_t rays) {
    Settings settings;
    settings.size = 16;
    settings.rays = 16;
    settings.probe_rays = rays;
    return settings;
}

/// What a probe's light would be for a normal: E/π.
glm::dvec3 light_at(const LightProbe& probe, const glm::dvec3& normal) {
    std::array<glm::vec3, 9> coefficients = probe.coefficients;
    return shared::vkbake_probe_light(coefficients.data(), glm::vec3(normal));
}

/// A speck far below: next to nothing of a sky is hidden.
Scene speck() { return test::scene_of(test::floor_of(0.001F), {0, -1, 0}); }

Scene with_probe(Scene scene, const glm::dvec3& position) {
    scene.probes.push_back({.name = "probe", .position = position});
    return scene;
}

Sky quadratic_sky() {
    return test::panorama_of(128, [](const glm::dvec3& d) {
        return glm::dvec3(1.0 + 0.5 * d.x, 2.0 + d.y - 0.5 * d.z, 1.0 + 0.75 * d.x * d.z);
    });
}

TEST(Probes, ASkyOfTwoBandsIsExact) {
    const Bake bake = test::bounced(with_probe(speck(), {0.25, 0.5, 0.0}), few_probe_rays(4096), quadratic_sky());
    ASSERT_EQ(bake.probes.size(), 1U);
    const LightProbe& probe = bake.probes[0];
    // ∫ ω ωᵀ = 4π/3 over the sphere; ∫ x² z² = 4π/15.
    const double all = std::sqrt(4.0 * test::pi); // of 1
    const double along = std::sqrt(4.0 * test::pi / 3.0);
    const double across = 1.0925484305920792 * 4.0 * test::pi / 15.0;
    const std::array<glm::dvec3, 9> expected{glm::dvec3(all, 2.0 * all, all),
                                             glm::dvec3(0.0, along, 0.0),
                                             glm::dvec3(0.0, -0.5 * along, 0.0),
                                             glm::dvec3(0.5 * along, 0.0, 0.0),
                                             glm::dvec3(0.0),
                                             glm::dvec3(0.0),
                                             glm::dvec3(0.0),
                                             glm::dvec3(0.0, 0.0, 0.75 * across),
                                             glm::dvec3(0.0)};
    for (std::size_t i = 0; i < 9; ++i) {
        EXPECT_LT(glm::length(glm::dvec3(probe.coefficients[i]) - expected[i]), 6e-3) << i;
    }
    EXPECT_LT(probe.back_sides, 0.001);
    // E/π: A_l/π is 1, 2/3, 1/4.
    const glm::dvec3 n = glm::normalize(glm::dvec3(0.3, -0.5, 0.8));
    const glm::dvec3 light(1.0 + n.x / 3.0, 2.0 + 2.0 / 3.0 * n.y - n.z / 3.0, 1.0 + 0.25 * 0.75 * n.x * n.z);
    EXPECT_LT(glm::length(light_at(probe, n) - light), 4e-3);
}

/// A room of 4 m × 2 m × 2 m that looks inwards.
Scene lit_room() {
    Scene scene = test::scene_of(test::box_of({-2, 0, -1}, {2, 2, 1}));
    auto& indices = scene.meshes[0].primitives[0].indices;
    for (std::size_t first = 0; first < indices.size(); first += 3) {
        std::swap(indices[first + 1], indices[first + 2]);
    }
    test::paint(scene, 0, {.base_color = {0.5F, 0.8F, 0.0F, 1.0F}, .emissive = {1.0F, 0.25F, 3.0F}});
    return scene;
}

TEST(Probes, InAFurnaceLightIsTheSameFromAllSides) {
    // What leaves the walls after n bounces: e (1 + ρ + … + ρⁿ).
    Settings settings = few_probe_rays(256);
    settings.bounces = 2;
    settings.bounce_rays = 16;
    const Bake bake = test::bounced(with_probe(lit_room(), {1.5, 0.25, 0.5}), settings);
    const glm::dvec3 expected(1.0 * (1.0 + 0.5 + 0.25), 0.25 * (1.0 + 0.8 + 0.64), 3.0);
    ASSERT_EQ(bake.probes.size(), 1U);
    for (const glm::dvec3 normal : {glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0.6, 0.64, -0.48)}) {
        EXPECT_LT(glm::length(light_at(bake.probes[0], normal) - expected), 0.02);
    }
    EXPECT_LT(glm::length(glm::dvec3(bake.probes[0].coefficients[0]) - std::sqrt(4.0 * test::pi) * expected), 1e-4);
    EXPECT_EQ(bake.probes[0].back_sides, 0.0);
}

TEST(Probes, InsideABodyAllIsBackSides) {
    Scene scene = test::scene_of(test::box_of({-1, -1, -1}, {1, 1, 1}));
    scene = with_probe(with_probe(scene, {0.0, 0.5, 0.0}), {0.0, 3.0, 0.0});
    const Bake bake = test::bounced(scene, few_probe_rays(64), glm::vec3(1.0F));
    EXPECT_EQ(bake.probes.at(0).back_sides, 1.0);
    EXPECT_EQ(bake.probes.at(0).coefficients[0], glm::vec3(0.0F));
    EXPECT_EQ(bake.probes.at(1).back_sides, 0.0);
    test::paint(scene, 0, {.double_sided = true});
    EXPECT_EQ(test::bounced(scene, few_probe_rays(64), glm::vec3(1.0F)).probes.at(0).back_sides, 0.0);
}

TEST(Probes, SeeLampsFromEverywhere) {
    Scene scene = with_probe(speck(), {0.0, 0.5, 0.0});
    const glm::dvec3 below(0.5, -0.5, 0.25);
    for (const double radius : {0.0, 0.05}) {
        Lamp lamp = test::point_lamp(below, 6.0);
        lamp.radius = radius;
        scene.lamps = {lamp};
        const LightProbe probe = test::bounced(scene, few_probe_rays(256)).probes.at(0);
        const glm::dvec3 way = below - glm::dvec3(0.0, 0.5, 0.0);
        const glm::dvec3 d = glm::normalize(way);
        const double light = 6.0 / glm::dot(way, way);
        EXPECT_NEAR(double{probe.coefficients[0].g}, 0.282095 * light, 2e-3 * light);
        EXPECT_NEAR(double{probe.coefficients[1].g}, 0.488603 * d.y * light, 2e-3 * light);
        EXPECT_NEAR(double{probe.coefficients[3].g}, 0.488603 * d.x * light, 2e-3 * light);
        EXPECT_NEAR(double{probe.coefficients[6].g}, 0.315392 * (3.0 * d.z * d.z - 1.0) * light, 3e-3 * light);
    }
}

TEST(Probes, AGridHasTheMiddlesOfTheBoxesCells) {
    Scene scene = with_probe(lit_room(), {1.0, 1.0, 0.0});
    Settings settings = few_probe_rays(16);
    settings.probe_grid = {4, 2, 1};
    const Bake bake = test::bounced(scene, settings);
    ASSERT_EQ(bake.probes.size(), 9U);
    ASSERT_TRUE(bake.probe_grid.has_value());
    EXPECT_EQ(bake.probe_grid->first_probe, 1U);
    EXPECT_LT(glm::length(bake.probe_grid->step - glm::dvec3(1, 1, 2)), 1e-6);
    EXPECT_EQ(bake.probes[0].name, "probe");
    EXPECT_LT(glm::length(bake.probes[1].position - glm::dvec3(-1.5, 0.5, 0.0)), 1e-6);
    EXPECT_LT(glm::length(bake.probes[2].position - glm::dvec3(-0.5, 0.5, 0.0)), 1e-6);
    EXPECT_LT(glm::length(bake.probes[8].position - glm::dvec3(1.5, 1.5, 0.0)), 1e-6);
    for (const LightProbe& probe : bake.probes) {
        EXPECT_GT(probe.coefficients[0].b, 1.0F); // what emission alone leaves
    }
}

TEST(Probes, OnThreadsAndAmongOthersTheBitsAreTheSame) {
    Settings settings = few_probe_rays(64);
    settings.bounces = 1;
    settings.threads = 1;
    settings.probe_grid = {3, 3, 3};
    const Bake one = test::bounced(test::furnished_scene(), settings, glm::vec3(1.0F, 0.5F, 0.25F));
    settings.threads = 0;
    settings.accelerator = Accelerator::brute;
    const Bake all = test::bounced(test::furnished_scene(), settings, glm::vec3(1.0F, 0.5F, 0.25F));
    settings.probe_grid.reset();
    const Bake alone = test::bounced(with_probe(test::furnished_scene(), one.probes.at(20).position), settings,
                                     glm::vec3(1.0F, 0.5F, 0.25F));
    for (std::size_t i = 0; i < one.probes.size(); ++i) {
        EXPECT_EQ(one.probes[i].coefficients, all.probes.at(i).coefficients);
        EXPECT_EQ(one.probes[i].back_sides, all.probes.at(i).back_sides);
    }
    EXPECT_EQ(alone.probes.at(0).coefficients, one.probes[20].coefficients);
}

} // namespace
} // namespace vkbake
