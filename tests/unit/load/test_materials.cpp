// Materials, textures, images and light maps.
#include "document_builder.hpp"

namespace vkbake::test {
namespace {

const std::string png = "\x89PNG\r\n\x1A\n and so on";

/// A triangle with one material, one image and one texture of it.
DocumentBuilder textured_document() {
    DocumentBuilder builder = triangle_document();
    builder.json["images"] =
        Json::array({{{"bufferView", builder.add_view(png)}, {"mimeType", "image/png"}, {"name", "bricks"}}});
    builder.json["samplers"] = Json::array({{{"wrapS", 33071}, {"wrapT", 33648}}});
    builder.json["textures"] = Json::array({{{"source", 0}, {"sampler", 0}}, {{"source", 0}}});
    builder.json["materials"] = Json::array({{{"name", "wall"}}});
    builder.json["meshes"][0]["primitives"][0]["material"] = 0;
    return builder;
}

TEST(Materials, DefaultsAreThoseOfGltf) {
    const Scene scene = textured_document().load();
    ASSERT_EQ(scene.materials.size(), 1U);
    EXPECT_EQ(scene.meshes[0].primitives[0].material, 0U);
    const Material& material = scene.materials[0];
    EXPECT_EQ(material.name, "wall");
    EXPECT_EQ(material.base_color, glm::vec4(1.0F));
    EXPECT_EQ(material.alpha_mode, AlphaMode::opaque);
    EXPECT_EQ(material.alpha_cutoff, 0.5F);
    EXPECT_FALSE(material.double_sided);
    EXPECT_EQ(material.emissive, glm::vec3(0.0F));
    EXPECT_FALSE(material.base_color_texture || material.emissive_texture || material.occlusion_texture ||
                 material.light_map || material.normal_map);
    EXPECT_TRUE(material.bent_normal_file.empty());
}

TEST(Materials, EveryFieldIsRead) {
    DocumentBuilder builder = textured_document();
    builder.json["materials"][0] = Json::parse(R"({
        "pbrMetallicRoughness": {"baseColorFactor": [0.1, 0.2, 0.3, 0.4], "baseColorTexture": {"index": 0, "texCoord": 1,
            "extensions": {"KHR_texture_transform": {"offset": [0.5, 0.25], "rotation": 1.5, "scale": [2, 3], "texCoord": 2}}}},
        "alphaMode": "MASK", "alphaCutoff": 0.75, "doubleSided": true,
        "emissiveFactor": [1, 0.5, 0.25], "emissiveTexture": {"index": 1},
        "occlusionTexture": {"index": 1, "texCoord": 1},
        "normalTexture": {"index": 0, "texCoord": 2, "scale": 0.5},
        "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 8},
            "KHR_materials_transmission": {"transmissionFactor": 0.25, "transmissionTexture": {"index": 0, "texCoord": 3}}}})");
    builder.json["samplers"][0]["magFilter"] = 9728;
    const Scene scene = builder.load();
    const Material& material = scene.materials[0];
    EXPECT_EQ(material.base_color, glm::vec4(0.1F, 0.2F, 0.3F, 0.4F));
    EXPECT_EQ(material.alpha_mode, AlphaMode::mask);
    EXPECT_EQ(material.alpha_cutoff, 0.75F);
    EXPECT_TRUE(material.double_sided);
    EXPECT_EQ(material.emissive, glm::vec3(8, 4, 2));
    ASSERT_TRUE(material.base_color_texture && material.emissive_texture && material.occlusion_texture);
    const TextureUse& base = *material.base_color_texture;
    EXPECT_EQ(base.image, 0U);
    EXPECT_EQ(base.tex_coord, 2U); // the transform's own overrides
    ASSERT_TRUE(material.normal_map);
    EXPECT_EQ(material.normal_map->texture.tex_coord, 2U);
    EXPECT_EQ(material.normal_map->scale, 0.5F);
    EXPECT_EQ(material.transmission, 0.25F);
    ASSERT_TRUE(material.transmission_texture);
    EXPECT_EQ(material.transmission_texture->tex_coord, 3U);
    EXPECT_EQ(base.filter, Filter::nearest);
    EXPECT_EQ(material.emissive_texture->filter, Filter::linear); // of no sampler
    EXPECT_EQ(base.wrap_u, Wrap::clamp);
    EXPECT_EQ(base.wrap_v, Wrap::mirror);
    EXPECT_EQ(base.offset, glm::vec2(0.5F, 0.25F));
    EXPECT_EQ(base.rotation, 1.5F);
    EXPECT_EQ(base.scale, glm::vec2(2, 3));
    EXPECT_EQ(material.emissive_texture->wrap_u, Wrap::repeat);
    EXPECT_EQ(material.occlusion_texture->tex_coord, 1U);
}

