#include "make_scenes/document.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

#include <glm/geometric.hpp>

#include "base/glb.hpp"
#include "make_scenes/textures.hpp"
#include "make_scenes/turn.hpp"

namespace vkbake::scenes {
namespace {

constexpr const char* lights_extension = "KHR_lights_punctual";
constexpr const char* strength_extension = "KHR_materials_emissive_strength";
constexpr const char* transmission_extension = "KHR_materials_transmission";

std::string name_of(Texture texture) {
    switch (texture) {
    case Texture::wood:
        return "wood";
    case Texture::grain:
        return "grain";
    case Texture::cobble_normals:
        return "cobble normals";
    default:
        return "sprig";
    }
}

Json to_json(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }

// The rotation that takes the axes to right, up and backward; Shepperd's choice of the largest component is not needed,
// because no camera here looks backward along +Z while turned over.
glm::dvec4 to_quaternion(const glm::dvec3& right, const glm::dvec3& up, const glm::dvec3& back) {
    const double w = 0.5 * std::sqrt(std::max(0.0, 1.0 + right.x + up.y + back.z));
    if (w > 1e-3) {
        const double s = 0.25 / w;
        return {(up.z - back.y) * s, (back.x - right.z) * s, (right.y - up.x) * s, w};
    }
    const double y = 0.5 * std::sqrt(std::max(0.0, 1.0 - right.x + up.y - back.z));
    const double s = 0.25 / y;
    return {(up.x + right.y) * s, y, (back.y + up.z) * s, (back.x - right.z) * s};
}

} // namespace

glm::dvec4 rotation_about_y(double turns) {
    const glm::dvec2 half = on_circle(turns / 2.0);
    return {0.0, half.y, 0.0, half.x};
}

glm::dvec4 rotation_towards(const glm::dvec3& eye, const glm::dvec3& target) {
    const glm::dvec3 back = unit(eye - target);
    const glm::dvec3 right = unit(glm::cross(glm::dvec3(0.0, 1.0, 0.0), back));
    return to_quaternion(right, glm::cross(back, right), back);
}

std::size_t Document::add_view(const void* data, std::size_t size, gltf::ViewTarget target) {
    m_binary.resize((m_binary.size() + 3) / 4 * 4);
    Json view{{"buffer", 0}, {"byteOffset", m_binary.size()}, {"byteLength", size}};
    if (target != gltf::ViewTarget::none) {
        view["target"] = target;
    }
    const std::size_t start = m_binary.size();
    m_binary.resize(start + size);
    std::memcpy(m_binary.data() + start, data, size);
    m_json["bufferViews"].push_back(std::move(view));
    return m_json["bufferViews"].size() - 1;
}

template<class T>
std::size_t Document::add_accessor(const std::vector<T>& values, const char* type, bool with_bounds) {
    Json accessor{{"bufferView", add_view(values.data(), values.size() * sizeof(T), gltf::ViewTarget::vertices)},
                  {"componentType", gltf::float_type},
                  {"count", values.size()},
                  {"type", type}};
    if (with_bounds) {
        Json low = Json::array();
        Json high = Json::array();
        for (int c = 0; c < T::length(); ++c) {
            const auto [least, most] =
                std::minmax_element(values.begin(), values.end(), [c](const T& a, const T& b) { return a[c] < b[c]; });
            low.push_back(static_cast<double>((*least)[c]));
            high.push_back(static_cast<double>((*most)[c]));
        }
        accessor["min"] = std::move(low);
        accessor["max"] = std::move(high);
    }
    m_json["accessors"].push_back(std::move(accessor));
    return m_json["accessors"].size() - 1;
}

std::size_t Document::add_indices(const Patch& patch) {
    const bool narrow = patch.positions.size() < 65535;
    std::size_t view = 0;
    if (narrow) {
        std::vector<std::uint16_t> short_indices;
        for (const std::uint32_t index : patch.indices) {
            short_indices.push_back(static_cast<std::uint16_t>(index));
        }
        view = add_view(short_indices.data(), short_indices.size() * sizeof(std::uint16_t), gltf::ViewTarget::indices);
    } else {
        view = add_view(patch.indices.data(), patch.indices.size() * sizeof(std::uint32_t), gltf::ViewTarget::indices);
    }
    m_json["accessors"].push_back({{"bufferView", view},
                                   {"componentType", narrow ? gltf::unsigned_short_type : gltf::unsigned_int_type},
                                   {"count", patch.indices.size()},
                                   {"type", "SCALAR"}});
    return m_json["accessors"].size() - 1;
}

std::size_t Document::texture(Texture kind) {
    const auto [found, is_new] = m_textures.try_emplace(kind, m_textures.size());
    if (is_new) {
        const std::vector<std::byte> file =
            kind == Texture::cobble_normals ? encode_png(make_cobble_normals()) : encode_png(make_texture(kind));
        const std::size_t view = add_view(file.data(), file.size(), gltf::ViewTarget::none);
        m_json["images"].push_back({{"name", name_of(kind)}, {"bufferView", view}, {"mimeType", "image/png"}});
        m_json["textures"].push_back({{"sampler", 0}, {"source", found->second}});
        m_json["samplers"] = Json::array({{{"magFilter", 9729}, {"minFilter", 9987}}});
    }
    return found->second;
}

void Document::use_extension(const char* name) {
    Json& used = m_json["extensionsUsed"];
    if (std::find(used.begin(), used.end(), name) == used.end()) {
        used.push_back(name);
    }
}

std::size_t Document::material(Paint paint) {
    const auto [found, is_new] = m_materials.try_emplace(paint, m_materials.size());
    if (is_new) {
        const PaintInfo& info = paint_info(paint);
        Json surface{{"baseColorFactor", {info.colour.x, info.colour.y, info.colour.z, info.alpha}},
                     {"metallicFactor", 0.0},
                     {"roughnessFactor", 0.9}};
        if (info.texture != Texture::none) {
            surface["baseColorTexture"] = {{"index", texture(info.texture)}};
        }
        Json material{{"name", info.name}, {"pbrMetallicRoughness", std::move(surface)}};
        if (info.normals != Texture::none) {
            material["normalTexture"] = {{"index", texture(info.normals)}};
        }
        if (info.emission != glm::dvec3(0.0)) {
            const double strength = std::max({info.emission.x, info.emission.y, info.emission.z});
            material["emissiveFactor"] = to_json(info.emission / strength);
            material["extensions"][strength_extension] = {{"emissiveStrength", strength}};
            use_extension(strength_extension);
        }
        if (lets_light_through(info)) {
            material["doubleSided"] = true;
        }
        if (info.texture == Texture::sprig) {
            material["alphaMode"] = "MASK";
        } else if (info.alpha < 1.0) {
            material["alphaMode"] = "BLEND";
        }
        if (info.transmission > 0.0) {
            material["extensions"] = {{transmission_extension, {{"transmissionFactor", info.transmission}}}};
            use_extension(transmission_extension);
        }
        m_json["materials"].push_back(std::move(material));
    }
    return found->second;
}

std::size_t Document::add_mesh(const std::string& name, const std::vector<Patch>& patches) {
    Json primitives = Json::array();
    for (const Patch& patch : patches) {
        Json attributes{{"POSITION", add_accessor(patch.positions, "VEC3", true)}};
        attributes["NORMAL"] = add_accessor(patch.normals, "VEC3", false);
        if (!patch.tex_coords_0.empty()) {
            attributes["TEXCOORD_0"] = add_accessor(patch.tex_coords_0, "VEC2", false);
        }
        if (!patch.tex_coords_1.empty()) {
            attributes["TEXCOORD_1"] = add_accessor(patch.tex_coords_1, "VEC2", false);
        }
        Json primitive{{"attributes", std::move(attributes)}};
        primitive["indices"] = add_indices(patch);
        primitive["material"] = material(patch.paint);
        primitives.push_back(std::move(primitive));
    }
    m_json["meshes"].push_back({{"name", name}, {"primitives", std::move(primitives)}});
    return m_json["meshes"].size() - 1;
}

std::size_t Document::add_node(const Node& node) {
    Json json{{"name", node.name}};
    if (node.mesh) {
        json["mesh"] = *node.mesh;
    }
    if (node.camera) {
        json["camera"] = *node.camera;
    }
    if (node.light) {
        json["extensions"] = {{lights_extension, {{"light", *node.light}}}};
    }
    if (node.probe) {
        json["extras"] = {{"vkbake", {{"probe", true}}}};
    }
    if (node.translation != glm::dvec3(0.0)) {
        json["translation"] = to_json(node.translation);
    }
    if (node.rotation != glm::dvec4(0.0, 0.0, 0.0, 1.0)) {
        const glm::dvec4& q = node.rotation;
        json["rotation"] = Json::array({q.x, q.y, q.z, q.w});
    }
    if (node.scale != glm::dvec3(1.0)) {
        json["scale"] = to_json(node.scale);
    }
    const std::size_t index = m_json.contains("nodes") ? m_json["nodes"].size() : 0;
    m_json["nodes"].push_back(std::move(json));
    if (node.parent) {
        m_json["nodes"][*node.parent]["children"].push_back(index);
    } else {
        m_json["scenes"][0]["nodes"].push_back(index);
    }
    return index;
}

std::size_t Document::add_light(const Json& light) {
    use_extension(lights_extension);
    Json& lights = m_json["extensions"][lights_extension]["lights"];
    lights.push_back(light);
    return lights.size() - 1;
}

void Document::add_main_camera(const glm::dvec3& eye, const glm::dvec3& target, double vertical_field_of_view) {
    m_json["cameras"].push_back(
        {{"name", "main"},
         {"type", "perspective"},
         {"perspective",
          {{"aspectRatio", 16.0 / 9.0}, {"yfov", vertical_field_of_view}, {"znear", 0.05}, {"zfar", 200.0}}}});
    Node node;
    node.name = "main";
    node.camera = m_json["cameras"].size() - 1;
    node.translation = eye;
    node.rotation = rotation_towards(eye, target);
    add_node(node);
}

std::vector<std::byte> Document::to_glb() const {
    Json json{{"asset", {{"version", "2.0"}, {"generator", "vkbake make_scenes"}}}, {"scene", 0}};
    for (const char* key : {"extensionsUsed", "extensions", "scenes", "nodes", "cameras", "meshes", "materials",
                            "textures", "images", "samplers", "accessors", "bufferViews"}) {
        if (m_json.contains(key)) {
            json[key] = m_json[key];
        }
    }
    const std::array binary{std::span<const std::byte>(m_binary)};
    json["buffers"] = Json::array({{{"byteLength", glb::padded(m_binary.size())}}});
    return glb::make<std::byte>(json.dump(), binary);
}

} // namespace vkbake::scenes
