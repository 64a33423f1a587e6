#include "load/meshes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "load/normals.hpp"
#include "load/vertices.hpp"

namespace vkbake::gltf {

namespace {

/// Many primitives may share one accessor, so a short file can ask for more than any machine holds.
constexpr std::size_t most_vertices = std::size_t{1} << 28U;
constexpr std::size_t most_triangles = std::size_t{1} << 28U;

template<typename Vector>
bool is_finite(const Vector& vector) {
    for (glm::length_t i = 0; i < Vector::length(); ++i) {
        if (!std::isfinite(vector[i])) {
            return false;
        }
    }
    return true;
}

/// Which accessors an attribute may have: glTF 2.0 §3.7.2.1, and KHR_mesh_quantization where the document uses it.
struct AttributeRule {
    bool four_allowed = false; ///< VEC4 beside VEC3 (colours)
    int type = TINYGLTF_TYPE_VEC3;
    bool unsigned_normalized = false; ///< unsigned bytes and shorts, normalised
    bool quantized_signed = false;    ///< with the extension: signed bytes and shorts too …
    bool quantized_any = false;       ///< … and all of them, normalised or not
};

constexpr AttributeRule position_rule{.quantized_any = true};
constexpr AttributeRule normal_rule{.quantized_signed = true};
constexpr AttributeRule tangent_rule{.type = TINYGLTF_TYPE_VEC4, .quantized_signed = true};
constexpr AttributeRule tex_coord_rule{.type = TINYGLTF_TYPE_VEC2, .unsigned_normalized = true, .quantized_any = true};
constexpr AttributeRule color_rule{.four_allowed = true, .unsigned_normalized = true};

bool allows(const AttributeRule& rule, const tinygltf::Accessor& accessor, bool quantization) {
    if (accessor.type != rule.type && !(rule.four_allowed && accessor.type == TINYGLTF_TYPE_VEC4)) {
        return false;
    }
    switch (accessor.componentType) {
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return true;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return (quantization && rule.quantized_any) || (rule.unsigned_normalized && accessor.normalized);
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return quantization && (rule.quantized_any || (rule.quantized_signed && accessor.normalized));
    default:
        return false;
    }
}

/// The vertex numbers of each triangle of a strip or fan, in the specification's order; a list is itself.
std::vector<std::uint32_t> triangulate(int mode, std::vector<std::uint32_t> vertices) {
    if (mode == TINYGLTF_MODE_TRIANGLES) {
        vertices.resize(vertices.size() / 3 * 3);
        return vertices;
    }
    std::vector<std::uint32_t> triangles;
    if (vertices.size() < 3) {
        return triangles;
    }
    triangles.reserve((vertices.size() - 2) * 3);
    for (std::size_t i = 0; i + 2 < vertices.size(); ++i) {
        if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
            triangles.insert(triangles.end(), {vertices[i], vertices[i + 1 + i % 2], vertices[i + 2 - i % 2]});
        } else {
            triangles.insert(triangles.end(), {vertices[i + 1], vertices[i + 2], vertices[0]});
        }
    }
    return triangles;
}

class MeshMaker {
public:
    MeshMaker(Context& context, const Model& model, std::span<const Material> materials)
        : m_context(context), m_model(model), m_materials(materials) {
        const auto& used = model.data.extensionsUsed;
        m_quantization = std::find(used.begin(), used.end(), "KHR_mesh_quantization") != used.end();
    }

    Mesh make(std::size_t index) {
        const tinygltf::Mesh& source = m_model.data.meshes.at(index);
        Mesh mesh;
        mesh.name = source.name;
        mesh.source_mesh = static_cast<std::uint32_t>(index);
        for (std::size_t i = 0; i < source.primitives.size(); ++i) {
            m_where = describe("mesh", index, source.name) + ", primitive " + std::to_string(i);
            auto primitive = make_primitive(source.primitives[i]);
            if (primitive) {
                primitive->source_primitive = static_cast<std::uint32_t>(i);
                mesh.primitives.push_back(*std::move(primitive));
            }
        }
        return mesh;
    }

private:
    [[nodiscard]] const tinygltf::Accessor& accessor(int index) const {
        return m_model.data.accessors.at(static_cast<std::size_t>(index));
    }

    [[nodiscard]] std::string named(int index) const {
        return describe("accessor", static_cast<std::size_t>(index), accessor(index).name);
    }

    [[noreturn]] void fail(const std::string& what, int index) const {
        m_context.fail(what + " (" + m_where + ", " + named(index) + ')');
    }

