#include "write/lit_materials.hpp"

#include <algorithm>

#include "vkbake/names.hpp"

namespace vkbake {
namespace {

constexpr const char* light_map_extension = "MOZ_lightmap";

Json* find(Json& object, const char* key) {
    const auto place = object.is_object() ? object.find(key) : object.end();
    return place != object.end() ? &*place : nullptr;
}

void erase_if_empty(Json& object, const char* key) {
    const Json* const member = find(object, key);
    if (member != nullptr && member->empty()) {
        object.erase(key);
    }
}

/// The index in a texture reference, if it has one.
std::optional<std::size_t> texture_of(const Json& reference) {
    const auto place = reference.is_object() ? reference.find("index") : reference.end();
    return place != reference.end() && place->is_number_unsigned() ? std::optional(place->get<std::size_t>())
                                                                   : std::nullopt;
}

/// Takes an earlier bake's light map out of a material. Returns the textures it referred to.
std::set<std::size_t> strip_light_map(Json& material) {
    std::set<std::size_t> textures;
    const auto remove = [&](Json& object, const char* key) {
        if (const Json* const reference = find(object, key)) {
            if (const auto texture = texture_of(*reference)) {
                textures.insert(*texture);
            }
            object.erase(key);
        }
    };
    if (Json* const extensions = find(material, "extensions")) {
        remove(*extensions, light_map_extension);
        erase_if_empty(material, "extensions");
    }
    Json* const extras = find(material, "extras");
    if (Json* const own = extras != nullptr ? find(*extras, "vkbake") : nullptr) {
        if (own->is_object() && own->value("mode", Json()) != "irradiance") {
            remove(material, "occlusionTexture");
        }
        extras->erase("vkbake");
        erase_if_empty(material, "extras");
    }
    return textures;
}

/// Calls visit(set) for each number of a texture coordinate set in the material's texture references.
template<typename Visit>
void for_each_set(Json& material, const Visit& visit) {
    for_each_member(material, "texCoord", [&](Json& set) {
        if (set.is_number_unsigned()) {
            visit(set);
        }
    });
}

std::vector<bool> used_materials(GltfDocument& document, std::size_t count) {
    std::vector<bool> used(count, false);
    if (document.json.contains("meshes")) {
        for_each_member(document.json["meshes"], "material",
                        [&](const Json& material) { used.at(material.get<std::size_t>()) = true; });
    }
    return used;
}

/// Texture indices that any material refers to. Extensions name their references as they like, but all have an "index".
std::set<std::size_t> used_textures(Json& materials) {
    std::set<std::size_t> used;
    for_each_member(materials, "index", [&](const Json& index) {
        if (index.is_number_unsigned()) {
            used.insert(index.get<std::size_t>());
        }
    });
    return used;
}

std::set<std::size_t> images_of(const Json& texture) {
    std::set<std::size_t> images;
    Json copy = texture;
    for_each_member(copy, "source", [&](const Json& image) { images.insert(image.get<std::size_t>()); });
    return images;
}

/// Puts new entries into the free places of an array, then behind it. Free places that are left over are cut off at the
/// end; elsewhere they repeat the first new entry, since a removal would change the numbers of those behind.
std::vector<std::size_t> place_entries(Json& array, std::set<std::size_t> free, const std::vector<Json>& entries) {
    std::vector<std::size_t> places;
    for (const Json& entry : entries) {
        if (free.empty()) {
            places.push_back(array.size());
            array.push_back(entry);
        } else {
            places.push_back(*free.begin());
            array.at(*free.begin()) = entry;
            free.erase(free.begin());
        }
    }
    while (!free.empty() && *free.rbegin() + 1 == array.size()) {
        array.erase(array.size() - 1);
        free.erase(*free.rbegin());
    }
    for (const std::size_t place : free) {
        if (!entries.empty()) {
            array.at(place) = entries.front();
        }
    }
    return places;
}

/// Linear filtering without mip levels, which would mix charts; clamped.
std::size_t light_map_sampler(Json& document) {
    const Json sampler{{"magFilter", 9729}, {"minFilter", 9729}, {"wrapS", 33071}, {"wrapT", 33071}};
    Json& samplers = document["samplers"];
    for (std::size_t index = 0; index < samplers.size(); ++index) {
        if (samplers[index] == sampler) {
            return index;
        }
    }
    samplers.push_back(sampler);
    return samplers.size() - 1;
}

} // namespace

LitMaterials::LitMaterials(GltfDocument& document, std::span<const DisplayMap> maps, Mode mode)
    : m_document(document), m_maps(maps), m_mode(mode),
      m_source_count(document.json.contains("materials") ? document.json["materials"].size() : 0) {}

bool LitMaterials::uses_set_1(std::optional<std::size_t> material) const {
    bool uses = false;
    if (material) {
        Json copy = m_document.json.at("materials").at(*material);
        strip_light_map(copy);
        for_each_set(copy, [&](const Json& set) { uses = uses || set == 1; });
    }
    return uses;
}

std::size_t LitMaterials::lit(std::optional<std::size_t> material, std::uint32_t page, int moved_set) {
    const std::ptrdiff_t source = material ? static_cast<std::ptrdiff_t>(*material) : -1;
    const auto [place, is_new] = m_numbers.try_emplace({source, page, moved_set}, m_source_count + m_variants.size());
    if (is_new) {
        Variant variant{material, page, Json::object()};
        if (material) {
            variant.material = m_document.json.at("materials").at(*material);
            m_retired_textures.merge(strip_light_map(variant.material));
        }
        for_each_set(variant.material, [&](Json& set) {
            if (set == 1) {
                set = moved_set;
            }
        });
        m_variants.push_back(std::move(variant));
    }
    return place->second;
}

std::vector<std::string> LitMaterials::finish() {
    if (m_variants.empty()) {
        return {};
    }
    const std::map<std::size_t, std::size_t> places = place_materials();
    for_each_member(m_document.json["meshes"], "material", [&](Json& material) {
        if (const auto place = places.find(material.get<std::size_t>()); place != places.end()) {
            material = place->second;
        }
    });
    const std::vector<std::size_t> textures = place_textures();
    for (std::size_t index = 0; index < m_variants.size(); ++index) {
        const std::uint32_t page = m_variants[index].page;
        Json& material = m_document.json["materials"].at(places.at(m_source_count + index));
        refer_to_light_map(material, m_maps[page], textures.at(page));
    }
    list_extension();
    return std::move(m_notes);
}

/// From the numbers that `lit` gave out to the final ones.
std::map<std::size_t, std::size_t> LitMaterials::place_materials() {
    std::vector<bool> taken = used_materials(m_document, m_source_count + m_variants.size());
    std::map<std::size_t, std::size_t> places;
    Json& materials = m_document.json["materials"];
    for (std::size_t index = 0; index < m_variants.size(); ++index) {
        const Variant& variant = m_variants[index];
        if (variant.source && !taken.at(*variant.source)) {
            taken.at(*variant.source) = true;
            places[m_source_count + index] = *variant.source;
            materials.at(*variant.source) = variant.material;
        } else {
            places[m_source_count + index] = materials.size();
            materials.push_back(variant.material);
        }
    }
    return places;
}

/// The texture of each page.
std::vector<std::size_t> LitMaterials::place_textures() {
    Json& json = m_document.json;
    const std::set<std::size_t> used = used_textures(json["materials"]);
    std::set<std::size_t> free_textures;
    std::set<std::size_t> free_images;
    std::set<std::size_t> used_images;
    for (std::size_t index = 0; index < json["textures"].size(); ++index) {
        const bool retired = m_retired_textures.contains(index) && !used.contains(index);
        if (retired) {
            free_textures.insert(index);
        }
        (retired ? free_images : used_images).merge(images_of(json["textures"][index]));
    }
    for (const std::size_t image : used_images) {
        free_images.erase(image);
    }
    std::vector<Json> images;
    for (const DisplayMap& map : m_maps) {
        const std::size_t view = m_document.add_view(map.png, ViewTarget::none);
        images.push_back({{"name", map.name}, {"mimeType", "image/png"}, {"bufferView", view}});
    }
    const std::vector<std::size_t> sources = place_entries(json["images"], free_images, images);
    const std::size_t sampler = light_map_sampler(json);
    std::vector<Json> textures;
    for (std::size_t page = 0; page < m_maps.size(); ++page) {
        textures.push_back({{"name", m_maps[page].name}, {"sampler", sampler}, {"source", sources[page]}});
    }
    return place_entries(json["textures"], free_textures, textures);
}

void LitMaterials::refer_to_light_map(Json& material, const DisplayMap& map, std::size_t texture) {
    if (m_mode != Mode::irradiance) {
        if (material.contains("occlusionTexture")) {
            m_notes.push_back("material \"" + material.value("name", std::string()) +
                              "\": its own occlusion texture was replaced by the baked one");
        }
        material["occlusionTexture"] = {{"index", texture}, {"texCoord", 1}};
    } else {
        material["extensions"][light_map_extension] = {
            {"index", texture}, {"texCoord", 1}, {"intensity", map.intensity}};
    }
    Json& extras = material["extras"];
    if (!extras.is_object() && !extras.is_null()) {
        extras = {{"source", std::move(extras)}}; // glTF lets extras be anything
    }
    extras["vkbake"] = {{"lightMap", map.linear_file}, {"mode", name_of(m_mode)}};
    if (!map.directional_files.empty()) {
        extras["vkbake"]["directional"] = map.directional_files;
    }
}

void LitMaterials::list_extension() {
    Json& json = m_document.json;
    bool used = false;
    for_each_member(json["materials"], light_map_extension, [&](const Json&) { used = true; });
    for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
        if (Json* const names = find(json, list)) {
            names->erase(std::remove(names->begin(), names->end(), light_map_extension), names->end());
        }
    }
    if (used) {
        json["extensionsUsed"].push_back(light_map_extension);
    }
    erase_if_empty(json, "extensionsUsed");
    erase_if_empty(json, "extensionsRequired");
}

} // namespace vkbake
