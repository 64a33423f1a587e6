#include "bake_options.hpp"
#include "command.hpp"
#include "interrupt.hpp"
#include "progress_line.hpp"
#include "text.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <future>
#include <memory>

#include <fmt/format.h>

#include "vkbake/report.hpp"
#include "vkbake/vkbake.hpp"

namespace vkbake::cli {
namespace {

struct BakeOptions {
    std::string scene;
    std::string output;
    std::string device;
    std::string format = "exr";
    LoadSettings load;
    SkyOptions sky;
    Settings settings;
    bool json = false;
    bool quiet = false;
    std::string command; ///< as it was typed, for the manifest
};

constexpr std::array<std::pair<const char*, LightMapFormat>, 3> formats{
    {{"exr", LightMapFormat::exr}, {"hdr", LightMapFormat::hdr}, {"png", LightMapFormat::png}}};

LightMapFormat format_named(const std::string& name) {
    for (const auto& [candidate, format] : formats) {
        if (name == candidate) {
            return format;
        }
    }
    throw Error(ErrorKind::usage, "--format: \"" + name + "\" is not one of exr, hdr, png");
}

void print_error(const MapError& error) {
    fmt::print("  {:<24} error {:.2g} %, of the worst texel in a hundred {:.2g} % (estimates)\n", "",
               100.0 * error.relative_rmse, 100.0 * error.percentile_99);
    if (error.noise_rmse > 0.0) {
        fmt::print("  {:<24} {:.2g} % before it was denoised\n", "", 100.0 * error.noise_rmse);
    }
    if (error.mean_rays > 0.0) {
        fmt::print("  {:<24} {:.0f} rays a texel of direct light; the same for every texel, it would take {:.0f}\n", "",
                   error.mean_rays, error.uniform_rays);
    }
    if (!error.target_reached) {
        fmt::print("  {:<24} note: the error asked for was not reached\n", "");
    }
}

void print_maps(const Bake& bake) {
    for (const LightMap& map : bake.light_maps) {
        const LightMapStatistics& statistics = map.statistics;
        const auto texels = static_cast<double>(map.image.texels.size());
        fmt::print("  {:<24} {}x{}  {:5.1f} % covered  {} rays, {:.0f} % occluded\n", map.name, map.image.width,
                   map.image.height, 100.0 * static_cast<double>(statistics.covered_texels) / texels,
                   count_text(static_cast<double>(statistics.rays)),
                   statistics.rays == 0
                       ? 0.0
                       : 100.0 * static_cast<double>(statistics.occluded_rays) / static_cast<double>(statistics.rays));
        if (const std::uint64_t sought = statistics.lamp_rays + statistics.peak_rays; sought > 0) {
            fmt::print("  {:<24} {} rays more to {}{}{}\n", "", count_text(static_cast<double>(sought)),
                       statistics.peak_rays > 0 ? "the sky's brightest places" : "",
                       statistics.peak_rays > 0 && statistics.lamp_rays > 0 ? " and " : "",
                       statistics.lamp_rays > 0 ? "lamps" : "");
        }
        if (statistics.bounce_rays > 0) {
            fmt::print("  {:<24} {} rays of bounces\n", "", count_text(static_cast<double>(statistics.bounce_rays)));
        }
        if (statistics.directional_rays > 0) {
            fmt::print("  {:<24} {} rays for where it comes from\n", "",
                       count_text(static_cast<double>(statistics.directional_rays)));
        }
        if (map.error) {
            print_error(*map.error);
        }
        if (2 * statistics.back_side_hits > statistics.probed_hits && statistics.probed_hits > 0) {
            fmt::print("  {:<24} note: {:.0f} % of its hits are on back sides: does it lie inside something, or are "
                       "faces turned the wrong way?\n",
                       "",
                       100.0 * static_cast<double>(statistics.back_side_hits) /
                           static_cast<double>(statistics.probed_hits));
        }
    }
}

void print_summary(const Bake& bake, const std::vector<std::filesystem::path>& files, const BakeOptions& options,
                   double seconds) {
    fmt::print("baked {} in {} on {}\n", plural(bake.surface.triangle_count(), "triangle", "triangles"),
               duration_text(seconds), bake.device);
    std::string density;
    if (bake.atlas.density > 0.0) {
        density = fmt::format(", {:.4g} texels a metre", bake.atlas.density);
    }
    fmt::print("  {} in {}{}\n", plural(bake.atlas.chart_count, "chart", "charts"),
               plural(bake.light_maps.size(), "map", "maps"), density);
    print_maps(bake);
    if (!bake.probes.empty()) {
        fmt::print("  {:<24} {} rays\n", plural(bake.probes.size(), "light probe", "light probes"),
                   count_text(static_cast<double>(bake.probe_rays)));
    }
    std::string stages;
    for (const StageSeconds& stage : bake.stages) {
        stages += fmt::format("{}{} {}", stages.empty() ? "" : " | ", stage.stage, duration_text(stage.seconds));
    }
    fmt::print("  {}\n", stages);
    for (const std::string& note : bake.notes) {
        fmt::print("  note: {}\n", note);
    }
    for (const std::filesystem::path& file : files) {
        fmt::print("  {}\n", (std::filesystem::path(options.output) / file).string());
    }
}

constexpr double least_seconds = 0.01;

/// About what encoding a map and writing it take.
double writing_seconds(const Settings& settings) {
    constexpr double a_texel = 6e-7;
    return a_texel * settings.size * settings.size;
}

/// Loads the image codec, where the format needs it, while rays are traced, which takes other cores and no lock;
/// drivers, in the stages before, wait for the dynamic linker. A bake that could write nothing ends as soon as that is
/// known.
class CodecAhead {
public:
    explicit CodecAhead(LightMapFormat format) : m_needed(format == LightMapFormat::hdr) {}