TEST(Materials, DiffuseOfSpecularGlossinessIsTheBaseColour) {
    DocumentBuilder builder = textured_document();
    builder.json["extensionsRequired"] = {"KHR_materials_pbrSpecularGlossiness"};
    builder.json["materials"] = Json::parse(R"([
        {"pbrMetallicRoughness": {"baseColorFactor": [0, 0, 0, 1]}, "extensions": {"KHR_materials_pbrSpecularGlossiness":
            {"diffuseFactor": [0.1, 0.2, 0.3, 0.4], "diffuseTexture": {"index": 0, "texCoord": 1}}}},
        {"extensions": {"KHR_materials_pbrSpecularGlossiness": {}}}])");
    const Scene scene = builder.load();
    EXPECT_EQ(scene.materials[0].base_color, glm::vec4(0.1F, 0.2F, 0.3F, 0.4F));
    ASSERT_TRUE(scene.materials[0].base_color_texture);
    EXPECT_EQ(scene.materials[0].base_color_texture->tex_coord, 1U);
    EXPECT_EQ(scene.materials[1].base_color, glm::vec4(1.0F));
    EXPECT_FALSE(scene.materials[1].base_color_texture);

    builder.json["materials"][0]["extensions"]["KHR_materials_pbrSpecularGlossiness"]["diffuseTexture"]["index"] = 9;
    EXPECT_THROW((void)builder.load(), Error);
}

TEST(Materials, LightMapsOfABakedScene) {
    DocumentBuilder builder = textured_document();
    builder.json["extensionsUsed"] = {"MOZ_lightmap"};
    builder.json["materials"][0]["extensions"]["MOZ_lightmap"] = {{"index", 1}, {"texCoord", 1}, {"intensity", 12.5}};
    builder.json["materials"][0]["extras"]["vkbake"]["lightMap"] = "lightmaps/wall.exr";
    const Scene scene = builder.load();
    ASSERT_TRUE(scene.materials[0].light_map.has_value());
    const LightMapUse& use = *scene.materials[0].light_map;
    EXPECT_EQ(use.texture.image, 0U);
    EXPECT_EQ(use.texture.tex_coord, 1U);
    EXPECT_EQ(use.intensity, 12.5F);
    EXPECT_EQ(use.linear_file, "lightmaps/wall.exr");
    EXPECT_EQ(use.directional_files[0], "");
    EXPECT_EQ(scene.materials[0].bent_normal_file, "");
    EXPECT_TRUE(scene.notes.empty());
}

TEST(Materials, DirectionalMapsAndBentNormalsOfABakedScene) {
    DocumentBuilder builder = textured_document();
    builder.json["materials"][0]["extras"]["vkbake"] = {{"lightMap", "lightmaps/wall.exr"}, {"mode", "bent-normal"}};
    EXPECT_EQ(builder.load().materials[0].bent_normal_file, "lightmaps/wall.exr");

    builder.json["extensionsUsed"] = {"MOZ_lightmap"};
    builder.json["materials"][0]["extensions"]["MOZ_lightmap"] = {{"index", 1}, {"texCoord", 1}};
    Json& own = builder.json["materials"][0]["extras"]["vkbake"];
    own = {{"lightMap", "wall.exr"}, {"mode", "irradiance"}, {"directional", {"0.exr", "1.exr", "2.exr", "3.exr"}}};
    const Material baked = builder.load().materials[0];
    EXPECT_EQ(baked.bent_normal_file, "");
    EXPECT_EQ(baked.light_map->directional_files, (std::array<std::string, 4>{"0.exr", "1.exr", "2.exr", "3.exr"}));

    own["directional"] = {"0.exr", "../1.exr", "2.exr", "3.exr"};
    expect_refused(builder, "../1.exr");
    for (const Json& odd : {Json(3), Json({"0.exr"}), Json("0.exr")}) { // somebody else's extras may look alike
        own["directional"] = odd;
        EXPECT_EQ(builder.load().materials[0].light_map->directional_files[0], "");
    }
}

