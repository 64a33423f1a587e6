#include "write/scene_glb.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "vkbake/error.hpp"
#include "vkbake/vkbake.hpp"
#include "write/baked_lamps.hpp"
#include "write/document.hpp"
#include "write/lit_materials.hpp"
#include "write/split_primitive.hpp"

namespace vkbake {
namespace {

std::optional<std::size_t> material_of(const Json& object) {
    const auto place = object.find("material");
    return place != object.end() ? std::optional(place->get<std::size_t>()) : std::nullopt;
}

/// Every material that the primitive may be drawn with: its own and those of KHR_materials_variants.
std::vector<std::optional<std::size_t>> materials_of(const Json& primitive) {
    std::vector<std::optional<std::size_t>> materials{material_of(primitive)};
    Json copy = primitive;
    copy.erase("material");
    for_each_member(copy, "material",
                    [&](const Json& material) { materials.emplace_back(material.get<std::size_t>()); });
    return materials;
}

/// Whether the light map's UVs are the primitive's own TEXCOORD_1.
bool keeps_uvs(const Primitive& primitive, const PrimitivePiece& piece) {
    const std::vector<glm::vec2>& own = primitive.tex_coords[1];
    if (own.size() != primitive.positions.size()) {
        return false;
    }
    for (std::size_t vertex = 0; vertex < piece.vertices.size(); ++vertex) {
        if (own[piece.vertices[vertex]] != piece.uvs[vertex]) {
            return false;
        }
    }
    return true;
}

class SceneEmitter {
public:
    SceneEmitter(const Scene& scene, const Bake& bake, std::span<const DisplayMap> maps)
        : m_scene(scene), m_bake(bake), m_document(*scene.source), m_materials(m_document, maps, bake.settings.mode) {
        m_source_meshes = m_document.json.value("meshes", Json::array());
    }

    [[nodiscard]] SceneGlb run() {
        std::map<std::uint32_t, std::vector<SurfacePart>> parts; // by object
        for (const SurfacePart& part : m_bake.surface.parts) {
            parts[part.object].push_back(part);
        }
        count_baked_users();
        for (const auto& [object, object_parts] : parts) {
            emit_instance(m_scene.instances.at(m_bake.surface.objects.at(object).instance), object_parts);
        }
        const bool lit = m_bake.settings.mode == Mode::irradiance && m_bake.settings.lamps == Switch::on;
        lit ? put_lamps_aside(m_document.json, m_scene.lamps) : bring_lamps_back(m_document.json);
        SceneGlb result;
        result.notes = m_materials.finish();
        if (m_moved) {
            result.notes.emplace_back(
                "TEXCOORD_1 holds the light map's UVs; where materials read another set there, it "
                "has moved to the next free TEXCOORD");
        }
        m_document.json["asset"]["generator"] = "vkbake " + version();
        result.bytes = m_document.to_glb();
        return result;
    }

private:
    /// A mesh keeps its number for the first instance if nothing but baked instances uses it.
    void count_baked_users() {
        std::map<std::size_t, std::size_t> others;
        for (const Json& node : m_document.json.at("nodes")) {
            if (node.contains("mesh")) {
                ++others[node["mesh"].get<std::size_t>()];
            }
        }
        for (const SurfaceObject& object : m_bake.surface.objects) {
            const Instance& instance = m_scene.instances.at(object.instance);
            --others[m_document.json.at("nodes").at(instance.source_node).at("mesh").get<std::size_t>()];
        }
        for (const auto& [mesh, count] : others) {
            if (count == 0) {
                m_free_meshes.insert(mesh);
            }
        }
    }

    void emit_instance(const Instance& instance, const std::vector<SurfacePart>& parts) {
        const Mesh& mesh = m_scene.meshes.at(instance.mesh);
        std::map<std::uint32_t, SurfacePart> baked; // by primitive of the source
        for (const SurfacePart& part : parts) {
            baked[mesh.primitives.at(part.primitive).source_primitive] = part;
        }
        Json emitted = m_source_meshes.at(mesh.source_mesh);
        const Json primitives = std::move(emitted.at("primitives"));
        emitted["primitives"] = Json::array();
        for (std::size_t index = 0; index < primitives.size(); ++index) {
            const auto part = baked.find(static_cast<std::uint32_t>(index));
            if (part == baked.end()) {
                emitted["primitives"].push_back(primitives[index]);
                continue;
            }
            const Primitive& primitive = mesh.primitives[part->second.primitive];
            for (const PrimitivePiece& piece : split_primitive(primitive, m_bake.surface, part->second, m_bake.atlas)) {
                emitted["primitives"].push_back(emit_piece(primitives[index], primitive, piece));
            }
        }
        place_mesh(instance, mesh.source_mesh, std::move(emitted));
    }

