#include "vkbake/report.hpp"

#include "base/json.hpp"
#include "write/manifest.hpp"

namespace vkbake {
namespace {

Json vector_json(const glm::dvec3& value) { return Json::array({value.x, value.y, value.z}); }

Json map_json(const LightMap& map) {
    Json json{{"name", map.name}};
    json.update(counts_json(map));
    json["seconds"] = map.statistics.seconds;
    return json;
}

Json uv_figures_json(const UvFiguresOfObject& figures) {
    return {{"name", figures.name},
            {"triangles", figures.triangles},
            {"charts", figures.charts},
            {"texels", figures.texels},
            {"stretch", figures.stretch},
            {"overlapping", figures.overlapping},
            {"mirrored", figures.mirrored},
            {"density_min", figures.density_min},
            {"density_median", figures.density_median},
            {"density_max", figures.density_max}};
}

} // namespace

std::string to_json(const UvReport& report) {
    Json json = {{"share", report.share}, {"all", uv_figures_json(report.all)}, {"notes", report.atlas.notes}};
    json["objects"] = Json::array();
    for (const UvFiguresOfObject& object : report.objects) {
        json["objects"].push_back(uv_figures_json(object));
    }
    json["pages"] = Json::array();
    for (const AtlasPage& page : report.atlas.pages) {
        json["pages"].push_back({{"name", page.name}, {"width", page.width}, {"height", page.height}});
    }
    return json.dump(2);
}

std::string to_json(const Inspection& inspection) {
    Json plan = Json::array();
    for (const PlanEntry& entry : inspection.plan) {
        plan.push_back({{"phenomenon", entry.phenomenon}, {"modelled", entry.modelled}, {"reason", entry.reason}});
    }
    const Json json = {{"meshes", inspection.meshes},
                       {"instances", inspection.instances},
                       {"materials", inspection.materials},
                       {"images", inspection.images},
                       {"cameras", inspection.cameras},
                       {"lamps", inspection.lamps},
                       {"triangles", inspection.triangles},
                       {"area", inspection.area},
                       {"box_low", vector_json(inspection.box_low)},
                       {"box_high", vector_json(inspection.box_high)},
                       {"instances_with_uvs", inspection.instances_with_uvs},
                       {"light_maps", inspection.light_maps},
                       {"charts", inspection.charts},
                       {"pages", inspection.pages},
                       {"density", inspection.density},
                       {"covered_texels", inspection.covered_texels},
                       {"rays", inspection.rays},
                       {"trace_seconds", inspection.trace_seconds},
                       {"error", inspection.error ? Json(*inspection.error) : Json()},
                       {"memory", inspection.memory},
                       {"memory_limit", inspection.memory_limit},
                       {"plan", plan},
                       {"notes", inspection.notes}};
    return json.dump(2);
}

std::string to_json(const Comparison& comparison) {
    const Json json = {{"covered_a", comparison.covered_a},
                       {"covered_b", comparison.covered_b},
                       {"covered_both", comparison.covered_both},
                       {"not_finite", comparison.not_finite},
                       {"root_mean_square", comparison.root_mean_square},
                       {"relative_root_mean_square", comparison.relative_root_mean_square},
                       {"relative_luminance_rmse", comparison.relative_luminance_rmse},
                       {"mean_a", comparison.mean_a},
                       {"mean_b", comparison.mean_b},
                       {"maximum", comparison.maximum},
                       {"maximum_x", comparison.maximum_x},
                       {"maximum_y", comparison.maximum_y}};
    return json.dump(2);
}

std::string to_json(const std::vector<DeviceReport>& devices) {
    Json list = Json::array();
    for (const DeviceReport& device : devices) {
        list.push_back({{"name", device.name},
                        {"driver", device.driver},
                        {"type", device.type},
                        {"usable", device.usable},
                        {"deterministic", device.deterministic},
                        {"refusals", device.refusals}});
    }
    return Json{{"devices", list}}.dump(2);
}

std::string to_json(const Bake& bake) {
    Json maps = Json::array();
    for (const LightMap& map : bake.light_maps) {
        maps.push_back(map_json(map));
    }
    Json stages = Json::object();
    for (const StageSeconds& stage : bake.stages) {
        stages[stage.stage] = stage.seconds;
    }
    const Json json = {{"device", bake.device},
                       {"sky", bake.sky},
                       {"triangles", bake.surface.triangle_count()},
                       {"charts", bake.atlas.chart_count},
                       {"density", bake.atlas.density},
                       {"light_maps", maps},
                       {"probes", bake.probes.size()},
                       {"probe_rays", bake.probe_rays},
                       {"stage_seconds", stages},
                       {"notes", bake.notes}};
    return json.dump(2);
}

} // namespace vkbake
