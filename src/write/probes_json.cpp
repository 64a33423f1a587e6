#include "write/probes_json.hpp"

#include "base/json.hpp"

namespace vkbake {
namespace {

constexpr int probes_version = 1;

Json of_vector(const glm::dvec3& value) { return Json::array({value.x, value.y, value.z}); }

Json probe_json(const LightProbe& probe) {
    Json coefficients = Json::array();
    for (const glm::vec3& coefficient : probe.coefficients) {
        coefficients.push_back(of_vector(coefficient));
    }
    Json json = Json::object();
    if (!probe.name.empty()) {
        json["name"] = probe.name;
    }
    json["position"] = of_vector(probe.position);
    json["back_sides"] = probe.back_sides;
    json["coefficients"] = std::move(coefficients);
    return json;
}

} // namespace

std::string probes_text(const Bake& bake) {
    Json json{{"probes_version", probes_version},
              {"basis", "real orthonormal spherical harmonics of radiance, world axes: 0.282095, 0.488603 y z x, "
                        "1.092548 xy, 1.092548 yz, 0.315392 (3zz - 1), 1.092548 xz, 0.546274 (xx - yy)"}};
    if (bake.probe_grid) {
        const ProbeGrid& grid = *bake.probe_grid;
        json["grid"] = {{"first_probe", grid.first_probe},
                        {"counts", grid.counts},
                        {"first", of_vector(grid.first)},
                        {"step", of_vector(grid.step)}};
    }
    std::string text = json.dump(1);
    text.resize(text.rfind("\n}"));
    text += ",\n \"probes\": [";
    for (std::size_t i = 0; i < bake.probes.size(); ++i) {
        text += (i == 0 ? "\n  " : ",\n  ") + probe_json(bake.probes[i]).dump();
    }
    return text + "\n ]\n}\n";
}

} // namespace vkbake
