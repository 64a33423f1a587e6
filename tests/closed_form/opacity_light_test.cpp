// Whoever brings light to a texel meets the same surfaces that let it through: the sky, its sun, lamps, bounces, on any
// accelerator, and where errors are estimated.
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "highway_targets.hpp"
#include "lit_on_host.hpp"
#include "opacity_scenes.hpp"
#include "same_bits.hpp"

namespace vkbake::test::opacity {
namespace {

/// Cards with holes, half-transparent and coloured ones, over the furnished floor.
Scene leafy_scene() {
    Scene scene = test::furnished_scene();
    add_texture(scene, 8, 8, quarter);
    add_texture(scene, 4, 4, [](int x, int y) {
        return glm::vec4(0.2F * static_cast<float>(x), 0.9F, 0.5F, 0.3F * static_cast<float>(y));
    });
    const std::vector<Material> materials{
        {.base_color_texture = TextureUse{}, .alpha_mode = AlphaMode::mask, .double_sided = true},
        {.base_color_texture = TextureUse{.image = 1, .wrap_u = Wrap::mirror, .rotation = 0.5F},
         .alpha_mode = AlphaMode::blend},
        {.base_color = {0.9F, 0.5F, 0.3F, 1.0F}, .transmission = 0.7F}};
    for (int card = 0; card < 12; ++card) {
        const double turn = 0.5 * card;
        const glm::dmat3 linear(std::cos(turn), 0.3, std::sin(turn), 0.2, 1.0, 0.1 * card, -std::sin(turn), 0.0,
                                std::cos(turn));
        test::add_object(scene, "card", with_uvs(test::floor_of(0.9F), 3.0F),
                         {0.4 * card - 2.4, 1.8 + 0.05 * card, 0.3 * (card % 5) - 0.6}, linear);
        test::paint(scene, scene.meshes.size() - 1, materials[static_cast<std::size_t>(card % 3)]);
    }
    return scene;
}

TEST(Opacity, AcceleratorsThreadsAndInstructionSetsGiveTheSameBits) {
    const Scene scene = leafy_scene();
    Settings settings = test::small_settings(test::amount(64, 20), 16);
    settings.mode = Mode::irradiance;
    settings.bounces = 1;
    settings.bounce_rays = 8;
    const Bake expected = test::bounced(scene, settings, Sky{});
    const LightMap& map = expected.light_maps[0];
    EXPECT_GT(map.statistics.filtered_rays, map.statistics.rays / 10);
    for (const Accelerator kind : {Accelerator::bvh, Accelerator::clusters, Accelerator::brute}) {
        settings.accelerator = kind;
        settings.threads = kind == Accelerator::bvh ? 1 : 2;
        const auto same = [&] {
            const Bake found = test::bounced(scene, settings, Sky{});
            EXPECT_TRUE(test::same_bits(map.image.texels, found.light_maps[0].image.texels));
            EXPECT_EQ(map.statistics.filtered_rays, found.light_maps[0].statistics.filtered_rays);
            EXPECT_EQ(map.statistics.back_side_hits, found.light_maps[0].statistics.back_side_hits);
        };
        if (kind == Accelerator::bvh) {
            test::for_every_target(same);
        } else {
            same();
        }
    }
}

TEST(Opacity, EstimatesOfErrorsSeeTheSameLight) {
    const Scene scene = leafy_scene();
    Settings settings = test::small_settings(48, 64);
    settings.mode = Mode::irradiance;
    const Image plain = test::bake_on_host(scene, {}, settings).maps.at(0).image;
    settings.estimate_error = true;
    const LightMap estimated = test::bake_on_host(scene, {}, settings).maps.at(0);
    for (std::size_t texel = 0; texel < plain.texels.size(); ++texel) {
        ASSERT_LT(glm::length(plain.texels[texel] - estimated.image.texels[texel]), 1e-6F);
    }
    // Under one sheet every sample is the same: there is no error but of what no ray may have met.
    settings = settings_of(64);
    settings.estimate_error = true;
    const LightMap veiled =
        test::bake_on_host(floor_in_boxes({blend(0.5F)}), test::constant_sky(glm::vec3(1.0F)), settings).maps.at(0);
    EXPECT_LT(veiled.error->relative_rmse, 1e-6);
    // And where samples differ, the error told is that of the light found, which is three quarters in truth: within
    // three and a half standard deviations of what the root of so many squares may differ by.
    Scene holes = floor_in_boxes(
        {{.base_color_texture = TextureUse{.filter = Filter::nearest}, .alpha_mode = AlphaMode::mask}}, 32.0F);
    add_texture(holes, 8, 8, quarter);
    const LightMap pierced = test::bake_on_host(holes, test::constant_sky(glm::vec3(1.0F)), settings).maps.at(0);
    double squares = 0.0;
    const std::vector<glm::dvec3> light = floor_light(pierced.image);
    for (const glm::dvec3& texel : light) {
        squares += (texel.y - 0.75) * (texel.y - 0.75);
    }
    const auto count = static_cast<double>(light.size());
    const double true_rmse = std::sqrt(squares / count) / 0.75;
    EXPECT_GT(true_rmse, 0.02);
    EXPECT_NEAR(pierced.error->relative_rmse / true_rmse, 1.0, 3.5 * std::sqrt((0.5 + 0.5 / 7.0) / count));
}

/// A lamp over a floor, and between them a sheet: what the floor gets of it.
std::vector<glm::dvec3> lamp_light(const std::optional<Material>& sheet, const Material& lamp) {
    Scene scene = test::scene_of(test::floor_of(0.5F));
    test::paint(scene, 0, {.base_color = glm::vec4(0, 0, 0, 1)});
    Primitive downwards = test::floor_of(1.0F);
    std::ranges::reverse(downwards.indices);
    test::add_object(scene, "lamp", downwards, {0.0, 1.0, 0.0});
    scene.instances.back().density = 0.25;
    test::paint(scene, 1, lamp);
    if (sheet) {
        test::add_object(scene, "sheet", with_uvs(test::floor_of(2.0F), 1.0F), {0.0, 0.5, 0.0});
        scene.instances.back().density = 0.125;
        test::paint(scene, 2, *sheet);
    }
    add_texture(scene, 2, 2, [](int, int) { return white(0.25F); });
    Settings settings = settings_of(16);
    settings.bounces = 1;
    settings.bounce_rays = 64;
    return floor_light(test::bounced(scene, settings).light_maps.at(0).image);
}

TEST(Opacity, PunctualLampsAreDimmedAsTheSkyIs) {
    const auto floor_under = [](const Material& material, const Lamp& lamp) {
        Scene scene = floor_in_boxes({material});
        scene.lamps.push_back(lamp);
        Settings settings = settings_of();
        settings.estimate_error = lamp.is_soft();
        return floor_light(scene, settings, glm::vec3(0.0F));
    };
    const Material glass{.base_color = {1.0F, 0.5F, 0.25F, 1.0F}, .transmission = 0.5F};
    const glm::dvec3 aslant = glm::normalize(glm::dvec3(0.3, -1.0, 0.2));
    for (const Lamp& lamp : {Lamp{.kind = LampKind::directional, .intensity = 3.0, .direction = aslant},
                             Lamp{.kind = LampKind::directional, .direction = aslant, .angular_diameter = 10.0},
                             Lamp{.intensity = 5.0, .position = {0.3, 3.0, 0.1}},
                             Lamp{.intensity = 5.0, .position = {0.3, 3.0, 0.1}, .radius = 0.5}}) {
        const std::vector<glm::dvec3> bare = floor_under(mask(0.25F, 0.5F), lamp);
        EXPECT_GT(mean(bare).x, 0.1);
        const std::vector<glm::dvec3> dimmed = floor_under(glass, lamp);
        ASSERT_EQ(dimmed.size(), bare.size());
        for (std::size_t texel = 0; texel < bare.size(); ++texel) {
            ASSERT_LT(glm::length(dimmed[texel] - glm::dvec3(0.5, 0.25, 0.125) * bare[texel]), 1e-6);
        }
    }
}

TEST(Opacity, ASunInTheSkyIsDimmedAsTheRest) {
    Image noon{.width = 64, .height = 32, .texels = std::vector<glm::vec4>(64 * 32, glm::vec4(1.0F)), .coverage = {}};
    noon.texels[noon.index(20, 6)] = glm::vec4(5000.0F, 4000.0F, 3000.0F, 1.0F);
    const Sky sky{.source = EquirectangularSky{noon}, .name = "noon"};
    const auto floor_under = [&](const Material& material) {
        const test::HostBake bake = test::bake_on_host(floor_in_boxes({material}), sky, settings_of());
        EXPECT_GT(bake.maps[0].statistics.peak_rays, 0U); // it is sampled on its own
        return floor_light(bake.maps[0].image);
    };
    const std::vector<glm::dvec3> bare = floor_under(mask(0.25F, 0.5F));
    const std::vector<glm::dvec3> dimmed = floor_under({.base_color = {1.0F, 0.5F, 0.25F, 1.0F}, .transmission = 0.5F});
    ASSERT_EQ(dimmed.size(), bare.size());
    for (std::size_t texel = 0; texel < bare.size(); ++texel) {
        ASSERT_LT(glm::length(dimmed[texel] - glm::dvec3(0.5, 0.25, 0.125) * bare[texel]), 1e-5);
    }
}

TEST(Opacity, LampsShineThroughWhatLiesBeforeThem) {
    const Material lamp{.base_color = glm::vec4(0, 0, 0, 1), .emissive = {4.0F, 2.0F, 1.0F}};
    const std::vector<glm::dvec3> bare = lamp_light(std::nullopt, lamp);
    EXPECT_GT(mean(bare).x, 1.0);
    const auto expect_share = [&](const std::vector<glm::dvec3>& light, const glm::dvec3& share) {
        ASSERT_EQ(light.size(), bare.size()); // the floor's map is the same, and so are its rays
        for (std::size_t texel = 0; texel < bare.size(); ++texel) {
            ASSERT_LT(glm::length(light[texel] - share * bare[texel]), 1e-5);
        }
    };
    Material sheet = blend(0.25F);
    sheet.base_color = {0.0F, 0.0F, 0.0F, 0.25F};
    expect_share(lamp_light(sheet, lamp), glm::dvec3(0.75));
    expect_share(lamp_light(mask(0.25F, 0.5F), lamp), glm::dvec3(1.0));
    expect_share(lamp_light(Material{.base_color = {0.0F, 0.0F, 0.0F, 1.0F},
                                     .base_color_texture = TextureUse{},
                                     .alpha_mode = AlphaMode::mask,
                                     .alpha_cutoff = 0.25F},
                            lamp),
                 glm::dvec3(0.0));
    expect_share(lamp_light(Material{.base_color = {1.0F, 0.5F, 0.0F, 1.0F}, .transmission = 1.0F}, lamp),
                 {1.0, 0.5, 0.0});
    // A lamp that is half there sends half.
    Material half = lamp;
    half.base_color.a = 0.5F;
    half.alpha_mode = AlphaMode::blend;
    expect_share(lamp_light(std::nullopt, half), glm::dvec3(0.5));
}

} // namespace
} // namespace vkbake::test::opacity
