// A scene with a source document, built by hand, and a bake of it: two quads (one node mirrored) of one mesh whose
// material reads its base colour by TEXCOORD_1, positions quantised, plus a line and things that must survive.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "base/json.hpp"
#include "imageio/encode.hpp"
#include "vkbake/lightmap.hpp"
#include "vkbake/scene.hpp"

namespace vkbake::test {

/// Collects bytes and gives each piece a view and an accessor.
class SourceBuilder {
public:
    Json json{{"asset", {{"version", "2.0"}, {"generator", "by hand"}}},
              {"accessors", Json::array()},
              {"bufferViews", Json::array()}};

    std::size_t view(const void* data, std::size_t size, std::size_t stride = 0) {
        m_binary.resize((m_binary.size() + 3) / 4 * 4);
        Json entry{{"buffer", 0}, {"byteOffset", m_binary.size()}, {"byteLength", size}};
        if (stride > 0) {
            entry["byteStride"] = stride;
        }
        const auto* bytes = static_cast<const std::byte*>(data);
        m_binary.insert(m_binary.end(), bytes, bytes + size);
        json["bufferViews"].push_back(entry);
        return json["bufferViews"].size() - 1;
    }

    template<typename Value>
    std::size_t accessor(const std::vector<Value>& values, int component_type, const char* type, std::size_t count,
                         const Json& more = Json::object(), std::size_t stride = 0) {
        Json entry{{"bufferView", view(values.data(), values.size() * sizeof(Value), stride)},
                   {"componentType", component_type},
                   {"count", count},
                   {"type", type}};
        entry.update(more);
        json["accessors"].push_back(entry);
        return json["accessors"].size() - 1;
    }

    [[nodiscard]] SourceDocument document() {
        json["buffers"] = {{{"byteLength", m_binary.size()}}};
        return {json.dump(), m_binary};
    }

private:
    std::vector<std::byte> m_binary;
};

inline std::size_t add_picture(SourceBuilder& source, const char* name) {
    const std::array<std::uint8_t, 3> texel{200, 100, 50};
    const std::vector<std::uint8_t> png = encode_srgb_png(1, 1, texel);
    const std::size_t view = source.view(png.data(), png.size());
    source.json["images"].push_back({{"name", name}, {"mimeType", "image/png"}, {"bufferView", view}});
    source.json["textures"].push_back({{"source", source.json["images"].size() - 1}});
    return source.json["textures"].size() - 1;
}

/// Signed normalised shorts with a padded stride of 8, as KHR_mesh_quantization has them.
inline const std::vector<std::int16_t> quad_positions{-100, 0, -100, 0, 100,  0, -100, 0,
                                                      100,  0, 100,  0, -100, 0, 100,  0};
inline const std::vector<std::uint16_t> quad_indices{0, 2, 1, 0, 3, 2};

inline SourceDocument make_source() {
    SourceBuilder source;
    const std::size_t position =
        source.accessor(quad_positions, 5122, "VEC3", 4, {{"min", {-100, 0, -100}}, {"max", {100, 0, 100}}}, 8);
    const std::size_t indices = source.accessor(quad_indices, 5123, "SCALAR", 6);
    const std::size_t uv0 = source.accessor(std::vector<float>{0, 0, 1, 0, 1, 1, 0, 1}, 5126, "VEC2", 4);
    const std::size_t uv1 =
        source.accessor(std::vector<std::uint8_t>{0, 0, 0, 0, 128, 0, 0, 0, 128, 128, 0, 0, 0, 128, 0, 0}, 5121, "VEC2",
                        4, {{"normalized", true}}, 4);
    const std::size_t color =
        source.accessor(std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16}, 5121, "VEC4",
                        4, {{"normalized", true}});
    const std::size_t custom = source.accessor(std::vector<float>{0.5F, 1.5F, 2.5F, 3.5F}, 5126, "SCALAR", 4);
    const std::size_t morph = source.accessor(std::vector<float>{0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0}, 5126, "VEC3", 4,
                                              {{"min", {0, 1, 0}}, {"max", {0, 4, 0}}});
    const std::size_t times =
        source.accessor(std::vector<float>{0, 1}, 5126, "SCALAR", 2, {{"min", {0}}, {"max", {1}}});
    const std::size_t moves = source.accessor(std::vector<float>{0, 0, 0, 0, 1, 0}, 5126, "VEC3", 2);
    const std::size_t texture = add_picture(source, "checker");