    /// The accessor of an attribute, of a type that the rule allows.
    [[nodiscard]] std::optional<int> find(const tinygltf::Primitive& source, const std::string& semantic,
                                          const AttributeRule& rule) const {
        const auto found = source.attributes.find(semantic);
        if (found == source.attributes.end()) {
            return std::nullopt;
        }
        if (!allows(rule, accessor(found->second), m_quantization)) {
            const bool may_be_quantized = allows(rule, accessor(found->second), true);
            fail(semantic + " has a type that it must not have" +
                     (may_be_quantized ? " without KHR_mesh_quantization in extensionsUsed" : ""),
                 found->second);
        }
        return found->second;
    }

    std::optional<Primitive> make_primitive(const tinygltf::Primitive& source) {
        if (source.mode < TINYGLTF_MODE_TRIANGLES) {
            m_context.note(m_where + " has " + (source.mode == TINYGLTF_MODE_POINTS ? "points" : "lines") +
                           ", which are not baked: skipped");
            return std::nullopt;
        }
        const auto position = find(source, "POSITION", position_rule);
        if (!position) {
            m_context.note(m_where + " has no POSITION: skipped");
            return std::nullopt;
        }
        check_counts(source, *position);
        if (!source.targets.empty()) {
            m_context.note(m_where + " has morph targets: its base shape is baked");
        }
        Primitive primitive;
        if (source.material >= 0) {
            primitive.material = static_cast<std::uint32_t>(source.material);
        }
        read_positions(primitive, *position);
        read_triangles(primitive, source);
        if (const auto normal = find(source, "NORMAL", normal_rule)) {
            primitive.normals = read_vec3(m_model, static_cast<std::size_t>(*normal));
            repair_normals(m_context, m_where, primitive);
        }
        read_tangents(primitive, source);
        read_tex_coords(primitive, source);
        read_colors(primitive, source);
        return primitive;
    }

    void check_counts(const tinygltf::Primitive& source, int position) {
        const std::size_t count = accessor(position).count;
        for (const auto& [semantic, index] : source.attributes) {
            if (accessor(index).count != count) {
                fail(semantic + " has " + std::to_string(accessor(index).count) + " vertices, POSITION " +
                         std::to_string(count),
                     index);
            }
            const auto view = accessor(index).bufferView;
            const std::size_t stride =
                view < 0 ? 0 : m_model.data.bufferViews.at(static_cast<std::size_t>(view)).byteStride;
            if (accessor(index).byteOffset % 4 != 0 || (stride == 0 && element_size(accessor(index)) % 4 != 0)) {
                m_context.note(m_where + ": the vertices of " + semantic +
                               " do not start at multiples of 4 bytes, against the glTF specification");
            }
        }
        if (count > most_vertices - m_vertices) {
            m_context.fail("its primitives have more than " + std::to_string(most_vertices) + " vertices together",
                           "split the scene");
        }
        m_vertices += count;
    }

