#include "bake_options.hpp"
#include "command.hpp"
#include "text.hpp"

#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "vkbake/report.hpp"
#include "vkbake/vkbake.hpp"

namespace vkbake::cli {
namespace {

struct InspectOptions {
    std::string scene;
    LoadSettings load;
    SkyOptions sky;
    Settings settings;
    bool json = false;
    bool uvs = false;
    std::string uv_picture;
};

void print_inspection(const Inspection& inspection, const Settings& settings) {
    const glm::dvec3 size = inspection.box_high - inspection.box_low;
    fmt::print("scene\n");
    fmt::print("  {}, {}, {}, {}, {}, {}\n", plural(inspection.meshes, "mesh", "meshes"),
               plural(inspection.instances, "instance", "instances"),
               plural(inspection.materials, "material", "materials"), plural(inspection.images, "image", "images"),
               plural(inspection.cameras, "camera", "cameras"), plural(inspection.lamps, "lamp", "lamps"));
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
    // How much a filter spares is known when it has filtered.
    const std::string most = settings.target_error && settings.denoise == Switch::on ? "at most " : "";
    fmt::print("\n  about {} texels, {}{} rays; at most {} of memory{}\n",
               count_text(static_cast<double>(inspection.covered_texels)), most,
               count_text(static_cast<double>(inspection.rays)), bytes_text(inspection.memory),
               inspection.memory > inspection.memory_limit
                   ? ", which is more than the limit of " + bytes_text(inspection.memory_limit)
                   : std::string());
    if (inspection.trace_seconds > 0.0) {
        fmt::print("  direct light: {}about {} of tracing here", most, duration_text(inspection.trace_seconds));
        fmt::print("{}\n", inspection.error ? fmt::format(", error about {:.2g} %", 100.0 * *inspection.error) : "");
    }
    fmt::print("light\n");
    for (const PlanEntry& entry : inspection.plan) {
        fmt::print("  {:<16} {:<4} {}\n", entry.phenomenon, entry.modelled ? "on" : "off", entry.reason);
    }
    for (const std::string& note : inspection.notes) {
        fmt::print("  note: {}\n", note);
    }
}

void print_uv_figures(const UvFiguresOfObject& figures, const std::string& name) {
    fmt::print("  {:<24.24}  {:>9}  {:>7}  {:>7.4f}  {:>11}  {:>8}  {:>8.4g} {:>8.4g} {:>8.4g}\n", name,
               figures.triangles, figures.charts, figures.stretch, figures.overlapping, figures.mirrored,
               figures.density_min, figures.density_median, figures.density_max);
}

void print_uvs(const UvReport& report) {
    fmt::print("light-map UVs: {:.1f} % of {} covered\n", 100.0 * report.share,
               plural(report.atlas.pages.size(), "page", "pages"));
    for (std::size_t page = 0; page < report.atlas.pages.size(); ++page) {
        const AtlasPage& of = report.atlas.pages[page];
        fmt::print("  {}: {} x {} texels\n", of.name, of.width, of.height);
    }
    fmt::print("  {:<24}  {:>9}  {:>7}  {:>7}  {:>11}  {:>8}  texels/m {:>8} {:>8}\n", "object", "triangles", "charts",
               "stretch", "overlapping", "mirrored", "median", "max");
    for (const UvFiguresOfObject& object : report.objects) {
        print_uv_figures(object, object.name);
    }
    print_uv_figures(report.all, "all");
    for (const std::string& note : report.atlas.notes) {
        fmt::print("  note: {}\n", note);
    }
}

/// One file a page: NAME.png, or NAME-0.png, NAME-1.png …
void write_uv_pictures(const UvReport& report, const std::filesystem::path& file) {
    for (std::uint32_t page = 0; page < report.atlas.pages.size(); ++page) {
        std::filesystem::path own = file;
        if (report.atlas.pages.size() > 1) {
            own.replace_filename(fmt::format("{}-{}{}", file.stem().string(), page, file.extension().string()));
        }
        write_image(own, draw_uvs(report.atlas, page));
        fmt::print("{}\n", own.string());
    }
}

int run_inspect(const InspectOptions& options) {
    const Scene scene = load_scene(options.scene, options.load);
    if (options.uvs || !options.uv_picture.empty()) {
        const UvReport report = inspect_uvs(scene, options.settings);
        if (options.uvs && options.json) {
            fmt::print("{}\n", to_json(report));
        } else if (options.uvs) {
            print_uvs(report);
        }
        if (!options.uv_picture.empty()) {
            write_uv_pictures(report, options.uv_picture);
        }
        return exit_done;
    }
    const Inspection inspection = inspect(scene, options.settings, options.sky.load());
    if (options.json) {
        fmt::print("{}\n", to_json(inspection));
    } else {
        print_inspection(inspection, options.settings);
    }
    return exit_done;
}

} // namespace

void add_inspect_command(CLI::App& app, Invocation& invocation) {
    const auto options = std::make_shared<InspectOptions>();
    CLI::App& command = *app.add_subcommand("inspect", "Say what a scene has and what a bake of it would make");
    command.add_option("scene", options->scene, "The scene, .gltf or .glb")->required()->type_name("SCENE");
    add_load_options(command, options->load);
    add_sky_options(command, options->sky);
    add_atlas_options(command, options->settings);
    add_light_options(command, options->settings);
    command.add_flag("--uv-table", options->uvs,
                     "Say what the light-map UVs are worth: charts, stretch, overlaps, density");
    command.add_option("--uv-picture", options->uv_picture, "Draw the charts, a pixel a texel, one file a page")
        ->type_name("FILE");
    command.add_flag("--json", options->json, "Print it as JSON");
    command.final_callback([options, &invocation] { invocation.run = [options] { return run_inspect(*options); }; });
}

} // namespace vkbake::cli
