// Light that surfaces emit and reflect, where it is known.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "base/barycentric.hpp"
#include "configuration_factors.hpp"
#include "host_bake.hpp"
#include "lit_on_host.hpp"
#include "same_bits.hpp"

namespace vkbake {
namespace {

Settings few_rays(std::uint32_t bounces) {
    Settings settings;
    settings.size = 32;
    settings.rays = 16;
    settings.bounces = bounces;
    settings.bounce_rays = 16;
    return settings;
}

Primitive inwards(Primitive box) {
    for (std::size_t first = 0; first < box.indices.size(); first += 3) {
        std::swap(box.indices[first + 1], box.indices[first + 2]);
    }
    return box;
}

TEST(Bounces, AFurnaceHasItsPartialSums) {
    // A closed room emits e and reflects ρ everywhere: what arrives after n bounces is e · (1 + ρ + … + ρⁿ⁻¹).
    Scene room = test::scene_of(inwards(test::box_of({-2, 0, -1}, {2, 2, 1})));
    Material material;
    material.base_color = {0.5F, 0.8F, 0.0F, 1.0F};
    material.emissive = {1.0F, 0.25F, 3.0F};
    test::paint(room, 0, material);
    for (const std::uint32_t bounces : {1U, 2U, 5U}) {
        const Bake bake = test::bounced(room, few_rays(bounces));
        glm::dvec3 expected(0.0);
        for (std::uint32_t bounce = 0; bounce < bounces; ++bounce) {
            expected += glm::dvec3(material.emissive) *
                        glm::pow(glm::dvec3(material.base_color), glm::dvec3(static_cast<double>(bounce)));
        }
        std::size_t covered = 0;
        for (const LightMap& map : bake.light_maps) {
            for (std::size_t texel = 0; texel < map.image.texels.size(); ++texel) {
                if (map.image.coverage[texel] != 0.0F) {
                    ++covered;
                    const glm::dvec3 found(map.image.texels[texel]);
                    ASSERT_LT(glm::length(found - expected), 1e-6 * glm::length(expected)) << bounces << " bounces";
                }
            }
        }
        EXPECT_GT(covered, 300U);
    }
}

/// The mean over the texels of the floor within `radius` of the origin.
double light_near_origin(const Bake& bake, double radius) {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t page = 0; page < bake.light_maps.size(); ++page) {
        const GeometryImage geometry =
            reference_geometry_image(bake.surface, bake.atlas, static_cast<std::uint32_t>(page));
        for (std::size_t texel = 0; texel < geometry.texel_count(); ++texel) {
            if (geometry.triangle[texel] == GeometryImage::empty ||
                bake.surface.objects[bake.surface.parts[bake.surface.parts_of[geometry.triangle[texel]]].object]
                        .instance != 0) {
                continue;
            }
            const glm::dvec3 world = bake.surface.frame.to_world(geometry.position[texel]);
            if (std::abs(world.x) < radius && std::abs(world.z) < radius) {
                sum += bake.light_maps[page].image.texels[texel].r;
                ++count;
            }
        }
    }
    EXPECT_GT(count, 0U);
    return sum / static_cast<double>(count);
}

/// A square lamp, 2 × 2, one above a small floor, which it looks at or looks away from.
Scene lamp_over_floor(bool looks_down, bool double_sided) {
    Scene scene = test::scene_of(test::floor_of(0.25F));
    Primitive lamp = test::floor_of(1.0F);
    test::paint(scene, 0, {.base_color = glm::vec4(0, 0, 0, 1)});
    test::add_object(scene, "lamp", looks_down ? inwards(lamp) : lamp, {0.0, 1.0, 0.0});
    Material material;
    material.base_color = glm::vec4(0, 0, 0, 1);
    material.emissive = glm::vec3(7.0F);
    material.double_sided = double_sided;
    test::paint(scene, 1, material);
    return scene;
}

TEST(Bounces, ALampLightsTheFloorByItsConfigurationFactor) {
    Settings settings = few_rays(1);
    settings.size = 64;
    settings.density = 20.0;
    settings.layout = Layout::object;
    settings.bounce_rays = 1024;
    const double expected = 7.0 * 4.0 * test::element_to_parallel_rectangle(1.0, 1.0, 1.0);
    // The floor around its middle, 0.1 m: there the factor falls by less than a per cent. Of 1024 stratified rays a
    // texel's error is below a per cent, and the mean is over many.
    EXPECT_NEAR(light_near_origin(test::bounced(lamp_over_floor(true, false), settings), 0.1), expected,
                0.01 * expected);
    EXPECT_NEAR(light_near_origin(test::bounced(lamp_over_floor(false, true), settings), 0.1), expected,
                0.01 * expected);
    EXPECT_EQ(light_near_origin(test::bounced(lamp_over_floor(false, false), settings), 0.1), 0.0); // its back is black
}

TEST(Bounces, OnThreadsTheBitsAreTheSame) {
    Scene scene = test::furnished_scene();
    Settings settings = few_rays(2);
    settings.threads = 1;
    const Bake one = test::bounced(scene, settings, glm::vec3(1.0F, 0.5F, 0.25F));
    settings.threads = 0;
    settings.accelerator = Accelerator::brute;
    const Bake all = test::bounced(scene, settings, glm::vec3(1.0F, 0.5F, 0.25F));
    ASSERT_EQ(one.light_maps.size(), all.light_maps.size());
    for (std::size_t page = 0; page < one.light_maps.size(); ++page) {
        EXPECT_TRUE(test::same_bits(one.light_maps[page].image.texels, all.light_maps[page].image.texels));
        EXPECT_EQ(one.light_maps[page].statistics.bounce_rays, all.light_maps[page].statistics.bounce_rays);
        EXPECT_GT(one.light_maps[page].statistics.bounce_rays, 0U);
    }
}

TEST(Bounces, NothingIsTracedWhereNothingReflects) {
    Scene scene = test::furnished_scene();
    scene.materials = {{.base_color = glm::vec4(0, 0, 0, 1)}, {.metallic = 1.0F}};
    for (std::size_t mesh = 0; mesh < scene.meshes.size(); ++mesh) {
        scene.meshes[mesh].primitives[0].material = static_cast<std::uint32_t>(mesh % 2);
    }
    const Bake bake = test::bounced(scene, few_rays(3), glm::vec3(1.0F));
    for (const LightMap& map : bake.light_maps) {
        EXPECT_EQ(map.statistics.bounce_rays, 0U);
    }
    ASSERT_EQ(bake.notes.size(), 1U);
    EXPECT_NE(bake.notes[0].find("no surface reflects"), std::string::npos);
}

TEST(Barycentric, TellsWherePointsLie) {
    const std::array<glm::vec3, 3> corners{glm::vec3(0, 0, 0), glm::vec3(2, 0, 0), glm::vec3(0, 4, 0)};
    EXPECT_EQ(barycentric(corners, {0.5, 1.0, 0.0}), glm::dvec3(0.5, 0.25, 0.25));
    EXPECT_EQ(barycentric(corners, {0.5, 1.0, 9.0}), glm::dvec3(0.5, 0.25, 0.25)); // beside the plane
    EXPECT_EQ(barycentric(corners, {4.0, 0.0, 0.0}), glm::dvec3(0.0, 1.0, 0.0));   // beyond a corner
    EXPECT_EQ(barycentric({corners[0], corners[1], corners[1]}, {1.0, 0.0, 0.0}), glm::dvec3(1.0 / 3.0));
}

} // namespace
} // namespace vkbake
