// What surfaces reflect and emit.
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "atlas/make_atlas.hpp"
#include "geometry_image/reference.hpp"
#include "host_bake.hpp"
#include "material/color_texture.hpp"
#include "material/surface_colors.hpp"

namespace vkbake {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(ColorTexture, ReadsBothEncodings) {
    const Bytes rgba{0, 128, 255, 7};
    const ColorTexture linear = make_color_texture(1, 1, rgba, Encoding::linear);
    EXPECT_EQ(linear.texels.at(0), glm::vec3(0.0F, 128.0F / 255.0F, 1.0F));
    const ColorTexture srgb = make_color_texture(1, 1, rgba, Encoding::srgb);
    EXPECT_NEAR(srgb.texels.at(0).g, 0.215861, 1e-6); // IEC 61966-2-1 of 128/255
    EXPECT_EQ(srgb.texels.at(0).r, 0.0F);
    EXPECT_EQ(srgb.texels.at(0).b, 1.0F);
}

TEST(ColorTexture, HalvingKeepsTheMeanColour) {
    // Black and white columns in turn, 1024 × 3: halved to 512 × 1, all of one grey.
    constexpr int width = 1024;
    constexpr int height = 3;
    Bytes rgba;
    for (int texel = 0; texel < width * height; ++texel) {
        rgba.insert(rgba.end(), 4, texel % 2 == 0 ? std::uint8_t{0} : std::uint8_t{255});
    }
    const ColorTexture halved = make_color_texture(width, height, rgba, Encoding::srgb);
    EXPECT_EQ(halved.width, 512);
    EXPECT_EQ(halved.height, 1);
    ASSERT_EQ(halved.texels.size(), 512U);
    for (const glm::vec3& texel : halved.texels) {
        EXPECT_EQ(texel, glm::vec3(0.5F));
    }
}

TEST(ColorTexture, WrapsAsItsUseSays) {
    Bytes rgba;
    for (const std::uint8_t value : {std::uint8_t{0}, std::uint8_t{51}, std::uint8_t{102}, std::uint8_t{255}}) {
        rgba.insert(rgba.end(), 4, value);
    }
    const ColorTexture row = make_color_texture(4, 1, rgba, Encoding::linear);
    const auto value_at = [&](float u, Wrap wrap) {
        TextureUse use;
        use.wrap_u = wrap;
        return std::lround(color_at(row, use, {u, 0.5F}).r * 255.0F);
    };
    EXPECT_EQ(value_at(0.3F, Wrap::repeat), 51);
    EXPECT_EQ(value_at(1.3F, Wrap::repeat), 51);
    EXPECT_EQ(value_at(-0.1F, Wrap::repeat), 255);
    EXPECT_EQ(value_at(1.3F, Wrap::clamp), 255);
    EXPECT_EQ(value_at(-3.0F, Wrap::clamp), 0);
    EXPECT_EQ(value_at(1.3F, Wrap::mirror), 102); // 2 − 1.3 = 0.7
    EXPECT_EQ(value_at(-0.3F, Wrap::mirror), 51);
    EXPECT_EQ(value_at(std::numeric_limits<float>::quiet_NaN(), Wrap::repeat), 0);
    EXPECT_EQ(value_at(1.0F, Wrap::clamp), 255); // the last texel's far edge is its own
}

/// The colours of a floor of one material at the middle texel.
SurfaceColors colors_of(const Scene& scene, const std::vector<ColorTexture>& textures, Alpha alpha = Alpha::traced) {
    Settings settings;
    settings.size = 9;
    const Surface surface = make_surface(scene);
    const Atlas atlas = make_atlas(scene, surface, settings);
    return make_surface_colors(scene, surface, reference_geometry_image(surface, atlas, 0), textures, alpha);
}

TEST(SurfaceColors, AlbedoIsTheProductThatGltfHas) {
    Scene scene = test::painted_floor({.base_color = {0.5F, 1.0F, 0.25F, 1.0F},
                                       .base_color_texture = TextureUse{},
                                       .metallic = 0.5F,
                                       .metallic_texture = TextureUse{.image = 1}});
    scene.images.resize(2);
    Primitive& floor = scene.meshes[0].primitives[0];
    floor.tex_coords[0].assign(4, glm::vec2(0.5F));
    floor.colors.assign(4, {1.0F, 0.5F, 1.0F, 1.0F});
    const Bytes half_red{255, 0, 255, 255};
    const Bytes blue_fifth{255, 255, 51, 255}; // metallic is the blue channel: 0.2
    const std::vector<ColorTexture> textures{make_color_texture(1, 1, half_red, Encoding::srgb),
                                             make_color_texture(1, 1, blue_fifth, Encoding::linear)};
    const SurfaceColors colors = colors_of(scene, textures);
    EXPECT_TRUE(colors.emission.empty());
    const glm::vec3 middle = colors.albedo.at(4 * 9 + 4);
    EXPECT_NEAR(middle.r, 0.5 * 1.0 * (1.0 - 0.5 * 0.2), 1e-6);
    EXPECT_EQ(middle.g, 0.0F);
    EXPECT_NEAR(middle.b, 0.25 * (1.0 - 0.5 * 0.2), 1e-6);
}

TEST(SurfaceColors, EmissionAboveOneStays) {
    const SurfaceColors colors = colors_of(test::painted_floor({.emissive = {12.0F, 0.0F, 0.5F}}), {});
    ASSERT_EQ(colors.emission.size(), colors.albedo.size());
    EXPECT_EQ(colors.emission.at(4 * 9 + 4), glm::vec3(12.0F, 0.0F, 0.5F));
    EXPECT_EQ(colors.albedo.at(4 * 9 + 4), glm::vec3(1.0F));
}

TEST(SurfaceColors, WhatGetsThroughDoesNotReflect) {
    Scene scene = test::painted_floor({.base_color = {0.5F, 1.0F, 0.25F, 1.0F},
                                       .transmission = 0.5F,
                                       .transmission_texture = TextureUse{.image = 0}});
    scene.images.resize(1);
    const Bytes fifth{51, 255, 255, 255}; // the red channel: 0.2
    const std::vector<ColorTexture> textures{make_color_texture(1, 1, fifth, Encoding::linear)};
    EXPECT_EQ(color_uses(scene, Alpha::traced), std::vector{ColorUse::linear});
    EXPECT_EQ(color_uses(scene, Alpha::opaque), std::vector{ColorUse::none});
    EXPECT_NEAR(colors_of(scene, textures).albedo.at(4 * 9 + 4).g, 0.9, 1e-6);
    EXPECT_EQ(colors_of(scene, textures, Alpha::opaque).albedo.at(4 * 9 + 4).g, 1.0F);
}

TEST(SurfaceColors, OnlyWhatIsNeededIsRead) {
    Scene scene =
        test::painted_floor({.base_color = glm::vec4(0, 0, 0, 1), .base_color_texture = TextureUse{.image = 0}});
    scene.images.resize(3);
    scene.materials.push_back({.metallic_texture = TextureUse{.image = 1}, .emissive_texture = TextureUse{.image = 2}});
    // Black reflects nothing; an emissive texture whose factor is 0 emits nothing.
    EXPECT_EQ(color_uses(scene, Alpha::traced),
              (std::vector<ColorUse>{ColorUse::none, ColorUse::linear, ColorUse::none}));
    EXPECT_FALSE(reflects(scene)); // the second material is on nothing
    EXPECT_FALSE(emits(scene));
}

} // namespace
} // namespace vkbake
