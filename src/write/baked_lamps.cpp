#include "write/baked_lamps.hpp"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <vector>

namespace vkbake {
namespace {

constexpr const char* lights_extension = "KHR_lights_punctual";
constexpr const char* baked_light = "bakedLight";

/// The member of an object at the end of a path; null where it ends before.
Json* at_path(Json& object, std::initializer_list<const char*> path) {
    Json* place = &object;
    for (const char* const key : path) {
        const auto member = place->is_object() ? place->find(key) : place->end();
        if (member == place->end()) {
            return nullptr;
        }
        place = &*member;
    }
    return place;
}

/// Erases object[outer][inner], and what is empty then.
void erase_member(Json& object, const char* outer, const char* inner) {
    Json* const holder = at_path(object, {outer});
    if (holder != nullptr && holder->is_object()) {
        holder->erase(inner);
        if (holder->empty()) {
            object.erase(outer);
        }
    }
}

void erase_name(Json& document, const char* key) {
    Json* const names = at_path(document, {key});
    if (names != nullptr) {
        names->erase(std::remove(names->begin(), names->end(), Json(lights_extension)), names->end());
        if (names->empty()) {
            document.erase(key);
        }
    }
}

/// Removes the lights that no node names; the others keep their order.
void drop_unused_lights(Json& document) {
    Json* const lights = at_path(document, {"extensions", lights_extension, "lights"});
    if (lights == nullptr) {
        return;
    }
    std::vector<bool> used(lights->size(), false);
    std::vector<Json*> references;
    for (Json& node : document.at("nodes")) {
        if (Json* const light = at_path(node, {"extensions", lights_extension, "light"})) {
            used.at(light->get<std::size_t>()) = true;
            references.push_back(light);
        }
    }
    Json kept = Json::array();
    std::vector<std::size_t> places(used.size());
    for (std::size_t index = 0; index < used.size(); ++index) {
        places[index] = kept.size();
        if (used[index]) {
            kept.push_back((*lights)[index]);
        }
    }
    for (Json* const light : references) {
        *light = places[light->get<std::size_t>()];
    }
    *lights = std::move(kept);
    if (lights->empty()) {
        erase_member(document, "extensions", lights_extension);
        erase_name(document, "extensionsUsed");
        erase_name(document, "extensionsRequired");
    }
}

} // namespace

void put_lamps_aside(Json& document, std::span<const Lamp> lamps) {
    if (lamps.empty()) {
        return;
    }
    for (const Lamp& lamp : lamps) {
        Json& node = document.at("nodes").at(lamp.source_node);
        if (const Json* const light = at_path(node, {"extensions", lights_extension, "light"})) {
            const Json* const extras = at_path(node, {"extras"});
            if (extras == nullptr || extras->is_object()) { // else they are someone's that have no room for it
                node["extras"]["vkbake"][baked_light] =
                    document.at("extensions").at(lights_extension).at("lights").at(light->get<std::size_t>());
            }
            erase_member(node, "extensions", lights_extension);
        }
    }
    drop_unused_lights(document);
}

void bring_lamps_back(Json& document) {
    for (Json& node : document.at("nodes")) {
        const Json* const light = at_path(node, {"extras", "vkbake", baked_light});
        if (light == nullptr) {
            continue;
        }
        Json& lights = document["extensions"][lights_extension]["lights"];
        node["extensions"][lights_extension]["light"] = lights.size();
        lights.push_back(*light);
        node["extras"]["vkbake"].erase(baked_light);
        if (node["extras"]["vkbake"].empty()) {
            erase_member(node, "extras", "vkbake");
        }
        Json& used = document["extensionsUsed"];
        if (std::find(used.begin(), used.end(), Json(lights_extension)) == used.end()) {
            used.push_back(lights_extension);
        }
    }
}

} // namespace vkbake
