// What surfaces let through, where it is known.
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "base/luminance.hpp"
#include "configuration_factors.hpp"
#include "opacity_scenes.hpp"

namespace vkbake::test::opacity {
namespace {

TEST(Opacity, BlendAroundTheFloorLetsThroughOneLessAlpha) {
    // Exactly, also along rays that pass through the edges of the boxes' triangles.
    expect_all(floor_light(floor_in_boxes({blend(0.25F)}), settings_of()), glm::dvec3(0.75));
    expect_all(floor_light(floor_in_boxes({blend(0.25F), blend(0.5F), blend(0.125F)}), settings_of()),
               glm::dvec3(0.75 * 0.5 * 0.875));
    expect_all(floor_light(floor_in_boxes({blend(0.0F)}), settings_of()), glm::dvec3(1.0));
    expect_all(floor_light(floor_in_boxes({blend(0.5F), blend(1.0F)}), settings_of()), glm::dvec3(0.0));
    expect_all(floor_light(floor_in_boxes(std::vector<Material>(8, blend(0.25F))), settings_of(), {1.0F, 2.0F, 4.0F}),
               std::pow(0.75, 8) * glm::dvec3(1.0, 2.0, 4.0));
}

TEST(Opacity, TheThesisSamplerIsDimmedToo) {
    Settings settings = settings_of();
    settings.sampler = Sampler::thesis;
    settings.accelerator = Accelerator::clusters;
    const std::vector<glm::dvec3> bare = floor_light(floor_in_boxes({mask(0.25F, 0.5F)}), settings);
    const std::vector<glm::dvec3> dimmed = floor_light(floor_in_boxes({blend(0.25F)}), settings);
    for (std::size_t texel = 0; texel < bare.size(); ++texel) {
        ASSERT_LT(glm::length(dimmed[texel] - 0.75 * bare[texel]), 2e-7);
    }
    settings.triangle_test = TriangleTest::moller_trumbore; // promises nothing at edges
    EXPECT_NEAR(mean(floor_light(floor_in_boxes({blend(0.25F)}), settings)).x, 0.75 * mean(bare).x, 1e-3);
}

TEST(Opacity, TransmissionIsColouredByTheBaseColour) {
    Material glass{.base_color = {0.25F, 0.5F, 1.0F, 1.0F}, .transmission = 0.5F};
    expect_all(floor_light(floor_in_boxes({glass}), settings_of()), {0.125, 0.25, 0.5});
    expect_all(floor_light(floor_in_boxes({glass, glass}), settings_of()), {0.015625, 0.0625, 0.25});
    glass.metallic = 0.5F; // what is metal lets nothing through
    expect_all(floor_light(floor_in_boxes({glass}), settings_of()), {0.0625, 0.125, 0.25});
    glass.alpha_mode = AlphaMode::blend; // and what is not there, everything
    glass.base_color.a = 0.5F;
    expect_all(floor_light(floor_in_boxes({glass}), settings_of()), {0.53125, 0.5625, 0.625});
    Settings settings = settings_of();
    settings.mode = Mode::ao; // one number: luminance
    expect_all(floor_light(floor_in_boxes({glass}), settings), glm::dvec3(luminance({0.53125, 0.5625, 0.625})));
    settings.ao_distance = 0.4; // the box is farther
    expect_all(floor_light(floor_in_boxes({glass}), settings), glm::dvec3(1.0));
    settings.alpha = Alpha::opaque;
    settings.ao_distance.reset();
    expect_all(floor_light(floor_in_boxes({glass}), settings), glm::dvec3(0.0));
}

TEST(Opacity, WhatFallsOffWithDistanceIsWhatASurfaceHides) {
    Settings settings = settings_of();
    settings.mode = Mode::ao;
    settings.ao_distance = 1.7;
    settings.ao_falloff = Falloff::linear;
    // Through 1 − α comes all, through α what the distance lets through; behind what is whole nothing counts.
    const auto light = [&](const Material& inner, const Material& outer) {
        return floor_light(floor_in_boxes({inner, outer}), settings);
    };
    const std::vector<glm::dvec3> whole = light(Material(), Material());
    const std::vector<glm::dvec3> half = light(blend(0.5F), blend(0.0F));
    EXPECT_GT(mean(whole).x, 0.3);
    EXPECT_LT(mean(whole).x, 0.9);
    for (std::size_t texel = 0; texel < whole.size(); ++texel) {
        ASSERT_NEAR(half[texel].x, 0.5 + 0.5 * whole[texel].x, 1e-6);
    }
    EXPECT_TRUE(light(Material(), blend(0.5F)) == whole);
}

TEST(Opacity, TransmissionTexturesAreLookedUpInTheirOwnChannels) {
    Scene scene = floor_in_boxes({{.base_color_texture = TextureUse{.image = 0},
                                   .metallic = 1.0F,
                                   .metallic_texture = TextureUse{.image = 1},
                                   .transmission = 0.5F,
                                   .transmission_texture = TextureUse{.image = 1}}});
    add_texture(scene, 2, 2, [](int, int) { return glm::vec4(1.0F, 188.0F / 255.0F, 0.0F, 1.0F); }); // sRGB
    add_texture(scene, 2, 2, [](int, int) { return glm::vec4(0.4F, 1.0F, 0.2F, 1.0F); });
    const double factor = 0.5 * 0.4 * (1.0 - 0.2);
    const double green = std::pow((188.0 / 255.0 + 0.055) / 1.055, 2.4);
    expect_all(floor_light(scene, settings_of()), {factor, factor * green, 0.0});
}

TEST(Opacity, MaskBlocksFromItsCutoffOn) {
    expect_all(floor_light(floor_in_boxes({mask(0.5F, 0.5F)}), settings_of()), glm::dvec3(0.0));
    expect_all(floor_light(floor_in_boxes({mask(0.5F, std::nextafter(0.5F, 1.0F))}), settings_of()), glm::dvec3(1.0));
    expect_all(floor_light(floor_in_boxes({mask(0.0F, 0.0F)}), settings_of()), glm::dvec3(0.0));
    expect_all(floor_light(floor_in_boxes({mask(1.0F, 1.5F)}), settings_of()),
               glm::dvec3(1.0)); // it hides the material
    // The same of a texture and of vertices' colours. 51 / 255 is 0.2, rounded as 0.2F is.
    for (const float cutoff : {0.2F, std::nextafter(0.2F, 1.0F)}) {
        Material material = mask(1.0F, cutoff);
        material.base_color_texture = TextureUse{};
        Scene scene = floor_in_boxes({material});
        add_texture(scene, 3, 2, [](int, int) { return white(0.2F); });
        expect_all(floor_light(scene, settings_of()), glm::dvec3(cutoff == 0.2F ? 0.0 : 1.0));
        scene = floor_in_boxes({mask(1.0F, cutoff)});
        scene.meshes[1].primitives[0].colors.assign(scene.meshes[1].primitives[0].positions.size(), white(0.2F));
        expect_all(floor_light(scene, settings_of()), glm::dvec3(cutoff == 0.2F ? 0.0 : 1.0));
    }
}

TEST(Opacity, AFinePatternLetsThroughItsShare) {
    for (const AlphaMode mode : {AlphaMode::mask, AlphaMode::blend}) {
        Scene scene =
            floor_in_boxes({{.base_color_texture = TextureUse{.filter = Filter::nearest}, .alpha_mode = mode}}, 32.0F);
        add_texture(scene, 8, 8, quarter);
        const std::vector<glm::dvec3> light = floor_light(scene, settings_of(256));
        // A ray is stopped with a probability of 1/4; the texels' rays are independent.
        const double deviation = std::sqrt(0.25 * 0.75 / (256.0 * static_cast<double>(light.size())));
        EXPECT_NEAR(mean(light).x, 0.75, 4.0 * deviation);
        EXPECT_LT(glm::length(mean(light) - glm::dvec3(mean(light).x)), 1e-9);
    }
}

TEST(Opacity, AHoleInAMaskIsAWindow) {
    // A lid one above the floor with a square hole, 1 × 1, in the middle of it; closed around.
    Scene scene = test::scene_of(test::floor_of(0.5F));
    test::add_object(scene, "lid", with_uvs(test::box_of(glm::vec3(-1.0F), glm::vec3(1.0F)), 1.0F));
    scene.instances.back().density = 0.125;
    Material material{.base_color_texture =
                          TextureUse{.wrap_u = Wrap::clamp, .wrap_v = Wrap::clamp, .filter = Filter::nearest},
                      .alpha_mode = AlphaMode::mask};
    test::paint(scene, 1, material);
    add_texture(scene, 8, 8, [](int x, int y) { return white(x >= 2 && x < 6 && y >= 2 && y < 6 ? 0.0F : 1.0F); });
    // Only the upper face has the hole: the others' UVs lie in the picture's opaque corner.
    Primitive& box = scene.meshes[1].primitives[0];
    for (std::size_t vertex = 0; vertex < box.positions.size(); ++vertex) {
        const std::size_t face = vertex / 4 * 4;
        const bool upper = box.positions[face].y + box.positions[face + 1].y + box.positions[face + 2].y > 2.5F;
        if (!upper) {
            box.tex_coords[0][vertex] *= 0.125F;
        }
    }
    const test::HostBake bake =
        test::bake_on_host(scene, test::constant_sky(glm::vec3(1.0F)), settings_of(test::amount(1024U, 256U)));
    double sum = 0.0;
    int count = 0;
    for (std::size_t texel = 0; texel < bake.geometry[0].texel_count(); ++texel) {
        const glm::dvec3 world = bake.surface.frame.to_world(bake.geometry[0].position[texel]);
        if (bake.geometry[0].triangle[texel] != GeometryImage::empty && std::abs(world.x) < 0.1 &&
            std::abs(world.z) < 0.1) {
            sum += bake.maps[0].image.texels[texel].r;
            ++count;
        }
    }
    ASSERT_GT(count, 4);
    const double expected = 4.0 * test::element_to_parallel_rectangle(0.5, 0.5, 1.0);
    EXPECT_NEAR(sum / count, expected, 0.01 * expected);
}

TEST(Opacity, AMaskThatIsOpaqueEverywhereHasTheBitsOfOpaque) {
    Scene scene = test::furnished_scene();
    Settings settings = test::small_settings(48, 32);
    settings.mode = Mode::irradiance;
    const Sky sky; // clear
    const test::HostBake expected = test::bake_on_host(scene, sky, settings);
    for (const AlphaMode mode : {AlphaMode::mask, AlphaMode::blend}) {
        Scene textured = scene;
        add_texture(textured, 4, 4, [](int, int) { return white(1.0F); });
        for (std::size_t mesh = 0; mesh < textured.meshes.size(); ++mesh) {
            test::paint(textured, mesh, {.base_color_texture = TextureUse{}, .alpha_mode = mode});
        }
        const test::HostBake found = test::bake_on_host(textured, sky, settings);
        EXPECT_TRUE(test::same_light(expected, found));
        EXPECT_EQ(found.maps[0].statistics.filtered_rays, 0U); // seen beforehand
        // Where it is not seen beforehand: a texel that no triangle shows is not opaque.
        textured.images.clear();
        add_texture(textured, 4, 4, [](int x, int y) { return white(x == 2 && y == 2 ? 0.0F : 1.0F); });
        for (Mesh& mesh : textured.meshes) {
            mesh.primitives[0].tex_coords[0].assign(mesh.primitives[0].positions.size(), glm::vec2(0.01F));
            mesh.primitives[0].tex_coords[0][0] = {0.2F, 0.2F};
        }
        const test::HostBake looked_up = test::bake_on_host(textured, sky, settings);
        EXPECT_TRUE(test::same_light(expected, looked_up));
        EXPECT_GT(looked_up.maps[0].statistics.filtered_rays, 1000U);
    }
}

TEST(Opacity, ACardIsNotShadedByItself) {
    Scene scene = test::scene_of(with_uvs(test::floor_of(1.0F), 1.0F));
    test::paint(scene, 0, {.base_color_texture = TextureUse{}, .alpha_mode = AlphaMode::mask, .double_sided = true});
    add_texture(scene, 8, 8, quarter);
    expect_all(floor_light(scene, settings_of()), glm::dvec3(1.0));
}

TEST(Opacity, ProbesSeeWhatEndsARay) {
    // A closed box whose insides are backs, around one of which nothing can be said.
    const auto sides = [](const std::vector<Material>& materials) {
        return test::bake_on_host(floor_in_boxes(materials), {}, settings_of()).maps.at(0).statistics;
    };
    const LightMapStatistics inside = sides({blend(0.5F), mask(0.1F, 0.5F), blend(1.0F)});
    EXPECT_GT(inside.probed_hits, 200U);
    EXPECT_EQ(inside.back_side_hits, inside.probed_hits);
    EXPECT_EQ(inside.occluded_rays, inside.rays);
    EXPECT_EQ(sides({blend(0.5F)}).probed_hits, 0U);
}

} // namespace
} // namespace vkbake::test::opacity
