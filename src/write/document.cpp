#include "write/document.hpp"

#include <algorithm>
#include <cstring>
#include <string>

#include <glm/vec2.hpp>

#include "base/glb.hpp"
#include "vkbake/error.hpp"
#include "write/hash.hpp"

namespace vkbake {
namespace {

[[noreturn]] void damaged(const std::string& what) {
    throw Error(ErrorKind::bad_input, "the scene's glTF document: " + what + "; load the scene again");
}

template<typename Value>
std::vector<std::uint8_t> bytes_of(std::span<const Value> values) {
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(values.data());
    return {bytes, bytes + values.size_bytes()};
}

template<typename Value>
std::string hash_of_values(std::span<const Value> values) {
    return hash_of({reinterpret_cast<const std::uint8_t*>(values.data()), values.size_bytes()});
}

/// Throws Error{bad_input} for a type that glTF does not have.
gltf::ElementType type_of(const Json& accessor) {
    const auto shape = accessor.at("type").get<std::string>();
    const auto component = accessor.at("componentType").get<std::uint64_t>();
    const auto type = gltf::element_type(shape, static_cast<int>(component));
    if (!type || !gltf::is_component_type(component)) {
        damaged("an accessor has the type " + shape + " of " + std::to_string(component));
    }
    return *type;
}

Json read_component(const std::uint8_t* bytes, int component_type) {
    return gltf::visit_component(component_type, [bytes](auto value) {
        std::memcpy(&value, bytes, sizeof(value));
        return Json(value);
    });
}

void set_bounds(Json& accessor, std::span<const std::uint8_t> packed, const gltf::ElementType& type) {
    Json low = Json::array();
    Json high = Json::array();
    for (std::size_t component = 0; component < std::size_t{type.rows} * type.columns; ++component) {
        const std::size_t offset =
            component / type.rows * type.column_size() + component % type.rows * type.component_size();
        Json least = read_component(packed.data() + offset, type.component);
        Json greatest = least;
        for (std::size_t place = offset; place < packed.size(); place += type.vertex_stride()) {
            const Json value = read_component(packed.data() + place, type.component);
            if (value < least) {
                least = value;
            }
            if (greatest < value) {
                greatest = value;
            }
        }
        low.push_back(std::move(least));
        high.push_back(std::move(greatest));
    }
    accessor["min"] = std::move(low);
    accessor["max"] = std::move(high);
}

template<typename Visit>
void visit_if_there(Json& object, const char* key, const Visit& visit) {
    if (const auto place = object.find(key); place != object.end()) {
        visit(*place);
    }
}

/// Everything in glTF 2.0 and in EXT_mesh_gpu_instancing that refers to an accessor.
template<typename Visit>
void for_each_accessor_reference(Json& json, const Visit& visit) {
    const auto visit_each = [](const auto& visit_one) {
        return [visit_one](Json& container) {
            for (Json& value : container) {
                visit_one(value);
            }
        };
    };
    const auto visit_primitive = [&](Json& primitive) {
        visit_if_there(primitive, "attributes", visit_each(visit));
        visit_if_there(primitive, "indices", visit);
        visit_if_there(primitive, "targets", visit_each(visit_each(visit)));
    };
    const auto visit_sampler = [&](Json& sampler) {
        visit_if_there(sampler, "input", visit);
        visit_if_there(sampler, "output", visit);
    };
    visit_if_there(json, "meshes",
                   visit_each([&](Json& mesh) { visit_if_there(mesh, "primitives", visit_each(visit_primitive)); }));
    visit_if_there(json, "skins", visit_each([&](Json& skin) { visit_if_there(skin, "inverseBindMatrices", visit); }));
    visit_if_there(json, "animations", visit_each([&](Json& animation) {
                       visit_if_there(animation, "samplers", visit_each(visit_sampler));
                   }));
    visit_if_there(json, "nodes", visit_each([&](Json& node) {
                       visit_if_there(node, "extensions", [&](Json& extensions) {
                           visit_if_there(extensions, "EXT_mesh_gpu_instancing", [&](Json& instancing) {
                               visit_if_there(instancing, "attributes", visit_each(visit));
                           });
                       });
                   }));
}

} // namespace

GltfDocument::GltfDocument(const SourceDocument& source)
    : json(Json::parse(source.json, nullptr, false)),
      m_source(reinterpret_cast<const std::uint8_t*>(source.binary.data()), source.binary.size()) {
    if (!json.is_object()) {
        damaged("its JSON cannot be parsed");
    }
}

std::size_t GltfDocument::add_view(std::vector<std::uint8_t> bytes, ViewTarget target, std::size_t stride) {
    Json view{{"buffer", m_added.size() + 1}, {"byteOffset", 0}, {"byteLength", bytes.size()}};
    if (stride > 0) {
        view["byteStride"] = stride;
    }
    if (target != ViewTarget::none) {
        view["target"] = static_cast<int>(target);
    }
    m_added.push_back(std::move(bytes));
    json["bufferViews"].push_back(std::move(view));
    return json["bufferViews"].size() - 1;
}

std::size_t GltfDocument::add_accessor(Json accessor) {
    json["accessors"].push_back(std::move(accessor));
    return json["accessors"].size() - 1;
}

std::size_t GltfDocument::add_indices(std::span<const std::uint32_t> indices, std::size_t vertex_count) {
    // 65535 itself is what restarts a primitive.
    const bool small = vertex_count <= 65535;
    const auto [known, is_new] = m_indices.try_emplace({small, hash_of_values(indices)}, 0);
    if (is_new) {
        const std::vector<std::uint16_t> narrow(indices.begin(), small ? indices.end() : indices.begin());
        const std::size_t view = add_view(small ? bytes_of(std::span(narrow)) : bytes_of(indices), ViewTarget::indices);
        known->second = add_accessor({{"bufferView", view},
                                      {"componentType", small ? gltf::unsigned_short_type : gltf::unsigned_int_type},
                                      {"count", indices.size()},
                                      {"type", "SCALAR"}});
    }
    return known->second;
}

std::size_t GltfDocument::add_uvs(std::span<const glm::vec2> uvs) {
    static_assert(sizeof(glm::vec2) == 8);
    const std::size_t view = add_view(bytes_of(uvs), ViewTarget::vertices);
    return add_accessor(
        {{"bufferView", view}, {"componentType", gltf::float_type}, {"count", uvs.size()}, {"type", "VEC2"}});
}

std::span<const std::uint8_t> GltfDocument::view_bytes(const Json& view) const {
    const auto number = view.value("buffer", std::size_t{0});
    const std::span<const std::uint8_t> buffer = number == 0 ? m_source : m_added.at(number - 1);
    const std::size_t offset = view.value("byteOffset", std::size_t{0});
    const auto length = view.at("byteLength").get<std::size_t>();
    if (offset > buffer.size() || length > buffer.size() - offset) {
        damaged("a buffer view reaches beyond the buffer");
    }
    return buffer.subspan(offset, length);
}

std::size_t GltfDocument::gather(std::size_t index, std::span<const std::uint32_t> elements, bool bounds) {
    const auto [known, is_new] = m_gathered.try_emplace({index, bounds, hash_of_values(elements)}, 0);
    if (is_new) {
        known->second = gather_anew(index, elements, bounds);
    }
    return known->second;
}

std::size_t GltfDocument::gather_anew(std::size_t index, std::span<const std::uint32_t> elements, bool bounds) {
    Json accessor = json.at("accessors").at(index);
    const gltf::ElementType type = type_of(accessor);
    const auto count = accessor.at("count").get<std::size_t>();
    if (std::any_of(elements.begin(), elements.end(), [&](std::uint32_t element) { return element >= count; })) {
        damaged("accessor " + std::to_string(index) + " has fewer elements than its mesh has vertices");
    }
    bounds = bounds || accessor.contains("min") || accessor.contains("max");
    const std::size_t size = type.size();
    const std::size_t stride = type.vertex_stride();
    std::vector<std::uint8_t> packed(elements.size() * stride);
    if (accessor.contains("bufferView")) { // else all elements are 0
        const Json& view = json.at("bufferViews").at(accessor["bufferView"].get<std::size_t>());
        const std::size_t source_stride = view.value("byteStride", size);
        const std::size_t offset = accessor.value("byteOffset", std::size_t{0});
        const std::span<const std::uint8_t> bytes = view_bytes(view);
        if (count > 0 && (offset > bytes.size() || size > bytes.size() - offset ||
                          (count - 1) > (bytes.size() - offset - size) / std::max<std::size_t>(source_stride, 1))) {
            damaged("accessor " + std::to_string(index) + " reaches beyond its view");
        }
        for (std::size_t element = 0; element < elements.size(); ++element) {
            std::memcpy(packed.data() + element * stride, bytes.data() + offset + elements[element] * source_stride,
                        size);
        }
    }
    if (bounds) {
        set_bounds(accessor, packed, type);
    }
    accessor["bufferView"] = add_view(std::move(packed), ViewTarget::vertices, stride == size ? 0 : stride);
    accessor["count"] = elements.size();
    accessor.erase("byteOffset");
    return add_accessor(std::move(accessor));
}

void GltfDocument::drop_unused_accessors() {
    Json& accessors = json["accessors"];
    std::vector<bool> used(accessors.size(), false);
    for_each_accessor_reference(json, [&](const Json& index) { used.at(index.get<std::size_t>()) = true; });
    std::vector<std::size_t> places(used.size());
    Json kept = Json::array();
    for (std::size_t index = 0; index < used.size(); ++index) {
        places[index] = kept.size();
        if (used[index]) {
            kept.push_back(std::move(accessors[index]));
        }
    }
    for_each_accessor_reference(json, [&](Json& index) { index = places[index.get<std::size_t>()]; });
    accessors = std::move(kept);
}

std::vector<std::span<const std::uint8_t>> GltfDocument::drop_unused_views() {
    Json views = std::move(json["bufferViews"]);
    json.erase("bufferViews");
    std::vector<bool> used(views.size(), false);
    for_each_member(json, "bufferView", [&](const Json& index) { used.at(index.get<std::size_t>()) = true; });
    std::vector<std::size_t> places(used.size());
    std::vector<std::span<const std::uint8_t>> binary;
    std::size_t size = 0;
    Json kept = Json::array();
    for (std::size_t index = 0; index < used.size(); ++index) {
        places[index] = kept.size();
        if (!used[index]) {
            continue;
        }
        binary.push_back(view_bytes(views[index]));
        views[index]["buffer"] = 0;
        views[index]["byteOffset"] = size;
        size += glb::padded(binary.back().size());
        kept.push_back(std::move(views[index]));
    }
    for_each_member(json, "bufferView", [&](Json& index) { index = places[index.get<std::size_t>()]; });
    json["bufferViews"] = std::move(kept);
    json["buffers"] = Json::array();
    if (size > 0) {
        json["buffers"].push_back({{"byteLength", size}});
    }
    return binary;
}

std::vector<std::uint8_t> GltfDocument::to_glb() {
    drop_unused_accessors();
    const std::vector<std::span<const std::uint8_t>> binary = drop_unused_views();
    for (const char* name : {"accessors", "bufferViews", "buffers"}) {
        if (json[name].empty()) {
            json.erase(name); // glTF allows no empty arrays
        }
    }
    const std::string text = json.dump();
    const std::size_t size = glb::size_of<std::uint8_t>(text, binary);
    if (size > glb::largest_size) {
        throw Error(ErrorKind::output, "the baked scene has " + std::to_string(size >> 20U) +
                                           " MiB, more than the 4 GiB that a GLB can hold; split the scene");
    }
    return glb::make<std::uint8_t>(text, binary);
}

} // namespace vkbake
