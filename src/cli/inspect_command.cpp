#include "bake_options.hpp"
#include "command.hpp"
#include "text.hpp"

#include <memory>

#include <fmt/format.h>

#include "vkbake/report.hpp"
#include "vkbake/vkbake.hpp"

namespace vkbake::cli {
namespace {

struct InspectOptions {
    std::string scene;
    LoadSettings load;
    Settings settings;
    bool json = false;
};

void print_inspection(const Inspection& inspection, const Settings& settings) {
    const glm::dvec3 size = inspection.box_high - inspection.box_low;
    fmt::print("scene\n");
    fmt::print("  {}, {}, {}, {}, {}\n", plural(inspection.meshes, "mesh", "meshes"),
               plural(inspection.instances, "instance", "instances"),
               plural(inspection.materials, "material", "materials"), plural(inspection.images, "image", "images"),
               plural(inspection.cameras, "camera", "cameras"));
    fmt::print("  {}, {:.6g} m2, {:.5g} x {:.5g} x {:.5g} m around ({:.5g}, {:.5g}, {:.5g})\n",
               plural(inspection.triangles, "triangle", "triangles"), inspection.area, size.x, size.y, size.z,
               0.5 * (inspection.box_low.x + inspection.box_high.x),
               0.5 * (inspection.box_low.y + inspection.box_high.y),
               0.5 * (inspection.box_low.z + inspection.box_high.z));
    fmt::print("  TEXCOORD_1 on {} of {}\n", inspection.instances_with_uvs,
               plural(inspection.instances, "instance", "instances"));
    for (const std::string& light_map : inspection.light_maps) {
        fmt::print("  light map: {}\n", light_map.empty() ? "embedded only" : light_map);
    }
    fmt::print("a bake with these settings\n");
    fmt::print("  {} in {} of {} texels a side", plural(inspection.charts, "chart", "charts"),
               plural(inspection.pages, "map", "maps"), settings.size);
    if (inspection.density > 0.0) {
        fmt::print(", {:.4g} texels a metre", inspection.density);
    }
    fmt::print("\n  about {} texels, {} rays; at most {} of memory{}\n",
               count_text(static_cast<double>(inspection.covered_texels)),
               count_text(static_cast<double>(inspection.rays)), bytes_text(inspection.memory),
               inspection.memory > inspection.memory_limit
                   ? ", which is more than the limit of " + bytes_text(inspection.memory_limit)
                   : std::string());
    fmt::print("light\n");
    for (const PlanEntry& entry : inspection.plan) {
        fmt::print("  {:<16} {:<4} {}\n", entry.phenomenon, entry.modelled ? "on" : "off", entry.reason);
    }
    for (const std::string& note : inspection.notes) {
        fmt::print("  note: {}\n", note);
    }
}

} // namespace

void add_inspect_command(CLI::App& app, Invocation& invocation) {
    const auto options = std::make_shared<InspectOptions>();
    CLI::App& command = *app.add_subcommand("inspect", "Say what a scene has and what a bake of it would make");
    command.add_option("scene", options->scene, "The scene, .gltf or .glb")->required()->type_name("SCENE");
    add_load_options(command, options->load);
    add_atlas_options(command, options->settings);
    add_light_options(command, options->settings);
    command.add_flag("--json", options->json, "Print it as JSON");
    command.final_callback([options, &invocation] {
        invocation.run = [options] {
            const Inspection inspection = inspect(load_scene(options->scene, options->load), options->settings);
            if (options->json) {
                fmt::print("{}\n", to_json(inspection));
            } else {
                print_inspection(inspection, options->settings);
            }
            return exit_done;
        };
    });
}

} // namespace vkbake::cli