    void poll(const ProgressReport& report) {
        if (m_needed && report.stage == "trace") {
            m_needed = false;
            m_loading = std::async(std::launch::async, load_image_codec);
        }
        if (m_loading.valid() && m_loading.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
            m_loading.get();
        }
    }

private:
    bool m_needed;
    std::future<void> m_loading;
};

int run_bake(BakeOptions options) {
    const auto start = std::chrono::steady_clock::now();
    const LightMapFormat format = format_named(options.format);
    if (options.output.empty()) {
        options.output = std::filesystem::path(options.scene).stem().string() + "-baked";
    }
    const Scene scene = load_scene(options.scene, options.load);
    const Sky sky = options.sky.load();
    const Device device = open_device({.name = options.device});
    Settings settings = options.settings;
    if (settings.seconds) {
        const double loading = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        settings.seconds = std::max(*settings.seconds - loading - writing_seconds(settings), least_seconds);
    }
    Bake result;
    std::vector<std::filesystem::path> files;
    {
        ProgressLine line(options.quiet);
        CodecAhead codec(format);
        result = bake(scene, sky, settings, device, [&](const ProgressReport& report) {
            codec.poll(report);
            return line.update(report);
        });
        result.settings.seconds = options.settings.seconds;
        stop_on_interrupt();
        files = write_bake(scene, result, {.directory = options.output, .format = format, .command = options.command},
                           [&line](const ProgressReport& report) { return line.update(report); });
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (options.json) {
        fmt::print("{}\n", to_json(result));
    } else if (!options.quiet) {
        print_summary(result, files, options, seconds);
    }
    return exit_done;
}

} // namespace

void add_bake_command(CLI::App& app, Invocation& invocation) {
    const auto options = std::make_shared<BakeOptions>();
    CLI::App& command = *app.add_subcommand("bake", "Bake a scene's light maps");
    command.add_option("scene", options->scene, "The scene, .gltf or .glb")->required()->type_name("SCENE");
    command.add_option("-o,--output", options->output, "Folder for the results; without it, SCENE-baked here")
        ->type_name("DIR");
    add_load_options(command, options->load);
    add_sky_options(command, options->sky);
    add_atlas_options(command, options->settings);
    add_light_options(command, options->settings);
    command.add_option("--format", options->format, "Of the light maps: exr, hdr or png (16 bits)")
        ->check(CLI::IsMember({"exr", "hdr", "png"}))
        ->type_name("exr|hdr|png")
        ->capture_default_str();
    command.add_option("--device", options->device, "Part of the Vulkan device's name; see vkbake devices")
        ->type_name("NAME");
    command.add_flag("--json", options->json, "Print the result as JSON");
    command.add_flag("--quiet", options->quiet, "Print errors only");
    command.final_callback([options, &invocation] {
        options->command = invocation.text;
        invocation.run = [options] { return run_bake(*options); };
    });
}

} // namespace vkbake::cli
