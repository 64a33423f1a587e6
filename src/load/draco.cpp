#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "load/draco_mesh.hpp"
#include "load/fields.hpp"
#include "load/layout.hpp"
#include "load/normalise.hpp"

namespace vkbake::gltf {

namespace {

constexpr const char* draco_extension = "KHR_draco_mesh_compression";

/// What an accessor is to hold once its data are decoded.
struct Decoded {
    std::uint32_t view = 0;
    std::size_t count = 0;
    int component = float_type;
};

/// Least and greatest of each component. What a file states are those of the mesh before it was compressed.
void restate_bounds(Json& accessor, const ElementType& type, std::size_t stride, std::span<const std::byte> bytes) {
    if (type.component != float_type || !(accessor.contains("min") || accessor.contains("max"))) {
        return;
    }
    std::vector<float> low(type.rows, INFINITY);
    std::vector<float> high(type.rows, -INFINITY);
    for (std::size_t offset = 0; offset + type.size() <= bytes.size(); offset += stride) {
        for (std::size_t row = 0; row < type.rows; ++row) {
            float value = 0.0F;
            std::memcpy(&value, &bytes[offset + 4 * row], sizeof(value));
            low[row] = std::min(low[row], value);
            high[row] = std::max(high[row], value);
        }
    }
    accessor["min"] = low;
    accessor["max"] = high;
}

class Decoder {
public:
    Decoder(Context& context, Document& document) : m_context(context), m_document(document) {}

    void decode(std::size_t mesh_index, std::size_t primitive_index) {
        // A copy: decoding adds to the document, which would move what references point to.
        Json primitive = m_document.json["meshes"][mesh_index]["primitives"][primitive_index];
        const Json untouched = primitive;
        const Fields fields(m_context, untouched,
                            describe("mesh", mesh_index, "") + ", primitive " + std::to_string(primitive_index));
        const auto extension = fields.extension(draco_extension);
        if (!extension) {
            return;
        }
        if (!has_plain_data(fields, *extension)) {
            replace_accessors(primitive, fields, *extension);
        }
        drop_extension(primitive, draco_extension);
        m_document.json["meshes"][mesh_index]["primitives"][primitive_index] = std::move(primitive);
    }

private:
    /// Whether the file holds the same mesh uncompressed too, for readers without Draco.
    [[nodiscard]] bool has_plain_data(const Fields& fields, const Fields& extension) const {
        const Fields attributes = fields.required_object("attributes");
        const auto is_plain = [&](std::uint64_t accessor) {
            return m_document.json["accessors"][accessor].contains("bufferView") && !m_filled.contains(accessor);
        };
        bool plain = fields.has("indices") && is_plain(fields.required_unsigned_integer("indices"));
        for (const auto& [semantic, unused] : extension.required_object("attributes").json().items()) {
            plain = plain && attributes.has(semantic.c_str()) &&
                    is_plain(attributes.required_unsigned_integer(semantic.c_str()));
        }
        return plain;
    }

    void replace_accessors(Json& primitive, const Fields& fields, const Fields& extension) {
        const std::uint64_t mode = fields.unsigned_integer("mode").value_or(4);
        if (mode != 4 && mode != 5) {
            fields.fail("it is compressed by Draco, but has no triangles");
        }
        const std::uint32_t source =
            extension.required_index("bufferView", root_array(m_context, m_document.json, "bufferViews").size());
        const DracoMesh mesh(fields, view_bytes(m_context, m_document, source));
        const Fields attributes = fields.required_object("attributes");
        const Fields ids = extension.required_object("attributes");
        for (const auto& [semantic, unused] : ids.json().items()) {
            const auto id = ids.index(semantic.c_str(), std::size_t{1} << 32U);
            const auto accessor = attributes.index(semantic.c_str(), m_document.json["accessors"].size());
            if (!accessor) {
                fields.fail("Draco's attribute " + printable(semantic) + " is none of its attributes");
            }
            primitive["attributes"][semantic] = decode_attribute(mesh, source, *id, *accessor);
        }
        primitive["indices"] = decode_indices(fields, mesh, source);
        primitive["mode"] = 4; // a strip too is decoded into a list
    }

