#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "base/srgb.hpp"
#include "glb_reader.hpp"
#include "imageio/decode.hpp"
#include "small_scene.hpp"
#include "vkbake/error.hpp"
#include "write/scene_glb.hpp"

namespace vkbake {
namespace {

using test::Glb;
using test::make_bake;
using test::make_scene;

std::vector<DisplayMap> display_maps(const Bake& bake) {
    std::vector<DisplayMap> maps;
    for (const LightMap& map : bake.light_maps) {
        maps.push_back(make_display_map(map.name, map.image, bake.settings.mode));
        maps.back().linear_file = "lightmaps/" + map.name + ".exr";
    }
    return maps;
}

Glb bake_to_glb(const Scene& scene, const Bake& bake) {
    return test::parse_glb(make_scene_glb(scene, bake, display_maps(bake)).bytes);
}

const Json& mesh_of(const Glb& glb, std::size_t node) {
    return glb.json["meshes"].at(glb.json["nodes"].at(node)["mesh"].get<std::size_t>());
}

/// What a primitive draws, however its vertices are numbered: for each corner in order, the bytes of each attribute.
std::vector<std::vector<std::uint8_t>> corners_of(const Glb& glb, const Json& primitive, const char* attribute) {
    const auto elements = glb.elements(primitive["attributes"].at(attribute).get<std::size_t>());
    std::vector<std::vector<std::uint8_t>> corners;
    for (const std::uint32_t index : glb.indices(primitive["indices"].get<std::size_t>())) {
        corners.push_back(elements.at(index));
    }
    return corners;
}

/// The corners of the source's triangles in the bytes of the source's accessor.
std::vector<std::vector<std::uint8_t>> source_corners(const std::vector<std::uint8_t>& bytes, std::size_t stride,
                                                      std::size_t size, const std::vector<std::uint16_t>& indices) {
    std::vector<std::vector<std::uint8_t>> corners;
    for (const std::uint16_t index : indices) {
        const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(index * stride);
        corners.emplace_back(first, first + static_cast<std::ptrdiff_t>(size));
    }
    return corners;
}

template<typename Value>
std::vector<std::uint8_t> as_bytes(const std::vector<Value>& values) {
    std::vector<std::uint8_t> bytes(values.size() * sizeof(Value));
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

TEST(SceneGlb, SplitsInstancesPagesAndSeams) {
    const Glb glb = bake_to_glb(make_scene(), make_bake());
    EXPECT_EQ(glb.json["meshes"].size(), 2U);
    EXPECT_NE(glb.json["nodes"][0]["mesh"], glb.json["nodes"][1]["mesh"]);
    const Json& floor = mesh_of(glb, 0);
    const Json& mirror = mesh_of(glb, 1);
    ASSERT_EQ(floor["primitives"].size(), 2U);  // the line and one page
    ASSERT_EQ(mirror["primitives"].size(), 3U); // the line and two pages
    EXPECT_EQ(floor["primitives"][0]["mode"], 1);
    EXPECT_EQ(floor["primitives"][0]["material"], 1);

    // Both triangles, six vertices since no UV is shared, in the source's order and winding.
    const Json& quad = floor["primitives"][1];
    const std::vector<std::uint8_t> positions = as_bytes(test::quad_positions);
    EXPECT_EQ(corners_of(glb, quad, "POSITION"), source_corners(positions, 8, 6, test::quad_indices));
    EXPECT_EQ(glb.elements(quad["attributes"]["POSITION"].get<std::size_t>()).size(), 6U);
    // Corner by corner the UVs that make_bake gave to vertices 0 2 1, 0 3 2.
    const std::vector<std::vector<std::uint8_t>> uvs = corners_of(glb, quad, "TEXCOORD_1");
    const std::vector<float> expected{0.0F, 0.0F, 0.25F, 0.5F, 0.25F, 0.0F, 0.5F, 0.0F, 0.5F, 0.5F, 0.75F, 0.5F};
    ASSERT_EQ(uvs.size(), 6U);
    for (std::size_t corner = 0; corner < 6; ++corner) {
        std::array<float, 2> uv{};
        std::memcpy(uv.data(), uvs[corner].data(), 8);
        EXPECT_EQ(uv[0], expected[2 * corner]) << corner;
        EXPECT_EQ(uv[1], expected[2 * corner + 1]) << corner;
    }

    // The mirrored node: page 0 has its second triangle (0 3 2), page 1 its first (0 2 1), unturned.
    EXPECT_EQ(corners_of(glb, mirror["primitives"][1], "POSITION"), source_corners(positions, 8, 6, {0, 3, 2}));
    EXPECT_EQ(corners_of(glb, mirror["primitives"][2], "POSITION"), source_corners(positions, 8, 6, {0, 2, 1}));
    const auto mirror_uvs = glb.values<float>(mirror["primitives"][2]["attributes"]["TEXCOORD_1"].get<std::size_t>());
    const auto mirror_indices = glb.indices(mirror["primitives"][2]["indices"].get<std::size_t>());
    EXPECT_EQ(mirror_uvs.at(mirror_indices[0]), (std::vector<float>{0.0F, 0.0F})); // vertex 0
    EXPECT_EQ(mirror_uvs.at(mirror_indices[1]), (std::vector<float>{1.0F, 1.0F})); // vertex 2
    EXPECT_EQ(mirror_uvs.at(mirror_indices[2]), (std::vector<float>{1.0F, 0.0F})); // vertex 1
}

TEST(SceneGlb, SharedUvsShareVertices) {
    Bake bake = make_bake();
    bake.atlas.uvs[4] = bake.atlas.uvs[0]; // vertex 2 of both triangles
    bake.atlas.uvs[5] = bake.atlas.uvs[2]; // vertex 0
    const Glb glb = bake_to_glb(make_scene(), bake);
    const Json& quad = mesh_of(glb, 0)["primitives"][1];
    EXPECT_EQ(glb.elements(quad["attributes"]["POSITION"].get<std::size_t>()).size(), 4U);
    EXPECT_EQ(corners_of(glb, quad, "POSITION"),
              source_corners(as_bytes(test::quad_positions), 8, 6, test::quad_indices));
}

TEST(SceneGlb, AttributesKeepTheirBytes) {
    const Glb glb = bake_to_glb(make_scene(), make_bake());
    const Json& quad = mesh_of(glb, 0)["primitives"][1];
    const std::vector<std::uint8_t> colors{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
    EXPECT_EQ(corners_of(glb, quad, "COLOR_0"), source_corners(colors, 4, 4, test::quad_indices));
    const std::vector<std::uint8_t> heat = as_bytes(std::vector<float>{0.5F, 1.5F, 2.5F, 3.5F});
    EXPECT_EQ(corners_of(glb, quad, "_HEAT"), source_corners(heat, 4, 4, test::quad_indices));
    const Json& color = glb.json["accessors"][quad["attributes"]["COLOR_0"].get<std::size_t>()];
    EXPECT_EQ(color["normalized"], true);
    EXPECT_EQ(color["componentType"], 5121);

    Json morphed = quad;
    morphed["attributes"] = quad["targets"][0];
    const std::vector<std::uint8_t> morph = as_bytes(std::vector<float>{0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0});
    EXPECT_EQ(corners_of(glb, morphed, "POSITION"), source_corners(morph, 12, 12, test::quad_indices));

    // Bounds by the vertices that are left: the mirror's second triangle has vertices 0, 3, 2 = (∓100, 0, ∓100).
    const Json& part = mesh_of(glb, 1)["primitives"][1];
    const Json& position = glb.json["accessors"][part["attributes"]["POSITION"].get<std::size_t>()];
    EXPECT_EQ(position["min"], Json({-100, 0, -100}));
    EXPECT_EQ(position["max"], Json({100, 0, 100}));
    const Json& target = glb.json["accessors"][part["targets"][0]["POSITION"].get<std::size_t>()];
    EXPECT_EQ(target["min"], Json({0.0, 1.0, 0.0}));
    EXPECT_EQ(target["max"], Json({0.0, 4.0, 0.0}));
}

// Only the light map's UVs are an instance's own, as long as both are cut at the same corners.
TEST(SceneGlb, InstancesShareWhatDoesNotDiffer) {
    Bake bake = make_bake();
    std::fill(bake.atlas.page.begin(), bake.atlas.page.end(), 0U);
    for (std::size_t corner = 0; corner < bake.atlas.uvs.size(); ++corner) {
        bake.atlas.uvs[corner] = glm::vec2(0.03125F * static_cast<float>(corner), 0.5F);
    }
    const Glb glb = bake_to_glb(make_scene(), bake);
    const Json& quad = mesh_of(glb, 0)["primitives"][1];
    const Json& mirror = mesh_of(glb, 1)["primitives"][1];
    EXPECT_EQ(quad["indices"], mirror["indices"]);
    EXPECT_EQ(quad["targets"], mirror["targets"]);
    for (const char* name : {"POSITION", "COLOR_0", "_HEAT"}) {
        EXPECT_EQ(quad["attributes"][name], mirror["attributes"][name]) << name;
    }
    EXPECT_EQ(corners_of(glb, mirror, "POSITION"),
              source_corners(as_bytes(test::quad_positions), 8, 6, test::quad_indices));
    EXPECT_NE(corners_of(glb, quad, "TEXCOORD_1"), corners_of(glb, mirror, "TEXCOORD_1"));

    bake.atlas.uvs[4] = bake.atlas.uvs[0]; // the first quad's vertex 2 is no longer cut
    bake.atlas.uvs[5] = bake.atlas.uvs[2]; // nor 0
    const Glb other = bake_to_glb(make_scene(), bake);
    EXPECT_NE(mesh_of(other, 0)["primitives"][1]["indices"], mesh_of(other, 1)["primitives"][1]["indices"]);
    EXPECT_NE(mesh_of(other, 0)["primitives"][1]["attributes"]["POSITION"],
              mesh_of(other, 1)["primitives"][1]["attributes"]["POSITION"]);
}

// The material reads TEXCOORD_1, which the light map needs: the set moves to TEXCOORD_2 and the material with it.
TEST(SceneGlb, MovesASetThatMaterialsUse) {
    const Glb glb = bake_to_glb(make_scene(), make_bake());
    const Json& quad = mesh_of(glb, 0)["primitives"][1];
    const std::vector<std::uint8_t> own{0, 0, 128, 0, 128, 128, 0, 128};
    EXPECT_EQ(corners_of(glb, quad, "TEXCOORD_2"), source_corners(own, 2, 2, test::quad_indices));
    const Json& material = glb.json["materials"][quad["material"].get<std::size_t>()];
    EXPECT_EQ(material["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"], 2);
    EXPECT_EQ(material["extensions"]["MOZ_lightmap"]["texCoord"], 1);
}

TEST(SceneGlb, KeepsASetThatIsTheLightMapsOwn) {
    const Scene scene = make_scene();
    Bake bake = make_bake();
    for (std::size_t corner = 0; corner < 12; ++corner) {
        bake.atlas.uvs[corner] = scene.meshes[0].primitives[0].tex_coords[1][bake.surface.vertices[corner]];
    }
    const Glb glb = bake_to_glb(scene, bake);
    const Json& quad = mesh_of(glb, 0)["primitives"][1];
    EXPECT_FALSE(quad["attributes"].contains("TEXCOORD_2"));
    const Json& material = glb.json["materials"][quad["material"].get<std::size_t>()];
    EXPECT_EQ(material["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"], 1);
}

TEST(SceneGlb, MaterialsReferToTheirPage) {
    const Bake bake = make_bake();
    const Glb glb = bake_to_glb(make_scene(), bake);
    EXPECT_EQ(glb.json["materials"].size(), 3U); // tiles twice, wire
    EXPECT_EQ(glb.json["materials"][1]["name"], "wire");
    EXPECT_FALSE(glb.json["materials"][1].contains("extensions"));
    EXPECT_EQ(glb.json["extensionsUsed"], Json({"KHR_mesh_quantization", "MOZ_lightmap"}));
    EXPECT_EQ(glb.json["extensionsRequired"], Json({"KHR_mesh_quantization"}));
    for (std::size_t page = 0; page < 2; ++page) {
        const Json& primitive = mesh_of(glb, 1)["primitives"][1 + page];
        const Json& material = glb.json["materials"][primitive["material"].get<std::size_t>()];
        const Json& reference = material["extensions"]["MOZ_lightmap"];
        const Json& texture = glb.json["textures"][reference["index"].get<std::size_t>()];
        const Json& image = glb.json["images"][texture["source"].get<std::size_t>()];
        EXPECT_EQ(image["name"], bake.light_maps[page].name);
        EXPECT_EQ(image["mimeType"], "image/png");
        EXPECT_EQ(material["extras"]["vkbake"]["lightMap"], "lightmaps/" + bake.light_maps[page].name + ".exr");
        EXPECT_EQ(material["extras"]["vkbake"]["mode"], "irradiance");
        EXPECT_EQ(material["extras"]["source"], "a word"); // extras that are no object survive

        // intensity × linear value = E = π × stored, within half a step of 8-bit sRGB (largest at
        // white: 2.4/1.055/255/2).
        EncodedImage encoded{"map", "image/png", {}};
        for (const std::uint8_t byte : glb.view(image["bufferView"].get<std::size_t>())) {
            encoded.bytes.push_back(static_cast<std::byte>(byte));
        }
        const Rgba8Image picture = decode_rgba8(encoded);
        const Image& stored = bake.light_maps[page].image;
        const double intensity = reference["intensity"].get<double>();
        ASSERT_EQ(picture.width, stored.width);
        for (std::size_t i = 0; i < stored.texels.size(); ++i) {
            for (int channel = 0; channel < 3; ++channel) {
                const double code = picture.texels[4 * i + static_cast<std::size_t>(channel)];
                const double expected =
                    stored.texels[i].w > 0 ? std::numbers::pi * static_cast<double>(stored.texels[i][channel]) : 0.0;
                EXPECT_NEAR(intensity * srgb_to_linear(code / 255.0), expected, intensity * 0.0045) << i;
            }
        }
    }
}

TEST(SceneGlb, EverythingElseSurvivesAndNothingIsLeftOver) {
    const Glb glb = bake_to_glb(make_scene(), make_bake());
    EXPECT_EQ(glb.json["cameras"].size(), 1U);
    EXPECT_EQ(glb.json["nodes"][2]["camera"], 0);
    EXPECT_EQ(glb.json["nodes"][1]["scale"], Json({-1, 1, 1}));
    const Json& sampler = glb.json["animations"][0]["samplers"][0];
    EXPECT_EQ(glb.values<float>(sampler["output"].get<std::size_t>()).at(1), (std::vector<float>{0, 1, 0}));
    EXPECT_EQ(glb.values<float>(sampler["input"].get<std::size_t>()).at(1), (std::vector<float>{1}));
    const Json& checker = glb.json["images"][0];
    EXPECT_EQ(checker["name"], "checker");
    const Scene scene = make_scene();
    const Json source = Json::parse(scene.source->json);
    const Json& old_view = source["bufferViews"][source["images"][0]["bufferView"].get<std::size_t>()];
    const std::vector<std::uint8_t> picture = glb.view(checker["bufferView"].get<std::size_t>());
    ASSERT_EQ(picture.size(), old_view["byteLength"].get<std::size_t>());
    EXPECT_EQ(std::memcmp(picture.data(), scene.source->binary.data() + old_view["byteOffset"].get<std::size_t>(),
                          picture.size()),
              0);

    std::set<std::size_t> used_views;
    for (const Json& accessor : glb.json["accessors"]) {
        used_views.insert(accessor["bufferView"].get<std::size_t>());
    }
    for (const Json& image : glb.json["images"]) {
        used_views.insert(image["bufferView"].get<std::size_t>());
    }
    EXPECT_EQ(used_views.size(), glb.json["bufferViews"].size());
    for (const Json& view : glb.json["bufferViews"]) {
        EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0U);
        EXPECT_EQ(view["buffer"], 0);
    }
    EXPECT_EQ(glb.json["buffers"][0]["byteLength"].get<std::size_t>(), glb.binary.size());
}

TEST(SceneGlb, AmbientOcclusionIsAnOcclusionTexture) {
    Bake bake = make_bake();
    bake.settings.mode = Mode::ao;
    const Glb glb = bake_to_glb(make_scene(), bake);
    EXPECT_EQ(glb.json["extensionsUsed"], Json({"KHR_mesh_quantization"}));
    const Json& quad = mesh_of(glb, 0)["primitives"][1];
    const Json& material = glb.json["materials"][quad["material"].get<std::size_t>()];
    EXPECT_FALSE(material.contains("extensions"));
    EXPECT_EQ(material["occlusionTexture"]["texCoord"], 1);
    EXPECT_EQ(material["extras"]["vkbake"]["mode"], "ao");
    const Json& texture = glb.json["textures"][material["occlusionTexture"]["index"].get<std::size_t>()];
    EncodedImage encoded;
    for (const std::uint8_t byte :
         glb.view(glb.json["images"][texture["source"].get<std::size_t>()]["bufferView"].get<std::size_t>())) {
        encoded.bytes.push_back(static_cast<std::byte>(byte));
    }
    const Rgba8Image picture = decode_rgba8(encoded); // red: 0, (alpha 0), 1, above 1 …
    EXPECT_EQ(picture.texels[0], 0);
    EXPECT_EQ(picture.texels[4], 0);
    EXPECT_EQ(picture.texels[8], 255);
    EXPECT_EQ(picture.texels[12], 255);
}

/// The scene as it would be loaded from what was written: primitives of one page each.
Scene baked_scene(const Glb& glb) {
    Scene scene = make_scene();
    scene.source = SourceDocument{glb.json.dump(), {}};
    for (const std::uint8_t byte : glb.binary) {
        scene.source->binary.push_back(static_cast<std::byte>(byte));
    }
    const Primitive whole = scene.meshes[0].primitives[0];
    scene.meshes.clear();
    for (std::size_t node = 0; node < 2; ++node) {
        const auto mesh = glb.json["nodes"][node]["mesh"].get<std::uint32_t>();
        Mesh loaded{"quad", {}, mesh};
        const Json& primitives = glb.json["meshes"][mesh]["primitives"];
        for (std::size_t index = 1; index < primitives.size(); ++index) {
            Primitive primitive;
            const Json& attributes = primitives[index]["attributes"];
            for (const auto& position : glb.values<std::int16_t>(attributes["POSITION"].get<std::size_t>())) {
                primitive.positions.emplace_back(position[0], position[1], position[2]);
            }
            for (const auto& uv : glb.values<float>(attributes["TEXCOORD_1"].get<std::size_t>())) {
                primitive.tex_coords[1].emplace_back(uv[0], uv[1]);
            }
            primitive.indices = glb.indices(primitives[index]["indices"].get<std::size_t>());
            primitive.source_primitive = static_cast<std::uint32_t>(index);
            loaded.primitives.push_back(primitive);
        }
        scene.instances[node].mesh = static_cast<std::uint32_t>(node);
        scene.meshes.push_back(loaded);
    }
    return scene;
}

TEST(SceneGlb, BakingAgainReplacesTheLightMaps) {
    const Bake first = make_bake();
    const Glb once = bake_to_glb(make_scene(), first);
    const Scene scene = baked_scene(once);
    Bake second = make_bake();
    second.surface.vertices.clear();
    second.surface.parts.clear();
    std::uint32_t triangle = 0;
    for (std::uint32_t object = 0; object < 2; ++object) {
        const Mesh& mesh = scene.meshes[object];
        for (std::uint32_t index = 0; index < mesh.primitives.size(); ++index) {
            const std::vector<std::uint32_t>& indices = mesh.primitives[index].indices;
            const auto count = static_cast<std::uint32_t>(indices.size() / 3);
            second.surface.parts.push_back({object, index, triangle, count});
            second.surface.vertices.insert(second.surface.vertices.end(), indices.begin(), indices.end());
            triangle += count;
        }
    }
    second.atlas.pages.resize(1);
    second.atlas.pages[0].name = "other";
    second.light_maps.resize(1);
    second.light_maps[0].name = "other";
    second.atlas.page.assign(4, 0);
    const Glb twice = bake_to_glb(scene, second);
    std::vector<std::string> names;
    for (const Json& image : twice.json["images"]) {
        names.push_back(image["name"]);
    }
    EXPECT_EQ(names, (std::vector<std::string>{"checker", "other"}));
    EXPECT_EQ(twice.json["textures"].size(), 2U);
    EXPECT_EQ(twice.json["samplers"].size(), 1U);
    EXPECT_EQ(twice.json["extensionsUsed"], Json({"KHR_mesh_quantization", "MOZ_lightmap"}));
    EXPECT_EQ(twice.json["meshes"].size(), 2U);
    for (const Json& mesh : twice.json["meshes"]) {
        for (std::size_t index = 1; index < mesh["primitives"].size(); ++index) {
            const Json& primitive = mesh["primitives"][index];
            const Json& material = twice.json["materials"][primitive["material"].get<std::size_t>()];
            EXPECT_EQ(material["extensions"]["MOZ_lightmap"]["index"], 1);
            EXPECT_EQ(material["extras"]["vkbake"]["lightMap"], "lightmaps/other.exr");
            EXPECT_EQ(material["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"], 2);
            EXPECT_FALSE(primitive["attributes"].contains("TEXCOORD_3"));
        }
    }

    // The other mode leaves nothing of the first.
    second.settings.mode = Mode::ao;
    const Glb occlusion = bake_to_glb(scene, second);
    EXPECT_EQ(occlusion.json["extensionsUsed"], Json({"KHR_mesh_quantization"}));
    EXPECT_EQ(occlusion.json.dump().find("MOZ_lightmap"), std::string::npos);
}

TEST(SceneGlb, AMeshThatSomethingElseUsesStays) {
    Scene scene = make_scene();
    Json json = Json::parse(scene.source->json);
    json["nodes"].push_back({{"name", "in another scene"}, {"mesh", 0}});
    json["scenes"].push_back({{"nodes", {3}}});
    scene.source->json = json.dump();
    const Glb glb = bake_to_glb(scene, make_bake());
    EXPECT_EQ(glb.json["meshes"].size(), 3U);
    const Json& old = mesh_of(glb, 3);
    const Json& primitive = old["primitives"][1];
    EXPECT_EQ(glb.json["materials"][primitive["material"].get<std::size_t>()].contains("extensions"), false);
    EXPECT_EQ(glb.elements(primitive["attributes"]["POSITION"].get<std::size_t>()).size(), 4U);
    EXPECT_EQ(glb.json["materials"].size(), 4U);
}

TEST(SceneGlb, ADocumentThatDoesNotFitIsAnError) {
    for (const char* json :
         {"", "[]", "{}", R"({"nodes":[],"meshes":[]})", R"({"nodes":[{"mesh":7},{"mesh":7}],"meshes":[]})"}) {
        Scene scene = make_scene();
        scene.source->json = json;
        const Bake bake = make_bake();
        const std::vector<DisplayMap> maps = display_maps(bake);
        EXPECT_THROW((void)make_scene_glb(scene, bake, maps), Error) << json;
    }
    Scene scene = make_scene();
    scene.source->binary.resize(10);
    const Bake bake = make_bake();
    const std::vector<DisplayMap> maps = display_maps(bake);
    EXPECT_THROW((void)make_scene_glb(scene, bake, maps), Error);
}

} // namespace
} // namespace vkbake
