// Normal maps of one texel under directional light maps of one texel: the normal that they make is known, and the light
// that it gets is what vkbake_light.h says in C++ (tests/closed_form/directional_test.cpp).
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include "device.hpp"
#include "shown.hpp"
#include "vkbake_light.h"

namespace {

using vkbake::test::map_of;

constexpr std::array<std::uint8_t, 4> bump{220, 90, 190, 255};
/// As bytes are read: 2 v / 255 − 1.
constexpr glm::dvec3 bump_vector(2.0 * 220 / 255 - 1.0, 2.0 * 90 / 255 - 1.0, 2.0 * 190 / 255 - 1.0);

constexpr glm::vec3 baked_light(0.5F, 0.4F, 0.6F);
/// From one side mostly, another one for each colour.
const std::array<glm::vec3, 4> harmonics{
    {{1.0F, 1.1F, 0.9F}, {0.3F, -0.5F, 0.2F}, {0.6F, 0.5F, 0.4F}, {-0.5F, 0.2F, 0.6F}}};

/// A square two metres before the eye, as wide as its view, whose u goes to the right and whose v goes down.
struct Wall {
    vkbake::Scene scene;
    vkbake::Camera camera = vkbake::test::camera_at_origin();
    vkbake::PreviewImages images;
    vkbake::PreviewSettings settings = vkbake::test::square(5);

    Wall() {
        vkbake::Primitive square;
        square.positions = {{-2.0F, 2.0F, -2.0F}, {2.0F, 2.0F, -2.0F}, {2.0F, -2.0F, -2.0F}, {-2.0F, -2.0F, -2.0F}};
        square.tex_coords[0] = {{0.0F, 0.0F}, {1.0F, 0.0F}, {1.0F, 1.0F}, {0.0F, 1.0F}};
        square.indices = {0, 3, 1, 1, 3, 2};
        square.material = 0;
        scene.meshes.emplace_back();
        scene.meshes[0].primitives.push_back(square);
        scene.instances.emplace_back();
        scene.materials.emplace_back();
        scene.materials[0].light_map = vkbake::LightMapUse{};
        scene.materials[0].normal_map = vkbake::NormalMapUse{};
        scene.images.emplace_back();
        images.textures.resize(1);
        images.light_maps.push_back(map_of(1, {baked_light}));
        images.light_map_of = {0};
        images.normal_maps = {{1, 1, {bump.begin(), bump.end()}}};
        images.directional_maps.emplace_back();
        for (std::size_t i = 0; i < harmonics.size(); ++i) {
            images.directional_maps[0][i] = map_of(1, {harmonics[i]});
        }
        images.directional_map_of = {0};
    }

    vkbake::Primitive& square() { return scene.meshes[0].primitives[0]; }
    void smooth(const glm::vec3& normal) { square().normals.assign(4, normal); }
    void turn_uvs(const std::function<glm::vec2(const glm::vec2&)>& turned) {
        for (glm::vec2& uv : square().tex_coords[0]) {
            uv = turned(uv);
        }
    }

