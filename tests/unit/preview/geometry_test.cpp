#include "base/texture_transform.hpp"
#include "preview/geometry.hpp"

#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "vkbake/error.hpp"

namespace {

using vkbake::PreviewDraw;
using vkbake::PreviewGeometry;
using vkbake::Scene;

constexpr std::size_t unlimited = std::size_t{1} << 26U;

/// Appends a node with one triangle of that material, `depth` metres in front of a camera at the origin.
void add_triangle(Scene& scene, std::uint32_t material, double depth) {
    vkbake::Primitive primitive;
    primitive.positions = {{0.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}};
    primitive.indices = {0, 1, 2};
    primitive.material = material;
    scene.meshes.emplace_back();
    scene.meshes.back().primitives.push_back(primitive);
    scene.instances.emplace_back();
    scene.instances.back().mesh = static_cast<std::uint32_t>(scene.meshes.size() - 1);
    scene.instances.back().translation = {0.0, 0.0, -depth};
}

Scene scene_with_materials(const std::vector<vkbake::AlphaMode>& modes) {
    Scene scene;
    for (const vkbake::AlphaMode mode : modes) {
        scene.materials.emplace_back();
        scene.materials.back().alpha_mode = mode;
    }
    return scene;
}

float depth_of(const PreviewGeometry& geometry, const PreviewDraw& draw, std::size_t triangle = 0) {
    const vkbake::PreviewChunk& chunk = geometry.chunks[draw.chunk];
    return -chunk.vertices[chunk.indices[draw.first_index + 3 * triangle]].position.z;
}

TEST(PreviewGeometry, EyeSpaceKeepsItsDigitsFarFromTheOrigin) {
    Scene scene = scene_with_materials({vkbake::AlphaMode::opaque});
    add_triangle(scene, 0, 0.0);
    scene.instances[0].translation = {1e7 + 0.125, 5e6, -3e7};
    vkbake::Camera camera;
    camera.position = {1e7, 5e6, -3e7 + 2.0};
    const PreviewGeometry geometry = vkbake::make_geometry(scene, camera, {}, unlimited);
    EXPECT_EQ(geometry.chunks[0].vertices[1].position, glm::vec3(1.125F, 0.0F, -2.0F));
}

TEST(PreviewGeometry, OneDrawAMaterialAndBlendedLastFromFarToNear) {
    using enum vkbake::AlphaMode;
    Scene scene = scene_with_materials({opaque, blend, mask});
    const std::vector<std::pair<std::uint32_t, double>> nodes{{2U, 4.0}, {1U, 3.0}, {0U, 1.0}, {1U, 5.0},
                                                              {2U, 2.0}, {1U, 4.0}, {0U, 6.0}};
    for (const auto& [material, depth] : nodes) {
        add_triangle(scene, material, depth);
    }
    const PreviewGeometry geometry = vkbake::make_geometry(scene, {}, {}, unlimited);
    ASSERT_EQ(geometry.opaque_draws, 2U);
    EXPECT_EQ(geometry.draws[0].material, 0U);
    EXPECT_EQ(geometry.draws[0].index_count, 6U);
    EXPECT_EQ(geometry.draws[1].material, 2U);
    EXPECT_EQ(geometry.draws[1].index_count, 6U);
    ASSERT_EQ(geometry.draws.size(), 3U) << "one material, one draw: its triangles are in order already";
    EXPECT_EQ(geometry.draws[2].material, 1U);
    for (const std::size_t triangle : {0U, 1U, 2U}) {
        EXPECT_FLOAT_EQ(depth_of(geometry, geometry.draws[2], triangle), 5.0F - static_cast<float>(triangle));
    }
}

TEST(PreviewGeometry, BlendedMaterialsAlternateByDepth) {
    using enum vkbake::AlphaMode;
    Scene scene = scene_with_materials({blend, blend});
    add_triangle(scene, 0, 1.0);
    add_triangle(scene, 1, 2.0);
    add_triangle(scene, 0, 3.0);
    const PreviewGeometry geometry = vkbake::make_geometry(scene, {}, {}, unlimited);
    ASSERT_EQ(geometry.draws.size(), 3U);
    EXPECT_EQ(geometry.opaque_draws, 0U);
    EXPECT_FLOAT_EQ(depth_of(geometry, geometry.draws[0]), 3.0F);
    EXPECT_FLOAT_EQ(depth_of(geometry, geometry.draws[1]), 2.0F);
    EXPECT_FLOAT_EQ(depth_of(geometry, geometry.draws[2]), 1.0F);
}

TEST(PreviewGeometry, SmallChunksHoldTheSameTriangles) {
    Scene scene = scene_with_materials({vkbake::AlphaMode::opaque});
    for (int i = 0; i < 20; ++i) {
        add_triangle(scene, 0, i + 1.0);
    }
    const PreviewGeometry whole = vkbake::make_geometry(scene, {}, {}, unlimited);
    const std::size_t few = 10 * sizeof(vkbake::PreviewVertex);
    const PreviewGeometry parts = vkbake::make_geometry(scene, {}, {}, few);
    EXPECT_EQ(whole.chunks.size(), 1U);
    EXPECT_EQ(parts.chunks.size(), 7U); // three triangles each
    const auto corners = [](const PreviewGeometry& geometry) {
        std::vector<float> depths;
        for (const PreviewDraw& draw : geometry.draws) {
            const vkbake::PreviewChunk& chunk = geometry.chunks[draw.chunk];
            for (std::uint32_t i = 0; i < draw.index_count; ++i) {
                depths.push_back(chunk.vertices.at(chunk.indices.at(draw.first_index + i)).position.z);
            }
        }
        return depths;
    };
    EXPECT_EQ(corners(whole), corners(parts));
    for (const vkbake::PreviewChunk& chunk : parts.chunks) {
        EXPECT_LE(chunk.vertices.size() * sizeof(vkbake::PreviewVertex), few);
    }
}

TEST(PreviewGeometry, NearAndFarHoldWhatIsInFrontOfTheEye) {
    Scene scene = scene_with_materials({vkbake::AlphaMode::opaque});
    add_triangle(scene, 0, 5.0);
    add_triangle(scene, 0, 80.0);
    vkbake::Camera camera;
    camera.near_plane = 0.1;
    const PreviewGeometry geometry = vkbake::make_geometry(scene, camera, {}, unlimited);
    EXPECT_GT(geometry.near, 4.9);
    EXPECT_LT(geometry.near, 5.0);
    EXPECT_GT(geometry.far, 80.0);
    add_triangle(scene, 0, -3.0); // behind the eye
    EXPECT_DOUBLE_EQ(vkbake::make_geometry(scene, camera, {}, unlimited).near, 0.1);
}

TEST(PreviewGeometry, TextureTransformTurnsCounterClockwiseAsSeen) {
    // KHR_texture_transform: rotation is counter-clockwise, and v points down. A quarter turn takes +u to −v.
    vkbake::TextureUse use;
    use.rotation = std::numbers::pi_v<float> / 2.0F;
    use.scale = {2.0F, 3.0F};
    use.offset = {0.25F, 0.5F};
    const glm::vec2 along_u(vkbake::TextureTransform(use)({1.0, 0.0}));
    EXPECT_NEAR(along_u.x, 0.25F, 1e-6F);
    EXPECT_NEAR(along_u.y, 0.5F - 2.0F, 1e-6F);
    const glm::vec2 along_v(vkbake::TextureTransform(use)({0.0, 1.0}));
    EXPECT_NEAR(along_v.x, 0.25F + 3.0F, 1e-6F);
    EXPECT_NEAR(along_v.y, 0.5F, 1e-6F);
}

TEST(PreviewGeometry, IndexOutOfRangeIsAnError) {
    Scene scene = scene_with_materials({vkbake::AlphaMode::opaque});
    add_triangle(scene, 0, 1.0);
    scene.meshes[0].primitives[0].indices[2] = 3;
    EXPECT_THROW((void)vkbake::make_geometry(scene, {}, {}, unlimited), vkbake::Error);
}

} // namespace
