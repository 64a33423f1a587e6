// Pictures whose pixels are known: quads before a camera at the origin that looks along −Z, 90° high.
#include "preview/preview.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include "device.hpp"
#include "shown.hpp"
#include "vkbake/error.hpp"

namespace {

using vkbake::AlphaMode;
using vkbake::Image;
using vkbake::PreviewImages;
using vkbake::PreviewSettings;
using vkbake::Scene;
using vkbake::test::camera_at_origin;
using vkbake::test::context;
using vkbake::test::displayed;
using vkbake::test::expect_shows;
using vkbake::test::map_of;
using vkbake::test::square;

/// A square that just fills the view at `depth`; its light UVs are (0,0) in the picture's upper left corner.
void add_quad(Scene& scene, std::uint32_t material, double depth, double size = 1.0) {
    vkbake::Primitive primitive;
    primitive.positions = {{-1.0F, 1.0F, 0.0F}, {1.0F, 1.0F, 0.0F}, {1.0F, -1.0F, 0.0F}, {-1.0F, -1.0F, 0.0F}};
    primitive.tex_coords[0] = {{0.0F, 0.0F}, {1.0F, 0.0F}, {1.0F, 1.0F}, {0.0F, 1.0F}};
    primitive.tex_coords[1] = primitive.tex_coords[0];
    primitive.indices = {0, 3, 1, 1, 3, 2};
    primitive.material = material;
    scene.meshes.emplace_back();
    scene.meshes.back().primitives.push_back(primitive);
    scene.instances.emplace_back();
    scene.instances.back().mesh = static_cast<std::uint32_t>(scene.meshes.size() - 1);
    scene.instances.back().linear = glm::dmat3(depth * size);
    scene.instances.back().translation = {0.0, 0.0, -depth};
}

std::uint32_t add_material(Scene& scene, const glm::vec4& base_color, AlphaMode mode = AlphaMode::opaque) {
    vkbake::Material material;
    material.base_color = base_color;
    material.alpha_mode = mode;
    material.light_map = vkbake::LightMapUse{};
    material.light_map->texture.tex_coord = 1;
    scene.materials.push_back(material);
    return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

/// Every material uses the one map.
PreviewImages images_with(const Scene& scene, Image map) {
    PreviewImages images;
    images.textures.resize(scene.images.size());
    images.light_maps.push_back(std::move(map));
    images.light_map_of.assign(scene.materials.size(), 0);
    return images;
}

Image draw(const Scene& scene, const PreviewImages& images, const PreviewSettings& settings,
           const vkbake::PreviewSky& sky = {}) {
    return vkbake::draw_preview(context(), scene, images, camera_at_origin(), sky, settings);
}

TEST(Preview, ConstantLightMapGivesTheClosedForm) {
    Scene scene;
    add_quad(scene, add_material(scene, {0.2F, 0.4F, 0.6F, 1.0F}), 3.0, 1.1);
    for (const double light : {0.0, 0.05, 0.5, 2.0, 1000.0}) {
        const PreviewImages images = images_with(scene, map_of(1, {glm::vec3(static_cast<float>(light))}));
        PreviewSettings settings = square(9);
        settings.exposure = 1.5;
        const Image picture = draw(scene, images, settings);
        expect_shows(picture, 0, 0, 1.5 * light * glm::dvec3(0.2, 0.4, 0.6));
        expect_shows(picture, 8, 8, 1.5 * light * glm::dvec3(0.2, 0.4, 0.6));
    }
}

TEST(Preview, UpperLeftTexelIsWhereTheUvsPutIt) {
    Scene scene;
    add_quad(scene, add_material(scene, glm::vec4(1.0F)), 2.0);
    // Centres of 4×4 texels of a 16×16 picture's quad: no filtering between them at the corners, since the map is held.
    const Image map = map_of(2, {{0.5F, 0.0F, 0.0F}, {0.0F, 0.5F, 0.0F}, {0.0F, 0.0F, 0.5F}, {0.5F, 0.5F, 0.5F}});
    const Image picture = draw(scene, images_with(scene, map), square(16));
    expect_shows(picture, 1, 1, {0.5, 0.0, 0.0});
    expect_shows(picture, 14, 1, {0.0, 0.5, 0.0});
    expect_shows(picture, 1, 14, {0.0, 0.0, 0.5});
    expect_shows(picture, 14, 14, {0.5, 0.5, 0.5});
}

TEST(Preview, FiltersTheLightMapBilinearly) {
    Scene scene;
    add_quad(scene, add_material(scene, glm::vec4(1.0F)), 2.0);
    PreviewSettings settings = square(32);
    settings.samples = 1;
    const Image map = map_of(2, {glm::vec3(0.1F), glm::vec3(0.7F)});
    const Image picture = draw(scene, images_with(scene, map), settings);
    for (int x = 8; x < 24; ++x) {
        const double share = (x + 0.5) / 32.0 * 2.0 - 0.5;
        expect_shows(picture, x, 16, glm::dvec3(0.1 + share * 0.6));
    }
}

TEST(Preview, NearerSurfaceWinsWhateverTheOrderAndHoweverFar) {
    for (const bool near_first : {false, true}) {
        Scene scene;
        const std::uint32_t red = add_material(scene, {0.5F, 0.0F, 0.0F, 1.0F});
        const std::uint32_t green = add_material(scene, {0.0F, 0.5F, 0.0F, 1.0F});
        add_quad(scene, near_first ? red : green, near_first ? 1000.0 : 1000.1);
        add_quad(scene, near_first ? green : red, near_first ? 1000.1 : 1000.0);
        scene.instances[0].translation.x = scene.instances[1].translation.x = 300.0; // the left border shows the third
        add_quad(scene, green, 0.02, 0.1);                                           // makes the range of depths wide
        scene.instances[2].translation.x = -0.015;
        vkbake::Camera camera = camera_at_origin();
        camera.near_plane = 0.001;
        const Image picture = vkbake::draw_preview(context(), scene, images_with(scene, map_of(1, {glm::vec3(1.0F)})),
                                                   camera, {}, square(16));
        expect_shows(picture, 12, 8, {0.5, 0.0, 0.0});
        expect_shows(picture, 2, 8, {0.0, 0.5, 0.0});
    }
}

TEST(Preview, SkyStandsWhereItsDirectionsPoint) {
    vkbake::Camera camera; // looks along +X: +Z lies to the right
    camera.vertical_field_of_view = std::acos(0.0);
    camera.orientation = glm::dmat3(glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(-1.0, 0.0, 0.0));
    const auto sky = [](const glm::vec3& direction) {
        return direction.x > 0.98F
                   ? glm::vec3(0.6F)
                   : glm::vec3(direction.z > 0.0F ? 0.5F : 0.0F, direction.y > 0.0F ? 0.5F : 0.0F, 0.1F);
    };
    const Image picture = vkbake::draw_preview(context(), {}, {}, camera, sky, square(33));
    expect_shows(picture, 16, 16, glm::dvec3(0.6));
    expect_shows(picture, 2, 2, {0.0, 0.5, 0.1});
    expect_shows(picture, 30, 2, {0.5, 0.5, 0.1});
    expect_shows(picture, 2, 30, {0.0, 0.0, 0.1});
    expect_shows(picture, 30, 30, {0.5, 0.0, 0.1});
}

TEST(Preview, MaskDropsAndBlendMixes) {
    Scene scene;
    const std::uint32_t dropped = add_material(scene, {0.0F, 0.0F, 0.6F, 0.3F}, AlphaMode::mask);
    const std::uint32_t glass = add_material(scene, {0.0F, 0.6F, 0.0F, 0.25F}, AlphaMode::blend);
    add_quad(scene, dropped, 1.0);
    add_quad(scene, glass, 2.0);
    const PreviewImages images = images_with(scene, map_of(1, {glm::vec3(1.0F)}));
    const auto sky = [](const glm::vec3&) { return glm::vec3(0.4F, 0.0F, 0.0F); };
    expect_shows(draw(scene, images, square(5), sky), 2, 2, {0.75 * 0.4, 0.25 * 0.6, 0.0});

    scene.materials[dropped].alpha_cutoff = 0.2F;
    expect_shows(draw(scene, images, square(5), sky), 2, 2, {0.0, 0.0, 0.6});
}

TEST(Preview, TexturesAreDecodedFromSrgbAndPlaced) {
    Scene scene;
    const std::uint32_t material = add_material(scene, {1.0F, 1.0F, 1.0F, 1.0F});
    scene.materials[material].base_color_texture =
        vkbake::TextureUse{.wrap_u = vkbake::Wrap::clamp, .wrap_v = vkbake::Wrap::clamp};
    add_quad(scene, material, 2.0);
    scene.images.emplace_back();
    PreviewImages images = images_with(scene, map_of(1, {glm::vec3(1.0F)}));
    images.textures[0] = {2, 2, {188, 0, 0, 255, 0, 188, 0, 255, 0, 0, 188, 255, 188, 188, 188, 255}};
    const double value = std::pow((188.0 / 255.0 + 0.055) / 1.055, 2.4);
    const Image picture = draw(scene, images, square(16));
    const auto near = [&](int x, int y, const glm::dvec3& radiance) {
        const glm::dvec3 difference = glm::abs(glm::dvec3(picture.texels[picture.index(x, y)]) - displayed(radiance));
        EXPECT_LT(std::max({difference.r, difference.g, difference.b}), 0.01) << x << ", " << y;
    };
    near(1, 1, {value, 0.0, 0.0});
    near(14, 1, {0.0, value, 0.0});
    near(1, 14, {0.0, 0.0, value});
    near(14, 14, {value, value, value});
}

TEST(Preview, SurfaceWithoutLightMapGetsTheMean) {
    Scene scene;
    const std::uint32_t lit = add_material(scene, glm::vec4(1.0F));
    const std::uint32_t unlit = add_material(scene, {0.5F, 0.5F, 0.5F, 1.0F});
    add_quad(scene, lit, 2.0);
    add_quad(scene, unlit, 1.0);
    PreviewImages images = images_with(scene, map_of(2, {{0.2F, 0.4F, 0.6F}, {0.6F, 0.4F, 0.2F}}));
    images.light_map_of[unlit] = PreviewImages::none;
    expect_shows(draw(scene, images, square(4)), 1, 1, glm::dvec3(0.2));
}

TEST(Preview, LightOnlyShowsGreyWhateverTheMaterial) {
    Scene scene;
    const std::uint32_t material = add_material(scene, {1.0F, 0.0F, 0.0F, 1.0F});
    scene.materials[material].emissive = {5.0F, 5.0F, 5.0F};
    add_quad(scene, material, 2.0);
    PreviewSettings settings = square(4);
    settings.light_only = true;
    const Image picture = draw(scene, images_with(scene, map_of(1, {{0.4F, 0.8F, 1.2F}})), settings);
    expect_shows(picture, 1, 1, {0.2, 0.4, 0.6});
}

TEST(Preview, BackSidesAreShown) {
    Scene scene;
    add_quad(scene, add_material(scene, {0.5F, 0.5F, 0.5F, 1.0F}), 2.0);
    std::ranges::reverse(scene.meshes[0].primitives[0].indices);
    expect_shows(draw(scene, images_with(scene, map_of(1, {glm::vec3(1.0F)})), square(4)), 1, 1, glm::dvec3(0.5));
}

TEST(Preview, TilesJoinWithoutATrace) {
    Scene scene;
    add_quad(scene, add_material(scene, glm::vec4(1.0F)), 2.0, 0.8);
    std::vector<glm::vec3> values;
    values.reserve(64);
    for (int i = 0; i < 64; ++i) {
        values.emplace_back(static_cast<float>(i) / 64.0F, 0.3F, 0.1F);
    }
    const PreviewImages images = images_with(scene, map_of(8, values));
    const auto sky = [](const glm::vec3& direction) { return 0.5F + 0.5F * direction; };
    PreviewSettings settings{.width = 50, .height = 30, .samples = 2};
    const Image whole = draw(scene, images, settings, sky);
    settings.tile = 28;
    const Image tiled = draw(scene, images, settings, sky);
    for (std::size_t i = 0; i < whole.texels.size(); ++i) {
        for (int channel = 0; channel < 4; ++channel) {
            EXPECT_NEAR(whole.texels[i][channel], tiled.texels[i][channel], 1e-4) << "pixel " << i;
        }
    }
}

TEST(Preview, RefusesSizesOutOfRange) {
    for (const int width : {0, -5, 16385}) {
        PreviewSettings settings = square(4);
        settings.width = width;
        try {
            (void)draw({}, {}, settings);
            FAIL() << "accepted a width of " << width;
        } catch (const vkbake::Error& error) {
            EXPECT_EQ(error.kind(), vkbake::ErrorKind::usage);
        }
    }
}

} // namespace