TEST(Materials, TangentsAreReadWhereADirectionalMapNeedsThem) {
    DocumentBuilder builder = textured_document();
    Json& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
    const std::vector<float> tangents{1, 0, 0, 1, 0, 1, 0, -1, 0, 0, 1, 1};
    attributes["TANGENT"] = builder.add(tangents, "VEC4");
    attributes["NORMAL"] = builder.add(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    builder.json["extensionsUsed"] = {"MOZ_lightmap"};
    Json& material = builder.json["materials"][0];
    material["extensions"]["MOZ_lightmap"] = {{"index", 1}, {"texCoord", 1}};
    material["extras"]["vkbake"]["directional"] = {"0.exr", "1.exr", "2.exr", "3.exr"};
    EXPECT_TRUE(builder.load().meshes[0].primitives[0].tangents.empty()) << "no normal map";
    material["normalTexture"]["index"] = 0;
    const auto read = builder.load().meshes[0].primitives[0].tangents;
    ASSERT_EQ(read.size(), 3U);
    EXPECT_EQ(read[1], glm::vec4(0, 1, 0, -1));
    material["extras"]["vkbake"].erase("directional");
    EXPECT_TRUE(builder.load().meshes[0].primitives[0].tangents.empty()) << "nothing to light them";
}

TEST(Materials, FaultsAreRefusedByName) {
    const auto refused = [](const char* pointer, const Json& value, const std::string& part) {
        DocumentBuilder builder = textured_document();
        builder.json[Json::json_pointer(pointer)] = value;
        expect_refused(builder, part);
    };
    refused("/materials/0/alphaMode", "GLASS", "\"alphaMode\" is \"GLASS\"");
    refused("/materials/0/doubleSided", 1, "neither true nor false (material 0 \"wall\")");
    refused("/materials/0/emissiveFactor", {1, 2}, "array of 3 numbers");
    refused("/materials/0/emissiveTexture", {{"index", 2}}, "\"index\" names number 2 of 2");
    refused("/materials/0/emissiveTexture", Json::object(), "\"index\" is missing");
    refused("/textures/0/source", 1, "\"source\" names number 1 of 1 (texture 0)");
    refused("/samplers/0/wrapS", 1, "wrapS");
    refused("/meshes/0/primitives/0/material", 1, "\"material\" names number 1 of 1");
    refused("/images/0/uri", "x.png", "exactly one of");
}

TEST(Images, AreEmbeddedFromViewsFilesAndDataUris) {
    const TemporaryFolder folder;
    folder.write("a texture.png", png);
    folder.write("photo", "\xFF\xD8\xFF more");
    DocumentBuilder builder = textured_document();
    builder.json["images"].push_back({{"uri", "a%20texture.png"}, {"extras", {{"kept", true}}}});
    builder.json["images"].push_back({{"uri", "photo"}});
    builder.json["images"].push_back({{"uri", "data:image/png;base64,iVBORw0KGgo="}});
    builder.json["images"].push_back({{"uri", "a%20texture.png"}});
    const Scene scene = load_scene(folder.write("scene.glb", builder.glb()));
    ASSERT_EQ(scene.images.size(), 5U);
    const auto text = [&](std::size_t i) {
        const auto& bytes = scene.images[i].bytes;
        return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    };
    EXPECT_EQ(text(0), png);
    EXPECT_EQ(scene.images[0].name, "bricks");
    EXPECT_EQ(text(1), png);
    EXPECT_EQ(scene.images[1].mime_type, "image/png");
    EXPECT_EQ(text(2), "\xFF\xD8\xFF more");
    EXPECT_EQ(scene.images[2].mime_type, "image/jpeg"); // from its bytes
    EXPECT_EQ(text(3), "\x89PNG\r\n\x1A\n");
    const Json source = Json::parse(scene.source->json);
    EXPECT_EQ(source["images"][1]["extras"]["kept"], true);
    EXPECT_FALSE(source["images"][1].contains("uri"));
    EXPECT_EQ(source["images"][1]["bufferView"], source["images"][4]["bufferView"]); // read once
}

} // namespace
} // namespace vkbake::test