    static std::size_t element_size(const tinygltf::Accessor& accessor) {
        const int bytes = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType));
        const int components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
        return static_cast<std::size_t>(bytes) * static_cast<std::size_t>(components);
    }

    void read_positions(Primitive& primitive, int index) const {
        primitive.positions = read_vec3(m_model, static_cast<std::size_t>(index));
        const auto bad = std::find_if_not(primitive.positions.begin(), primitive.positions.end(), is_finite<glm::vec3>);
        if (bad != primitive.positions.end()) {
            fail("the position of vertex " + std::to_string(bad - primitive.positions.begin()) + " is not finite",
                 index);
        }
    }

    void read_triangles(Primitive& primitive, const tinygltf::Primitive& source) {
        std::vector<std::uint32_t> vertices;
        if (source.indices >= 0) {
            vertices = read_checked_indices(source.indices, primitive.positions.size());
        } else {
            vertices.resize(primitive.positions.size());
            for (std::size_t i = 0; i < vertices.size(); ++i) {
                vertices[i] = static_cast<std::uint32_t>(i);
            }
        }
        if (vertices.size() < 3 || (source.mode == TINYGLTF_MODE_TRIANGLES && vertices.size() % 3 != 0)) {
            m_context.note(m_where + ": " + std::to_string(vertices.size()) + " vertices do not make whole triangles");
        }
        primitive.indices = triangulate(source.mode, std::move(vertices));
        const std::size_t triangles = primitive.indices.size() / 3;
        if (triangles > most_triangles - m_triangles) {
            m_context.fail("its meshes have more than " + std::to_string(most_triangles) + " triangles together",
                           "split the scene");
        }
        m_triangles += triangles;
    }

    [[nodiscard]] std::vector<std::uint32_t> read_checked_indices(int index, std::size_t vertex_count) const {
        const tinygltf::Accessor& source = accessor(index);
        const bool unsigned_type = source.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                                   source.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                                   source.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
        if (source.type != TINYGLTF_TYPE_SCALAR || !unsigned_type || source.normalized) {
            fail("the indices are not scalars of an unsigned integer type", index);
        }
        if (source.bufferView >= 0 &&
            m_model.data.bufferViews.at(static_cast<std::size_t>(source.bufferView)).byteStride != 0) {
            fail("the indices lie in a bufferView with a byteStride", index);
        }
        if (source.count / 3 > most_triangles) {
            fail("there are more than " + std::to_string(most_triangles) + " triangles", index);
        }
        std::vector<std::uint32_t> indices = read_indices(m_model, static_cast<std::size_t>(index));
        const auto size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(source.componentType));
        const std::uint32_t restart = std::numeric_limits<std::uint32_t>::max() >> (32 - 8 * size);
        for (const std::uint32_t vertex : indices) {
            if (vertex == restart) {
                fail("index " + std::to_string(vertex) + " is a primitive restart, which glTF forbids", index);
            }
            if (vertex >= vertex_count) {
                fail("index " + std::to_string(vertex) + " is none of the " + std::to_string(vertex_count) +
                         " vertices",
                     index);
            }
        }
        return indices;
    }

    [[nodiscard]] bool needs_tangents(const Primitive& primitive) const {
        if (!primitive.material || *primitive.material >= m_materials.size() || primitive.normals.empty()) {
            return false;
        }
        const Material& material = m_materials[*primitive.material];
        return material.normal_map && material.light_map && !material.light_map->directional_files[0].empty();
    }

    void read_tangents(Primitive& primitive, const tinygltf::Primitive& source) {
        const auto index = needs_tangents(primitive) ? find(source, "TANGENT", tangent_rule) : std::nullopt;
        if (!index) {
            return;
        }
        auto tangents = read_vec4(m_model, static_cast<std::size_t>(*index));
        if (std::all_of(tangents.begin(), tangents.end(), is_finite<glm::vec4>)) {
            primitive.tangents = std::move(tangents);
        } else {
            m_context.note(m_where + ": TANGENT holds values that are not finite: ignored");
        }
    }

    void read_tex_coords(Primitive& primitive, const tinygltf::Primitive& source) {
        for (std::size_t set = 0; set < primitive.tex_coords.size(); ++set) {
            const std::string semantic = "TEXCOORD_" + std::to_string(set);
            const auto index = find(source, semantic, tex_coord_rule);
            if (!index) {
                continue;
            }
            auto values = read_vec2(m_model, static_cast<std::size_t>(*index));
            if (std::all_of(values.begin(), values.end(), is_finite<glm::vec2>)) {
                primitive.tex_coords.at(set) = std::move(values);
            } else {
                m_context.note(m_where + ": " + semantic + " holds values that are not finite: ignored");
            }
        }
    }

    void read_colors(Primitive& primitive, const tinygltf::Primitive& source) {
        const auto index = find(source, "COLOR_0", color_rule);
        if (!index) {
            return;
        }
        std::vector<glm::vec4> colors;
        if (accessor(*index).type == TINYGLTF_TYPE_VEC4) {
            colors = read_vec4(m_model, static_cast<std::size_t>(*index));
        } else {
            const auto opaque = read_vec3(m_model, static_cast<std::size_t>(*index));
            colors.reserve(opaque.size());
            std::transform(opaque.begin(), opaque.end(), std::back_inserter(colors),
                           [](const glm::vec3& color) { return glm::vec4(color, 1.0F); });
        }
        if (std::all_of(colors.begin(), colors.end(), is_finite<glm::vec4>)) {
            primitive.colors = std::move(colors);
        } else {
            m_context.note(m_where + ": COLOR_0 holds values that are not finite: ignored");
        }
    }

    Context& m_context;
    const Model& m_model;
    std::span<const Material> m_materials;
    bool m_quantization = false;
    std::string m_where;
    std::size_t m_vertices = 0;
    std::size_t m_triangles = 0;
};

} // namespace

std::vector<Mesh> make_meshes(Context& context, const Model& model, std::span<const Material> materials) {
    MeshMaker maker(context, model, materials);
    std::vector<Mesh> meshes;
    for (std::size_t i = 0; i < model.data.meshes.size(); ++i) {
        meshes.push_back(maker.make(i));
    }
    return meshes;
}

} // namespace vkbake::gltf
