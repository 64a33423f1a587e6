// A glTF document that is being changed: JSON and the bytes its views refer to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "base/gltf_element.hpp"
#include "base/json.hpp"
#include "vkbake/scene.hpp"

namespace vkbake {

using gltf::ViewTarget;

/// Changes go into `json` and, for bytes, through the functions below. Nothing is removed before `to_glb`.
class GltfDocument {
public:
    /// The source must outlive the document. Throws Error{bad_input} where its JSON cannot be parsed.
    explicit GltfDocument(const SourceDocument& source);

    Json json;

    /// A view of bytes that start at a multiple of 4. Returns its index.
    std::size_t add_view(std::vector<std::uint8_t> bytes, ViewTarget target, std::size_t stride = 0);
    std::size_t add_accessor(Json accessor);
    /// Unsigned, as small as the greatest index allows (16 or 32 bits). The same indices again are the same accessor.
    std::size_t add_indices(std::span<const std::uint32_t> indices, std::size_t vertex_count);
    /// VEC2 of floats.
    std::size_t add_uvs(std::span<const glm::vec2> uvs);
    /// The elements of accessor `index` that `elements` names, in that order, their bytes as they are. With `min` and
    /// `max` where the accessor had them or `bounds` asks for them. The same again is the same accessor: instances of a
    /// mesh share what does not differ. Throws Error{bad_input} for what lies outside.
    std::size_t gather(std::size_t index, std::span<const std::uint32_t> elements, bool bounds);

    /// A binary glTF with one buffer, of the accessors and views that are referred to; each view starts at a multiple
    /// of 4 bytes. Throws Error{output} above glTF's 4 GiB.
    [[nodiscard]] std::vector<std::uint8_t> to_glb();

private:
    [[nodiscard]] std::span<const std::uint8_t> view_bytes(const Json& view) const;
    void drop_unused_accessors();
    std::size_t gather_anew(std::size_t index, std::span<const std::uint32_t> elements, bool bounds);
    /// Leaves one buffer, of what is returned.
    [[nodiscard]] std::vector<std::span<const std::uint8_t>> drop_unused_views();

    std::span<const std::uint8_t> m_source;
    std::vector<std::vector<std::uint8_t>> m_added; ///< a view of buffer i + 1 is all of m_added[i], until to_glb
    std::map<std::tuple<std::size_t, bool, std::string>, std::size_t> m_gathered; ///< by what was asked; a hash of many
    std::map<std::pair<bool, std::string>, std::size_t> m_indices;                ///< by width and hash
};

/// Calls visit(value) for every member named `key`, at any depth, but for what lies in extras, whose names mean
/// nothing.
template<typename Visit>
void for_each_member(Json& node, const char* key, const Visit& visit) {
    if (node.is_object()) {
        for (auto& [name, value] : node.items()) {
            if (name == key) {
                visit(value);
            }
            if (name != "extras") {
                for_each_member(value, key, visit);
            }
        }
    } else if (node.is_array()) {
        for (Json& value : node) {
            for_each_member(value, key, visit);
        }
    }
}

} // namespace vkbake