    void place_mesh(const Instance& instance, std::size_t source, Json mesh) {
        Json& meshes = m_document.json["meshes"];
        std::size_t place = source;
        if (m_free_meshes.erase(source) > 0) {
            meshes.at(source) = std::move(mesh);
        } else {
            place = meshes.size();
            meshes.push_back(std::move(mesh));
        }
        m_document.json["nodes"].at(instance.source_node)["mesh"] = place;
    }

    [[nodiscard]] Json emit_piece(const Json& source, const Primitive& primitive, const PrimitivePiece& piece) {
        Json emitted = source;
        emitted.erase("mode"); // strips and fans have become lists
        Json attributes = Json::object();
        for (const auto& [name, accessor] : source.at("attributes").items()) {
            attributes[name] = m_document.gather(accessor.get<std::size_t>(), piece.vertices, name == "POSITION");
        }
        const int moved_set = place_uvs(attributes, source, primitive, piece);
        emitted["attributes"] = std::move(attributes);
        if (emitted.contains("targets")) {
            for (Json& target : emitted["targets"]) {
                for (auto& [name, accessor] : target.items()) {
                    accessor = m_document.gather(accessor.get<std::size_t>(), piece.vertices, name == "POSITION");
                }
            }
        }
        emitted["indices"] = m_document.add_indices(piece.indices, piece.vertices.size());
        for_each_member(emitted, "material", [&](Json& material) {
            material = m_materials.lit(material.get<std::size_t>(), piece.page, moved_set);
        });
        if (!emitted.contains("material")) {
            emitted["material"] = m_materials.lit(std::nullopt, piece.page, moved_set);
        }
        return emitted;
    }

    /// Puts the light map's UVs into TEXCOORD_1. Returns the set that the primitive's own TEXCOORD_1 has become.
    int place_uvs(Json& attributes, const Json& source, const Primitive& primitive, const PrimitivePiece& piece) {
        int moved_set = 1;
        const std::vector<std::optional<std::size_t>> materials = materials_of(source);
        const bool in_use = std::any_of(materials.begin(), materials.end(),
                                        [&](const auto& material) { return m_materials.uses_set_1(material); });
        if (in_use && attributes.contains("TEXCOORD_1") && !keeps_uvs(primitive, piece)) {
            while (attributes.contains("TEXCOORD_" + std::to_string(moved_set))) {
                ++moved_set;
            }
            attributes["TEXCOORD_" + std::to_string(moved_set)] = attributes["TEXCOORD_1"];
            m_moved = true;
        }
        attributes["TEXCOORD_1"] = m_document.add_uvs(piece.uvs);
        // glTF wants the sets of texture coordinates numbered without a gap.
        if (!attributes.contains("TEXCOORD_0")) {
            attributes["TEXCOORD_0"] = attributes["TEXCOORD_1"];
        }
        return moved_set;
    }

    const Scene& m_scene;
    const Bake& m_bake;
    GltfDocument m_document;
    LitMaterials m_materials;
    Json m_source_meshes;
    std::set<std::size_t> m_free_meshes;
    bool m_moved = false; ///< whether a set of texture coordinates had to make room
};

} // namespace

SceneGlb make_scene_glb(const Scene& scene, const Bake& bake, std::span<const DisplayMap> maps) {
    const auto mismatch = [&](const char* what) {
        return Error(ErrorKind::bad_input, "scene \"" + scene.name + "\": its glTF document does not fit its meshes (" +
                                               what + "); load it again and bake that");
    };
    try {
        return SceneEmitter(scene, bake, maps).run();
    } catch (const Json::exception& error) {
        throw mismatch(error.what());
    } catch (const std::out_of_range& error) {
        throw mismatch(error.what());
    }
}

} // namespace vkbake
