#include "load/lamps.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include <glm/geometric.hpp>

#include "load/fields.hpp"

namespace vkbake::gltf {

namespace {

constexpr const char* extension_name = "KHR_lights_punctual";

double number_from(const Fields& fields, const char* key, double absent, double least) {
    const double value = fields.number(key).value_or(absent);
    if (!(value >= least && std::isfinite(value))) {
        fields.fail('"' + std::string(key) + "\" is below " + (least == 0.0 ? "0" : std::to_string(least)) +
                    ", or not finite");
    }
    return value;
}

LampKind kind_of(const Fields& light) {
    const std::string type = light.required_string("type");
    if (type == "directional") {
        return LampKind::directional;
    }
    if (type == "point") {
        return LampKind::point;
    }
    if (type == "spot") {
        return LampKind::spot;
    }
    light.fail("\"type\" is \"" + printable(type) + "\", which KHR_lights_punctual does not have");
}

void read_cone(const Fields& light, Lamp& lamp) {
    constexpr double widest = std::numbers::pi / 2.0;
    constexpr double rounding = 1e-6; // of an exporter that writes floats
    const auto spot = light.object("spot");
    if (!spot) {
        return;
    }
    lamp.inner_cone = number_from(*spot, "innerConeAngle", 0.0, 0.0);
    lamp.outer_cone = number_from(*spot, "outerConeAngle", lamp.outer_cone, 0.0);
    if (lamp.outer_cone == 0.0 || lamp.outer_cone > widest + rounding) {
        spot->fail("\"outerConeAngle\" is not above 0 and at most pi / 2");
    }
    if (lamp.inner_cone > lamp.outer_cone + rounding) {
        spot->fail("\"innerConeAngle\" is greater than \"outerConeAngle\"");
    }
    lamp.outer_cone = std::min(lamp.outer_cone, widest);
    lamp.inner_cone = std::min(lamp.inner_cone, lamp.outer_cone);
}

/// extras.vkbake of a light or a node.
std::optional<Fields> own_extras(const Fields& object) {
    // Extras of others may be anything.
    const auto extras = object.json().find("extras");
    if (extras == object.json().end() || !extras->is_object()) {
        return std::nullopt;
    }
    return object.required_object("extras").object("vkbake");
}

void read_size(const Fields& object, Lamp& lamp) {
    const auto own = own_extras(object);
    if (!own) {
        return;
    }
    constexpr double widest = 90.0;
    if (lamp.kind == LampKind::directional) {
        lamp.angular_diameter = number_from(*own, "angularDiameter", lamp.angular_diameter, 0.0);
        if (lamp.angular_diameter > widest) {
            own->fail("\"angularDiameter\" is above 90 degrees");
        }
    } else {
        lamp.radius = number_from(*own, "radius", lamp.radius, 0.0);
    }
}

Lamp read_light(const Fields& light) {
    Lamp lamp;
    lamp.name = light.string("name").value_or("");
    lamp.kind = kind_of(light);
    if (const auto color = light.numbers("color", 3)) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            if (!((*color)[channel] >= 0.0)) {
                light.fail("\"color\" holds a number below 0");
            }
            lamp.color[static_cast<glm::length_t>(channel)] = (*color)[channel];
        }
    }
    lamp.intensity = number_from(light, "intensity", 1.0, 0.0);
    lamp.range = light.number("range");
    if (lamp.range && !(*lamp.range > 0.0)) {
        light.fail("\"range\" is not above 0");
    }
    if (lamp.kind == LampKind::directional) {
        lamp.range.reset(); // it has none, whatever a file says
    }
    if (lamp.kind == LampKind::spot) {
        read_cone(light, lamp);
    }
    read_size(light, lamp);
    return lamp;
}

class Lights {
public:
    Lights(const Context& context, const Json& document) : m_context(context) {
        const auto extension = Fields(context, document, "the document").extension(extension_name);
        if (!extension) {
            return;
        }
        const auto lights = extension->json().find("lights");
        if (lights == extension->json().end() || !lights->is_array()) {
            extension->fail("\"lights\" is missing, or not an array");
        }
        m_lights = &*lights;
        for (std::size_t index = 0; index < m_lights->size(); ++index) {
            (void)read(index); // those that no node names are checked too
        }
    }

    [[nodiscard]] std::size_t count() const { return m_lights != nullptr ? m_lights->size() : 0; }
    [[nodiscard]] Lamp read(std::size_t index) const {
        const Json& light = (*m_lights)[index];
        return read_light({m_context, light, describe("light", index, "")});
    }

private:
    const Context& m_context;
    const Json* m_lights = nullptr;
};

std::optional<Lamp> lamp_of(const Fields& node, const Lights& lights) {
    std::optional<Lamp> lamp;
    if (const auto extension = node.extension(extension_name)) {
        lamp = lights.read(extension->required_index("light", lights.count()));
    } else if (const auto own = own_extras(node)) {
        if (const auto baked = own->object("bakedLight")) {
            lamp = read_light(*baked);
        }
    }
    if (lamp) {
        read_size(node, *lamp);
    }
    return lamp;
}

} // namespace

std::map<std::uint32_t, Lamp> read_lamps(const Context& context, const Json& document) {
    std::map<std::uint32_t, Lamp> lamps;
    const Lights lights(context, document);
    const std::size_t nodes = root_array(context, document, "nodes").size();
    for (std::size_t index = 0; index < nodes; ++index) {
        const Fields node = element(context, document, "nodes", "node", index);
        if (std::optional<Lamp> lamp = lamp_of(node, lights)) {
            const std::string name = node.string("name").value_or("");
            if (!name.empty()) {
                lamp->name = name;
            } else if (lamp->name.empty()) {
                lamp->name = "node " + std::to_string(index);
            }
            lamp->source_node = static_cast<std::uint32_t>(index);
            lamps.emplace(lamp->source_node, *lamp);
        }
    }
    return lamps;
}

bool place_lamp(Lamp& lamp, const glm::dmat3& linear, const glm::dvec3& translation) {
    lamp.position = translation;
    if (lamp.kind == LampKind::point) {
        return true;
    }
    // Divided by its greatest part first, so that no square can overflow or vanish.
    const glm::dvec3 along = -linear[2];
    const double greatest = std::max({std::abs(along.x), std::abs(along.y), std::abs(along.z)});
    if (!(greatest > 0.0)) {
        return false;
    }
    lamp.direction = glm::normalize(along / greatest);
    return true;
}

} // namespace vkbake::gltf
