// The document's materials with light maps: one for each material and page that are used together.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "vkbake/settings.hpp"
#include "write/display_map.hpp"
#include "write/document.hpp"

namespace vkbake {

/// Meshes get the numbers that `lit` gives out; `finish` then puts the materials, textures and images into the
/// document.
class LitMaterials {
public:
    LitMaterials(GltfDocument& document, std::span<const DisplayMap> maps, Mode mode);

    /// Whether a texture of the material, light maps of an earlier bake aside, is read by TEXCOORD_1.
    [[nodiscard]] bool uses_set_1(std::optional<std::size_t> material) const;

    /// The material (absent: glTF's default one) with the light map of `page`, and what it read by TEXCOORD_1 read by
    /// TEXCOORD_`moved_set`. The same arguments give the same number.
    [[nodiscard]] std::size_t lit(std::optional<std::size_t> material, std::uint32_t page, int moved_set = 1);

    /// Once, when the document's meshes are final. A material that nothing uses any more gives its place to its first
    /// lit variant, so that what else in the file counts materials stays right; so do textures and images of earlier
    /// light maps. Returns what the user should know.
    [[nodiscard]] std::vector<std::string> finish();

private:
    struct Variant {
        std::optional<std::size_t> source;
        std::uint32_t page = 0;
        Json material;
    };

    std::map<std::size_t, std::size_t> place_materials();
    std::vector<std::size_t> place_textures();
    void refer_to_light_map(Json& material, const DisplayMap& map, std::size_t texture);
    void list_extension();

    GltfDocument& m_document;
    std::span<const DisplayMap> m_maps;
    Mode m_mode;
    std::size_t m_source_count;
    std::vector<Variant> m_variants; ///< number m_source_count + i until `finish`
    std::map<std::tuple<std::ptrdiff_t, std::uint32_t, int>, std::size_t> m_numbers;
    std::set<std::size_t> m_retired_textures; ///< of earlier light maps; some may still be in use
    std::vector<std::string> m_notes;
};

} // namespace vkbake
