// Real files through load and write and load again: the picture must be the same but for the light maps.
#include <algorithm>
#include <array>
#include <cstdlib>

#include <gtest/gtest.h>

#include "atlas/make_atlas.hpp"
#include "surface/make_surface.hpp"
#include "test_folder.hpp"
#include "vkbake/vkbake.hpp"

namespace vkbake {
namespace {

/// A bake without tracing: grey maps, which is all that writing needs.
Bake grey_bake(const Scene& scene, const Settings& settings) {
    Bake bake;
    bake.settings = settings;
    bake.surface = make_surface(scene);
    bake.atlas = make_atlas(scene, bake.surface, settings);
    for (const AtlasPage& page : bake.atlas.pages) {
        const auto count = static_cast<std::size_t>(page.width) * static_cast<std::size_t>(page.height);
        bake.light_maps.push_back({page.name,
                                   {page.width, page.height, std::vector<glm::vec4>(count, {0.5F, 0.5F, 0.5F, 1.0F}),
                                    std::vector<float>(count, 1.0F)},
                                   {}});
    }
    return bake;
}

using Corner = std::array<float, 8>; // position, normal, light-map UV

/// All triangles, whatever their order: nine positions, the normals and the UVs with them.
std::vector<std::array<Corner, 3>> triangles(const Surface& surface, const std::vector<glm::vec2>& uvs) {
    std::vector<std::array<Corner, 3>> result(surface.triangle_count());
    for (std::size_t i = 0; i < surface.positions.size(); ++i) {
        const glm::vec3& position = surface.positions[i];
        const glm::vec3& normal = surface.normals[i];
        result[i / 3].at(i % 3) = {position.x, position.y, position.z, normal.x,
                                   normal.y,   normal.z,   uvs[i].x,   uvs[i].y};
    }
    std::sort(result.begin(), result.end());
    return result;
}

/// TEXCOORD_1 of each of the surface's corners.
std::vector<glm::vec2> own_uvs(const Scene& scene, const Surface& surface) {
    std::vector<glm::vec2> uvs;
    for (std::size_t i = 0; i < surface.vertices.size(); ++i) {
        const SurfacePart& part = surface.parts[surface.parts_of[i / 3]];
        const Mesh& mesh = scene.meshes[scene.instances[surface.objects[part.object].instance].mesh];
        uvs.push_back(mesh.primitives[part.primitive].tex_coords[1].at(surface.vertices[i]));
    }
    return uvs;
}

class RealScene : public testing::TestWithParam<const char*> {};

TEST_P(RealScene, ComesBackWithLightMaps) {
    const std::filesystem::path file = std::filesystem::path(VKBAKE_SHARED_DATA_DIR) / "scenes" / GetParam();
    if (!std::filesystem::exists(file)) {
        GTEST_SKIP() << "no folder of real data here";
    }
    const test::TestFolder folder;
    const Scene scene = load_scene(file);
    Settings settings;
    settings.size = 512;
    settings.density = 8.0; // more than one page for the larger scenes
    settings.max_pages = 64;
    const Bake bake = grey_bake(scene, settings);
    write_bake(scene, bake, {folder / "once", LightMapFormat::exr, {}});

    const std::filesystem::path written = folder / "once" / (scene.name + ".glb");
    const Scene again = load_scene(written);
    const Surface surface = make_surface(again);
    EXPECT_EQ(triangles(surface, own_uvs(again, surface)), triangles(bake.surface, bake.atlas.uvs));
    for (const Mesh& mesh : again.meshes) {
        for (const Primitive& primitive : mesh.primitives) {
            ASSERT_TRUE(primitive.material.has_value());
            const Material& material = again.materials[*primitive.material];
            ASSERT_TRUE(material.light_map.has_value());
            EXPECT_EQ(material.light_map->texture.tex_coord, 1U);
            EXPECT_TRUE(std::filesystem::exists(folder / "once" / material.light_map->linear_file));
        }
    }

    // Baked twice: no more images than once.
    write_bake(again, grey_bake(again, settings), {folder / "twice", LightMapFormat::exr, {}});
    const Scene third = load_scene(folder / "twice" / (scene.name + ".glb"));
    EXPECT_EQ(third.images.size(), again.images.size());
    EXPECT_EQ(third.materials.size(), again.materials.size());

    const std::string command = std::string(VKBAKE_SOURCE_DIR) + "/tests/validator/validate.sh " +
                                VKBAKE_VALIDATOR_DIR + " " + written.string() + " " +
                                (folder / "twice" / (scene.name + ".glb")).string();
    const int status = std::system(command.c_str()); // NOLINT(cert-env33-c): a fixed command
    if (WIFEXITED(status) && WEXITSTATUS(status) == 77) {
        GTEST_SKIP() << "the validator is not available here";
    }
    EXPECT_EQ(status, 0);
}

INSTANTIATE_TEST_SUITE_P(Files, RealScene, testing::Values("suzanne.glb", "japanese-bridge-garden.glb"),
                         [](const auto& parameter) {
                             const std::string name = parameter.param;
                             return name.substr(0, name.find_first_of("-."));
                         });

} // namespace
} // namespace vkbake
