#include "write/manifest.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "vkbake/error.hpp"
#include "vkbake/names.hpp"
#include "vkbake/vkbake.hpp"
#include "write/hash.hpp"

namespace vkbake {
namespace {

constexpr int manifest_version = 1;

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json map_json(const LightMap& map, const WrittenMap& written, Mode mode) {
    Json json{{"name", map.name}, {"file", written.file}};
    json.update(counts_json(map));
    if (!written.error_file.empty()) {
        json["error_file"] = written.error_file;
        json["rays_file"] = written.rays_file;
    }
    if (!written.directional_files.empty()) {
        json["directional_files"] = written.directional_files;
    }
    json["values_out_of_range"] = written.changed_values;
    if (mode == Mode::irradiance) {
        json["intensity"] = written.intensity;
    }
    return json;
}

/// Null where there are none.
Json probes_summary(const Bake& bake) {
    return bake.probes.empty()
               ? Json()
               : Json{{"file", "probes.json"}, {"count", bake.probes.size()}, {"rays", bake.probe_rays}};
}

Json timing_json(const Bake& bake) {
    Json stages = Json::array();
    for (const StageSeconds& stage : bake.stages) {
        stages.push_back({{"stage", stage.stage}, {"seconds", stage.seconds}});
    }
    Json maps = Json::array();
    for (const LightMap& map : bake.light_maps) {
        maps.push_back({{"name", map.name}, {"seconds", map.statistics.seconds}});
    }
    return {{"threads", bake.settings.threads}, {"stages", std::move(stages)}, {"light_maps", std::move(maps)}};
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& what) {
    throw Error(ErrorKind::bad_input, file.string() + ": " + what + "; bake again");
}

std::vector<std::uint8_t> read_bytes(const std::filesystem::path& file) {
    std::error_code ignored; // a path that cannot even be asked about is no regular file
    std::ifstream stream;
    if (std::filesystem::is_regular_file(file, ignored)) {
        stream.open(file, std::ios::binary);
    }
    if (!stream.is_open()) {
        refuse(file, "cannot be read");
    }
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void check_file(const std::filesystem::path& directory, const Json& entry) {
    const std::filesystem::path name = entry.at("file").get<std::string>();
    const std::filesystem::path file = directory / name;
    if (name.empty() || name.is_absolute() || *name.lexically_normal().begin() == "..") {
        refuse(file, "lies outside the manifest's folder");
    }
    if (hash_of(read_bytes(file)) != entry.at("xxh3-128").get<std::string>()) {
        refuse(file, "is not the file that the manifest was written for");
    }
}

} // namespace

Json settings_json(const Settings& settings) {
    return {{"size", settings.size},
            {"density", or_null(settings.density)},
            {"layout", name_of(settings.layout)},
            {"uv", name_of(settings.uv)},
            {"charts", name_of(settings.charts)},
            {"stretch", settings.stretch},
            {"gutter", settings.gutter},
            {"max-pages", settings.max_pages},
            {"mode", name_of(settings.mode)},
            {"ao-distance", or_null(settings.ao_distance)},
            {"ao-falloff", name_of(settings.ao_falloff)},
            {"rays", settings.rays},
            {"bounces", settings.bounces},
            {"bounce-rays", settings.bounce_rays},
            {"probes", settings.probe_grid ? Json(*settings.probe_grid) : Json()},
            {"probe-rays", settings.probe_rays},
            {"directional", name_of(settings.directional)},
            {"directional-rays", settings.directional_rays},
            {"lamps", name_of(settings.lamps)},
            {"sun", name_of(settings.sun)},
            {"alpha", name_of(settings.alpha)},
            {"sampler", name_of(settings.sampler)},
            {"accelerator", name_of(settings.accelerator)},
            {"triangle-test", name_of(settings.triangle_test)},
            {"cluster-splits", settings.cluster_splits},
            {"target-error", or_null(settings.target_error)},
            {"time", or_null(settings.seconds)},
            {"error-map", settings.estimate_error},
            {"seed", settings.seed},
            {"reuse", name_of(reuses_visibility(settings) ? Switch::on : Switch::off)},
            {"denoise", name_of(settings.denoise)},
            {"blend-creases", name_of(settings.blend_creases)},
            {"padding", settings.padding}};
}

Json counts_json(const LightMap& map) {
    const LightMapStatistics& statistics = map.statistics;
    const auto texels = static_cast<double>(map.image.texels.size());
    Json json{{"width", map.image.width},
              {"height", map.image.height},
              {"coverage", texels > 0.0 ? static_cast<double>(statistics.covered_texels) / texels : 0.0},
              {"covered_texels", statistics.covered_texels},
              {"denoised_texels", statistics.denoised_texels},
              {"blended_texels", statistics.blended_texels},
              {"filled_texels", statistics.filled_texels},
              {"rays", statistics.rays},
              {"occluded_rays", statistics.occluded_rays},
              {"filtered_rays", statistics.filtered_rays},
              {"skipped_directions", statistics.skipped_directions},
              {"spared_rays", statistics.spared_rays},
              {"probed_hits", statistics.probed_hits},
              {"back_side_hits", statistics.back_side_hits},
              {"lamp_rays", statistics.lamp_rays},
              {"peak_rays", statistics.peak_rays},
              {"bounce_rays", statistics.bounce_rays},
              {"directional_rays", statistics.directional_rays}};
    if (map.error) {
        json["error"] = {{"relative_rmse", map.error->relative_rmse},
                         {"percentile_99", map.error->percentile_99},
                         {"slope", map.error->slope}};
        if (map.error->noise_rmse > 0.0) {
            json["error"]["noise_rmse"] = map.error->noise_rmse;
        }
        if (map.error->mean_rays > 0.0) {
            json["error"].update({{"target_reached", map.error->target_reached},
                                  {"mean_rays", map.error->mean_rays},
                                  {"best_mean_rays", map.error->best_mean_rays},
                                  {"uniform_rays", map.error->uniform_rays}});
        }
    }
    return json;
}

Json make_manifest(const std::string& scene, const Bake& bake, const std::string& command,
                   std::span<const WrittenMap> maps, std::span<const WrittenFile> files,
                   std::span<const std::string> notes) {
    Json map_list = Json::array();
    for (std::size_t index = 0; index < maps.size(); ++index) {
        map_list.push_back(map_json(bake.light_maps.at(index), maps[index], bake.settings.mode));
    }
    Json file_list = Json::array();
    for (const WrittenFile& file : files) {
        file_list.push_back({{"file", file.file}, {"bytes", file.bytes}, {"xxh3-128", file.hash}});
    }
    return {{"manifest", manifest_version},
            {"vkbake", version()},
            {"command", command},
            {"scene", scene},
            {"sky", bake.sky},
            {"device", bake.device},
            {"settings", settings_json(bake.settings)},
            {"triangles", bake.surface.triangle_count()},
            {"charts", bake.atlas.chart_count},
            {"density", bake.atlas.density},
            {"light_maps", std::move(map_list)},
            {"probes", probes_summary(bake)},
            {"notes", notes},
            {"files", std::move(file_list)},
            {"timing", timing_json(bake)}};
}

Json read_manifest(const std::filesystem::path& directory) {
    const std::filesystem::path path = directory / "manifest.json";
    const std::vector<std::uint8_t> bytes = read_bytes(path);
    try {
        Json manifest = Json::parse(bytes);
        if (manifest.at("manifest") != manifest_version) {
            refuse(path, "is of another version than " + std::to_string(manifest_version));
        }
        for (const Json& entry : manifest.at("files")) {
            check_file(directory, entry);
        }
        return manifest;
    } catch (const Json::exception& error) {
        refuse(path, error.what());
    }
}

void check_bake_of(const std::filesystem::path& directory, const std::string& file) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(directory / "manifest.json", ignored)) {
        return;
    }
    const Json manifest = Json::parse(read_bytes(directory / "manifest.json"), nullptr, false);
    if (!manifest.is_object() || !manifest.contains("vkbake") || !manifest.contains("files")) {
        return; // another program's
    }
    const Json& files = manifest["files"];
    const auto is_ours = [&](const Json& entry) { return entry.is_object() && entry.value("file", Json()) == file; };
    if (files.is_array() && std::any_of(files.begin(), files.end(), is_ours)) {
        (void)read_manifest(directory);
    }
}

} // namespace vkbake