    [[nodiscard]] vkbake::Image draw() const {
        return vkbake::draw_preview(vkbake::test::context(), scene, images, camera, {}, settings);
    }
};

/// World directions: the surface's normal, and right and up in the normal map.
void expect_lit(const Wall& wall, const glm::dvec3& normal, const glm::dvec3& right, const glm::dvec3& up,
                double normal_scale = 1.0) {
    const glm::dvec3 mapped = glm::normalize(right * (normal_scale * bump_vector.x) +
                                             up * (normal_scale * bump_vector.y) + normal * bump_vector.z);
    const glm::vec3 expected = vkbake::shared::vkbake_directional_light(
        baked_light, harmonics[0], harmonics[1], harmonics[2], harmonics[3], glm::vec3(normal), glm::vec3(mapped));
    ASSERT_GT(glm::distance(expected, baked_light), 0.05F) << "a bump that makes no difference";
    vkbake::test::expect_shows(wall.draw(), 2, 2, expected);
}

constexpr glm::dvec3 x_axis(1.0, 0.0, 0.0);
constexpr glm::dvec3 y_axis(0.0, 1.0, 0.0);
constexpr glm::dvec3 z_axis(0.0, 0.0, 1.0);

TEST(Relief, TextureCoordinatesTellRightAndUp) {
    for (const bool smooth : {false, true}) {
        Wall wall;
        if (smooth) {
            wall.smooth({0.0F, 0.0F, 2.0F});
        }
        expect_lit(wall, z_axis, x_axis, y_axis);
        wall.turn_uvs([](const glm::vec2& uv) { return glm::vec2(uv.y, 1.0F - uv.x); }); // u goes down, v to the left
        expect_lit(wall, z_axis, -y_axis, x_axis);
        wall.turn_uvs([](const glm::vec2& uv) { return glm::vec2(-3.0F * uv.x, uv.y); }); // now u goes up
        expect_lit(wall, z_axis, y_axis, x_axis);
    }
}

TEST(Relief, TheFilesTangentsStandAboveTextureCoordinates) {
    Wall wall;
    wall.smooth({0.0F, 0.0F, 1.0F});
    wall.square().tangents.assign(4, {0.0F, -5.0F, 0.0F, 1.0F});
    expect_lit(wall, z_axis, -y_axis, x_axis);
    wall.square().tangents.assign(4, {0.0F, -5.0F, 0.0F, -1.0F});
    expect_lit(wall, z_axis, -y_axis, -x_axis);
    wall.square().tangents.assign(4, {1.0F, 0.0F, 3.0F, 1.0F}); // made square to the normal
    expect_lit(wall, z_axis, x_axis, y_axis);
}

TEST(Relief, MirroredInstancesMirrorTheirBumps) {
    for (const bool tangents : {false, true}) {
        Wall wall;
        wall.scene.instances[0].linear = glm::dmat3(-x_axis, y_axis, z_axis);
        if (tangents) {
            wall.smooth({0.0F, 0.0F, 1.0F});
            wall.square().tangents.assign(4, {1.0F, 0.0F, 0.0F, 1.0F});
        }
        expect_lit(wall, z_axis, -x_axis, y_axis);
    }
}

TEST(Relief, NormalsStandSquareToWhatIsStretched) {
    Wall wall;
    wall.scene.instances[0].linear = glm::dmat3(4.0 * x_axis, y_axis, z_axis);
    wall.smooth({1.0F, 0.0F, 1.0F}); // so a surface that rises by z = −x, and by z = −x / 4 when stretched
    const glm::dvec3 normal = glm::normalize(glm::dvec3(0.25, 0.0, 1.0));
    expect_lit(wall, normal, glm::normalize(glm::dvec3(1.0, 0.0, -0.25)), y_axis);
}

TEST(Relief, LightComesFromTheWorldWhereverTheEyeIs) {
    const double angle = 0.7;
    const glm::dvec3 right(std::cos(angle), 0.0, -std::sin(angle));
    const glm::dvec3 back(std::sin(angle), 0.0, std::cos(angle));
    Wall wall;
    wall.camera.orientation = wall.scene.instances[0].linear = glm::dmat3(y_axis, -right, back); // and on its side
    expect_lit(wall, back, y_axis, -right);
}

TEST(Relief, TheScaleOfANormalMapFlattensIt) {
    Wall wall;
    wall.scene.materials[0].normal_map->scale = 0.5F;
    expect_lit(wall, z_axis, x_axis, y_axis, 0.5);
}

TEST(Relief, TheTexturesTransformTurnsItsBumps) {
    Wall wall;
    wall.scene.materials[0].normal_map->texture.rotation = std::numbers::pi_v<float> / 2.0F;
    // KHR_texture_transform: (u, v) → (v, −u), so u grows downwards and v to the left.
    expect_lit(wall, z_axis, -y_axis, x_axis);
}

TEST(Relief, WithoutDirectionsTheLightMapIsShownAsItIs) {
    Wall flat;
    flat.images.normal_maps = {{1, 1, {128, 128, 255, 255}}};
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(flat.draw().texels[12][channel], vkbake::test::displayed(baked_light)[channel], 2e-3)
            << "128 is not ½";
    }
    Wall none;
    none.images.directional_map_of = {vkbake::PreviewImages::none};
    vkbake::test::expect_shows(none.draw(), 2, 2, baked_light);
    Wall no_uv;
    no_uv.square().tex_coords[0].assign(4, glm::vec2(0.5F));
    vkbake::test::expect_shows(no_uv.draw(), 2, 2, baked_light);
}

TEST(Relief, ExposureIsMeteredWithoutBumps) {
    Wall wall;
    wall.settings.metered = true;
    const vkbake::Image bumped = wall.draw();
    wall.images.directional_map_of = {vkbake::PreviewImages::none};
    const vkbake::Image flat = wall.draw();
    wall.settings.metered = false;
    // Both exposures are that of the flat one: found from the picture that tells how bright it is shown.
    const double luminance = 0.2126 * baked_light.r + 0.7152 * baked_light.g + 0.0722 * baked_light.b;
    wall.settings.exposure = 0.4 / luminance;
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(flat.texels[12][channel], wall.draw().texels[12][channel], 1e-3);
    }
    wall.images.directional_map_of = {0};
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(bumped.texels[12][channel], wall.draw().texels[12][channel], 1e-3);
    }
}

} // namespace