    std::uint32_t decode_attribute(const DracoMesh& mesh, std::uint32_t source, std::uint32_t id, std::uint32_t index) {
        const Accessor accessor = read_accessor(m_context, m_document.json, index);
        const std::size_t stride = accessor.type.vertex_stride();
        const auto key = std::tuple(source, std::uint64_t{id}, accessor.type.component);
        auto known = m_decoded.find(key);
        if (known == m_decoded.end()) {
            reserve_bytes(m_context, m_document, mesh.point_count() * stride);
            const std::uint32_t view = append_view(m_document, mesh.attribute(id, accessor.type));
            Json& json = m_document.json["bufferViews"][view];
            json["target"] = ViewTarget::vertices;
            if (stride != accessor.type.size()) {
                json["byteStride"] = stride;
            }
            known = m_decoded.emplace(key, Decoded{view, mesh.point_count(), accessor.type.component}).first;
        }
        const std::uint32_t filled = fill(index, known->second);
        restate_bounds(m_document.json["accessors"][filled], accessor.type, stride,
                       view_bytes(m_context, m_document, known->second.view));
        return filled;
    }

    std::uint32_t decode_indices(const Fields& fields, const DracoMesh& mesh, std::uint32_t source) {
        Json& accessors = m_document.json["accessors"];
        if (!fields.has("indices")) {
            accessors.push_back({{"componentType", unsigned_int_type}, {"type", "SCALAR"}, {"count", 1}});
        }
        const std::uint32_t index =
            fields.index("indices", accessors.size()).value_or(static_cast<std::uint32_t>(accessors.size() - 1));
        int component = read_accessor(m_context, m_document.json, index).type.component;
        const auto key = std::tuple(source, indices_id, component);
        auto known = m_decoded.find(key);
        if (known == m_decoded.end()) {
            reserve_bytes(m_context, m_document, mesh.triangle_count() * 12);
            std::vector<std::byte> bytes = mesh.indices(component);
            const std::uint32_t view = append_view(m_document, std::move(bytes));
            m_document.json["bufferViews"][view]["target"] = ViewTarget::indices;
            known = m_decoded.emplace(key, Decoded{view, mesh.triangle_count() * 3, component}).first;
        }
        const std::uint32_t filled = fill(index, known->second);
        m_document.json["accessors"][filled].erase("min");
        m_document.json["accessors"][filled].erase("max");
        return filled;
    }

    /// Lets accessor `index` hold it, or a copy of that accessor where it holds something else already.
    std::uint32_t fill(std::uint32_t index, const Decoded& decoded) {
        Json& accessors = m_document.json["accessors"];
        if (accessors[index].contains("bufferView") && accessors[index]["bufferView"] != decoded.view) {
            Json copy = accessors[index];
            accessors.push_back(std::move(copy));
            index = static_cast<std::uint32_t>(accessors.size() - 1);
        }
        Json& accessor = accessors[index];
        accessor["bufferView"] = decoded.view;
        accessor["componentType"] = decoded.component;
        accessor["count"] = decoded.count;
        accessor.erase("byteOffset");
        accessor.erase("sparse");
        m_filled.insert(index);
        return index;
    }

    static constexpr std::uint64_t indices_id = ~std::uint64_t{0}; ///< no attribute's

    Context& m_context;
    Document& m_document;
    std::map<std::tuple<std::uint32_t, std::uint64_t, int>, Decoded> m_decoded; ///< by view, attribute, component type
    std::set<std::uint64_t> m_filled;                                           ///< accessors that hold decoded data
};

} // namespace

void decode_draco_primitives(Context& context, Document& document) {
    Decoder decoder(context, document);
    const std::size_t meshes = root_array(context, document.json, "meshes").size();
    for (std::size_t mesh = 0; mesh < meshes; ++mesh) {
        const std::size_t primitives = document.json["meshes"][mesh]["primitives"].size();
        for (std::size_t primitive = 0; primitive < primitives; ++primitive) {
            decoder.decode(mesh, primitive);
        }
    }
}

} // namespace vkbake::gltf
