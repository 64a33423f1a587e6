#include "write/document.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>

#include "vkbake/error.hpp"

namespace vkbake {
namespace {

[[noreturn]] void damaged(const std::string& what) {
    throw Error(ErrorKind::bad_input, "the scene's glTF document: " + what + "; load the scene again");
}

std::vector<std::uint8_t> bytes_of(const void* data, std::size_t size) {
    std::vector<std::uint8_t> bytes(size);
    if (size > 0) {
        std::memcpy(bytes.data(), data, size);
    }
    return bytes;
}

template<typename Value>
Json read_as(const std::uint8_t* bytes) {
    Value value{};
    std::memcpy(&value, bytes, sizeof(value));
    return value;
}

Json read_component(const std::uint8_t* bytes, int component_type) {
    switch (component_type) {
    case 5120:
        return read_as<std::int8_t>(bytes);
    case 5121:
        return read_as<std::uint8_t>(bytes);
    case 5122:
        return read_as<std::int16_t>(bytes);
    case 5123:
        return read_as<std::uint16_t>(bytes);
    case 5125:
        return read_as<std::uint32_t>(bytes);
    default:
        return read_as<float>(bytes);
    }
}

void set_bounds(Json& accessor, std::span<const std::uint8_t> packed, std::size_t stride, const ElementLayout& layout) {
    Json low = Json::array();
    Json high = Json::array();
    for (const std::size_t offset : layout.component_offsets) {
        Json least = read_component(packed.data() + offset, layout.component_type);
        Json greatest = least;
        for (std::size_t place = offset; place < packed.size(); place += stride) {
            const Json value = read_component(packed.data() + place, layout.component_type);
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

constexpr std::size_t largest_glb = 0xFFFFFFFFULL;

void put_word(std::vector<std::uint8_t>& bytes, std::size_t word) {
    for (unsigned shift = 0; shift < 32; shift += 8) {
        bytes.push_back(static_cast<std::uint8_t>(word >> shift));
    }
}

void pad(std::vector<std::uint8_t>& bytes, std::uint8_t filler) { bytes.resize((bytes.size() + 3) / 4 * 4, filler); }

} // namespace

ElementLayout element_layout(const Json& accessor) {
    struct Shape {
        std::string_view name;
        std::size_t rows;
        std::size_t columns;
    };
    static constexpr std::array<Shape, 7> shapes{{{"SCALAR", 1, 1},
                                                  {"VEC2", 2, 1},
                                                  {"VEC3", 3, 1},
                                                  {"VEC4", 4, 1},
                                                  {"MAT2", 2, 2},
                                                  {"MAT3", 3, 3},
                                                  {"MAT4", 4, 4}}};
    static constexpr std::array<std::size_t, 7> component_sizes{1, 1, 2, 2, 0, 4, 4};
    const auto type = accessor.at("type").get<std::string>();
    const int component_type = accessor.at("componentType").get<int>();
    const auto* const shape =
        std::find_if(shapes.begin(), shapes.end(), [&](const Shape& candidate) { return candidate.name == type; });
    if (shape == shapes.end() || component_type < 5120 || component_type > 5126 || component_type == 5124) {
        damaged("an accessor has the type " + type + " of " + std::to_string(component_type));
    }
    ElementLayout layout;
    layout.component_type = component_type;
    const std::size_t component_size = component_sizes.at(static_cast<std::size_t>(component_type - 5120));
    for (std::size_t column = 0; column < shape->columns; ++column) {
        for (std::size_t row = 0; row < shape->rows; ++row) {
            layout.component_offsets.push_back(layout.size + row * component_size);
        }
        layout.size += shape->rows * component_size;
        if (shape->columns > 1) {
            layout.size = (layout.size + 3) / 4 * 4;
        }
    }
    return layout;
}

GltfDocument::GltfDocument(const SourceDocument& source)
    : json(Json::parse(source.json, nullptr, false)),
      m_source(reinterpret_cast<const std::uint8_t*>(source.binary.data()), source.binary.size()) {
    if (!json.is_object()) {
        damaged("its JSON cannot be parsed");
    }
}

std::size_t GltfDocument::add_view(std::span<const std::uint8_t> bytes, ViewTarget target, std::size_t stride) {
    pad(m_added, 0);
    Json view{{"buffer", 1}, {"byteOffset", m_added.size()}, {"byteLength", bytes.size()}};
    if (stride > 0) {
        view["byteStride"] = stride;
    }
    if (target != ViewTarget::none) {
        view["target"] = static_cast<int>(target);
    }
    m_added.insert(m_added.end(), bytes.begin(), bytes.end());
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
    std::vector<std::uint8_t> bytes;
    if (small) {
        const std::vector<std::uint16_t> narrow(indices.begin(), indices.end());
        bytes = bytes_of(narrow.data(), narrow.size() * sizeof(std::uint16_t));
    } else {
        bytes = bytes_of(indices.data(), indices.size_bytes());
    }
    const std::size_t view = add_view(bytes, ViewTarget::indices);
    return add_accessor(
        {{"bufferView", view}, {"componentType", small ? 5123 : 5125}, {"count", indices.size()}, {"type", "SCALAR"}});
}

std::size_t GltfDocument::add_uvs(std::span<const glm::vec2> uvs) {
    static_assert(sizeof(glm::vec2) == 8);
    const std::size_t view = add_view(bytes_of(uvs.data(), uvs.size_bytes()), ViewTarget::vertices);
    return add_accessor({{"bufferView", view}, {"componentType", 5126}, {"count", uvs.size()}, {"type", "VEC2"}});
}

std::span<const std::uint8_t> GltfDocument::view_bytes(const Json& view) const {
    const std::span<const std::uint8_t> buffer = view.value("buffer", 0) == 1 ? m_added : m_source;
    const std::size_t offset = view.value("byteOffset", std::size_t{0});
    const auto length = view.at("byteLength").get<std::size_t>();
    if (offset > buffer.size() || length > buffer.size() - offset) {
        damaged("a buffer view reaches beyond the buffer");
    }
    return buffer.subspan(offset, length);
}

std::size_t GltfDocument::gather(std::size_t index, std::span<const std::uint32_t> elements, bool bounds) {
    Json accessor = json.at("accessors").at(index);
    const ElementLayout layout = element_layout(accessor);
    const auto count = accessor.at("count").get<std::size_t>();
    if (std::any_of(elements.begin(), elements.end(), [&](std::uint32_t element) { return element >= count; })) {
        damaged("accessor " + std::to_string(index) + " has fewer elements than its mesh has vertices");
    }
    bounds = bounds || accessor.contains("min") || accessor.contains("max");
    // Vertex attributes must start at multiples of 4.
    const std::size_t stride = (layout.size + 3) / 4 * 4;
    std::vector<std::uint8_t> packed(elements.size() * stride);
    if (accessor.contains("bufferView")) { // else all elements are 0
        const Json& view = json.at("bufferViews").at(accessor["bufferView"].get<std::size_t>());
        const std::size_t source_stride = view.value("byteStride", layout.size);
        const std::size_t offset = accessor.value("byteOffset", std::size_t{0});
        const std::span<const std::uint8_t> bytes = view_bytes(view);
        if (count > 0 &&
            (offset > bytes.size() || layout.size > bytes.size() - offset ||
             (count - 1) > (bytes.size() - offset - layout.size) / std::max<std::size_t>(source_stride, 1))) {
            damaged("accessor " + std::to_string(index) + " reaches beyond its view");
        }
        for (std::size_t element = 0; element < elements.size(); ++element) {
            std::memcpy(packed.data() + element * stride, bytes.data() + offset + elements[element] * source_stride,
                        layout.size);
        }
    }
    accessor["bufferView"] = add_view(packed, ViewTarget::vertices, stride == layout.size ? 0 : stride);
    accessor["count"] = elements.size();
    accessor.erase("byteOffset");
    if (bounds) {
        set_bounds(accessor, packed, stride, layout);
    }
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

std::vector<std::uint8_t> GltfDocument::drop_unused_views() {
    Json views = std::move(json["bufferViews"]);
    json.erase("bufferViews");
    std::vector<bool> used(views.size(), false);
    for_each_member(json, "bufferView", [&](const Json& index) { used.at(index.get<std::size_t>()) = true; });
    std::vector<std::size_t> places(used.size());
    std::vector<std::uint8_t> binary;
    Json kept = Json::array();
    for (std::size_t index = 0; index < used.size(); ++index) {
        places[index] = kept.size();
        if (!used[index]) {
            continue;
        }
        const std::span<const std::uint8_t> bytes = view_bytes(views[index]);
        pad(binary, 0);
        views[index]["buffer"] = 0;
        views[index]["byteOffset"] = binary.size();
        binary.insert(binary.end(), bytes.begin(), bytes.end());
        kept.push_back(std::move(views[index]));
    }
    pad(binary, 0);
    for_each_member(json, "bufferView", [&](Json& index) { index = places[index.get<std::size_t>()]; });
    json["bufferViews"] = std::move(kept);
    return binary;
}

std::vector<std::uint8_t> GltfDocument::to_glb() {
    drop_unused_accessors();
    const std::vector<std::uint8_t> binary = drop_unused_views();
    json["buffers"] = Json::array();
    if (!binary.empty()) {
        json["buffers"].push_back({{"byteLength", binary.size()}});
    }
    for (const char* name : {"accessors", "bufferViews", "buffers"}) {
        if (json[name].empty()) {
            json.erase(name); // glTF allows no empty arrays
        }
    }
    const std::string text = json.dump();
    std::vector<std::uint8_t> chunk(text.begin(), text.end());
    pad(chunk, ' ');
    const std::size_t total = 12 + 8 + chunk.size() + (binary.empty() ? 0 : 8 + binary.size());
    if (total > largest_glb) {
        throw Error(ErrorKind::output, "the baked scene has " + std::to_string(total >> 20U) +
                                           " MiB, more than the 4 GiB that a GLB can hold; split the scene");
    }
    std::vector<std::uint8_t> file;
    file.reserve(total);
    put_word(file, 0x46546C67); // "glTF"
    put_word(file, 2);
    put_word(file, total);
    put_word(file, chunk.size());
    put_word(file, 0x4E4F534A); // "JSON"
    file.insert(file.end(), chunk.begin(), chunk.end());
    if (!binary.empty()) {
        put_word(file, binary.size());
        put_word(file, 0x004E4942); // "BIN"
        file.insert(file.end(), binary.begin(), binary.end());
    }
    return file;
}

} // namespace vkbake