    Json& json = source.json;
    json["extensionsUsed"] = {"KHR_mesh_quantization"};
    json["extensionsRequired"] = {"KHR_mesh_quantization"};
    json["materials"] = {{{"name", "tiles"},
                          {"extras", "a word"},
                          {"pbrMetallicRoughness",
                           {{"baseColorTexture", {{"index", texture}, {"texCoord", 1}}}, {"metallicFactor", 0}}}},
                         {{"name", "wire"}}};
    json["meshes"] = {
        {{"name", "quad"},
         {"weights", {0.0}},
         {"primitives",
          {{{"attributes", {{"POSITION", position}}},
            {"mode", 1},
            {"indices", indices},
            {"material", 1},
            {"targets", {{{"POSITION", morph}}}}},
           {{"attributes",
             {{"POSITION", position}, {"TEXCOORD_0", uv0}, {"TEXCOORD_1", uv1}, {"COLOR_0", color}, {"_HEAT", custom}}},
            {"indices", indices},
            {"material", 0},
            {"targets", {{{"POSITION", morph}}}}}}}}};
    json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}}};
    json["nodes"] = {{{"name", "floor"}, {"mesh", 0}},
                     {{"name", "mirror"}, {"mesh", 0}, {"scale", {-1, 1, 1}}, {"translation", {500, 0, 0}}},
                     {{"name", "eye"}, {"camera", 0}}};
    json["scenes"] = {{{"nodes", {0, 1, 2}}}};
    json["scene"] = 0;
    json["animations"] = {{{"channels", {{{"sampler", 0}, {"target", {{"node", 2}, {"path", "translation"}}}}}},
                           {"samplers", {{{"input", times}, {"output", moves}}}}}};
    return source.document();
}

inline Scene make_scene() {
    Scene scene;
    scene.name = "room";
    scene.source = make_source();
    Primitive primitive;
    primitive.positions = {{-100, 0, -100}, {100, 0, -100}, {100, 0, 100}, {-100, 0, 100}};
    const float half = 128.0F / 255.0F;
    primitive.tex_coords[0] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    primitive.tex_coords[1] = {{0, 0}, {half, 0}, {half, half}, {0, half}};
    primitive.indices.assign(quad_indices.begin(), quad_indices.end());
    primitive.material = 0;
    primitive.source_primitive = 1; // the line before it was skipped
    scene.meshes = {{"quad", {primitive}, 0}};
    scene.instances.resize(2);
    scene.instances[0].name = "floor";
    scene.instances[1].name = "mirror";
    scene.instances[1].linear[0][0] = -1.0;
    scene.instances[1].translation = {500, 0, 0};
    scene.instances[1].source_node = 1;
    scene.materials.resize(2);
    return scene;
}

/// Each object on a page of its own, but the mirror's second triangle on the first page too; the floor's two triangles
/// are charts apart, so its shared vertices have two UVs. Corners are rotated and the mirror's winding turned, as
/// Surface says.
inline Bake make_bake() {
    Bake bake;
    bake.sky = "clear";
    bake.device = "test";
    Surface& surface = bake.surface;
    surface.vertices = {2, 1, 0, 3, 2, 0, 0, 1, 2, 2, 3, 0};
    surface.parts = {{0, 0, 0, 2}, {1, 0, 2, 2}};
    surface.parts_of = {0, 0, 1, 1};
    surface.objects = {{"floor", 0, 0, 2}, {"mirror", 1, 2, 2}};
    surface.positions.resize(12);
    surface.normals.resize(12);
    Atlas& atlas = bake.atlas;
    atlas.pages = {{"page-0", 4, 2}, {"page-1", 2, 2}};
    atlas.page = {0, 0, 1, 0};
    atlas.uvs = {{0.25F, 0.5F}, {0.25F, 0.0F}, {0.0F, 0.0F}, {0.5F, 0.5F}, {0.75F, 0.5F}, {0.5F, 0.0F},
                 {0.0F, 0.0F},  {1.0F, 0.0F},  {1.0F, 1.0F}, {1.0F, 0.5F}, {0.8F, 0.5F},  {0.8F, 0.0F}};
    atlas.chart = {0, 1, 2, 3};
    atlas.chart_count = 4;
    for (const AtlasPage& page : atlas.pages) {
        LightMap map{page.name, {page.width, page.height, {}, {}}, {}};
        for (int i = 0; i < page.width * page.height; ++i) {
            const auto value = static_cast<float>(i);
            map.image.texels.emplace_back(value * 0.5F, 0.25F, 0.0F, i == 1 ? 0.0F : 1.0F);
            map.image.coverage.push_back(i < 2 ? 0.0F : 1.0F);
        }
        map.statistics.covered_texels = static_cast<std::uint64_t>(page.width * page.height - 2);
        map.statistics.seconds = 0.125;
        bake.light_maps.push_back(std::move(map));
    }
    bake.stages = {{"trace", 1.5}};
    bake.notes = {"a note of the bake"};
    return bake;
}

} // namespace vkbake::test
