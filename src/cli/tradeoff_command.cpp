#include "bake_options.hpp"
#include "command.hpp"
#include "draw_svg.hpp"
#include "progress_line.hpp"
#include "text.hpp"
#include "tradeoff_page.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>

#include <fmt/format.h>

#include "vkbake/vkbake.hpp"

namespace vkbake::cli {
namespace {

struct TradeoffOptions {
    std::string scene;
    std::string output;
    std::string device;
    LoadSettings load;
    SkyOptions sky;
    Settings settings;
};

constexpr double reference_error = 0.0005; ///< a tenth of the smallest that is asked for
constexpr double recommended_error = 0.01;

/// What is tried: rays for all alike, errors asked for, both with the denoiser, an error with all samples traced, and
/// the thesis's sampler.
std::vector<std::pair<std::string, Settings>> sweep(const Settings& given) {
    std::vector<std::pair<std::string, Settings>> points;
    for (const std::uint32_t rays : {16U, 64U, 256U, 1024U}) {
        points.emplace_back(fmt::format("--rays {}", rays), given);
        points.back().second.rays = rays;
    }
    for (const double error : {0.05, 0.02, 0.01, 0.005}) {
        points.emplace_back(fmt::format("--target-error {}", error), given);
        points.back().second.target_error = error;
    }
    for (const std::size_t coarse : {0U, 1U, 4U, 5U, 6U}) {
        auto point = points[coarse];
        point.first += " --denoise on";
        point.second.denoise = Switch::on;
        points.push_back(std::move(point));
    }
    points.emplace_back(fmt::format("--target-error {} --reuse off", recommended_error), given);
    points.back().second.target_error = recommended_error;
    points.back().second.reuse = Switch::off;
    points.emplace_back("--sampler thesis", given);
    points.back().second.sampler = Sampler::thesis;
    return points;
}

TradePoint measured(const std::string& flags, const Bake& bake, const Bake& reference) {
    TradePoint point{.flags = flags,
                     .adaptive = bake.settings.target_error.has_value(),
                     .denoised = bake.settings.denoise == Switch::on,
                     .error = compare_bakes(bake, reference)};
    double samples = 0.0;
    double texels = 0.0;
    for (const LightMap& map : bake.light_maps) {
        samples += static_cast<double>(map.statistics.rays + map.statistics.skipped_directions);
        texels += static_cast<double>(map.statistics.covered_texels);
        point.seconds += map.statistics.seconds;
    }
    for (const StageSeconds& stage : bake.stages) {
        point.seconds += stage.stage == "denoise" ? stage.seconds : 0.0;
    }
    point.rays_a_texel = samples / texels;
    return point;
}

/// Draws bakes of a scene, each from files in a folder of its own, which goes with this.
class Pictures {
public:
    Pictures(const Scene& scene, const Sky& sky, const Device& device, const std::filesystem::path& folder)
        : m_scene(&scene), m_sky(&sky), m_device(&device), m_folder(folder / "pictures.partial") {}
    ~Pictures() {
        std::error_code ignored;
        std::filesystem::remove_all(m_folder, ignored);
    }
    Pictures(const Pictures&) = delete;
    Pictures& operator=(const Pictures&) = delete;

    /// In no other light than the maps'.
    [[nodiscard]] Image draw(const Bake& bake) const {
        (void)write_bake(*m_scene, bake, {.directory = m_folder});
        const Scene baked = load_scene(m_folder / (m_scene->name + ".glb"));
        return render(baked, *m_sky, {.width = 640, .height = 360, .show_sky = false}, *m_device);
    }

private:
    const Scene* m_scene;   ///< never null
    const Sky* m_sky;       ///< never null
    const Device* m_device; ///< never null
    std::filesystem::path m_folder;
};

/// The points that no other beats in both time and error.
void mark_frontier(std::vector<TradePoint>& points) {
    for (TradePoint& point : points) {
        point.on_frontier = std::none_of(points.begin(), points.end(), [&](const TradePoint& other) {
            return other.seconds < point.seconds && other.error.relative_rmse < point.error.relative_rmse;
        });
    }
}

/// The fastest whose error is that of a picture without visible noise, or else the best.
std::size_t recommended(const std::vector<TradePoint>& points) {
    const auto worse = [](const TradePoint& a, const TradePoint& b) {
        const bool good_a = a.error.relative_rmse <= 1.1 * recommended_error;
        const bool good_b = b.error.relative_rmse <= 1.1 * recommended_error;
        if (good_a != good_b) {
            return good_a;
        }
        return good_a ? a.seconds < b.seconds : a.error.relative_rmse < b.error.relative_rmse;
    };
    return static_cast<std::size_t>(std::min_element(points.begin(), points.end(), worse) - points.begin());
}

void write_text(const std::filesystem::path& file, const std::string& text) {
    std::filesystem::path unfinished = file;
    unfinished += ".part";
    std::ofstream stream(unfinished, std::ios::binary);
    stream << text;
    stream.close();
    std::error_code failed;
    if (stream) {
        std::filesystem::rename(unfinished, file, failed);
    }
    if (!stream || failed) {
        std::filesystem::remove(unfinished, failed);
        throw Error(ErrorKind::output, file.string() + ": cannot be written; choose another folder with -o");
    }
}

int run_tradeoff(TradeoffOptions options) {
    if (options.output.empty()) {
        options.output = std::filesystem::path(options.scene).stem().string() + "-tradeoff";
    }
    const Scene scene = load_scene(options.scene, options.load);
    const Sky sky = options.sky.load();
    const Device device = open_device({.name = options.device});
    ProgressLine line(false);
    const auto progress = [&line](const ProgressReport& report) { return line.update(report); };
    Settings settings = options.settings;
    settings.seed = options.settings.seed + 1;
    settings.target_error = reference_error;
    settings.reuse = Switch::off;
    const Bake reference = bake(scene, sky, settings, device, progress);
    Trade trade{.scene = scene.name, .sky = sky.name, .size = options.settings.size};
    const DetailPlace place = choose_detail(reference);
    const std::filesystem::path folder = options.output;
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    const Pictures pictures(scene, sky, device, folder);
    const Image reference_drawn = pictures.draw(reference);
    for (const auto& [flags, tried] : sweep(options.settings)) {
        const Bake result = bake(scene, sky, tried, device, progress);
        trade.points.push_back(measured(flags, result, reference));
        trade.points.back().picture = detail_picture(result, reference, place);
        trade.points.back().color_difference = color_difference(pictures.draw(result), reference_drawn);
    }
    trade.reference_picture = detail_picture(reference, reference, place);
    mark_frontier(trade.points);
    trade.recommended = recommended(trade.points);
    write_text(folder / "tradeoff.json", trade_json(trade));
    const std::string plot = trade_plot(trade, PlotGround::white);
    write_text(folder / "tradeoff.svg", plot);
    write_image(folder / "tradeoff.png", draw_svg(plot, 2 * plot_width, 2 * plot_height));
    write_text(folder / "tradeoff.html", trade_page(trade));
    fmt::print("{}", trade_table(trade));
    fmt::print("recommended: {}\n", trade.points[trade.recommended].flags);
    for (const char* file : {"tradeoff.html", "tradeoff.svg", "tradeoff.png", "tradeoff.json"}) {
        fmt::print("  {}\n", (folder / file).string());
    }
    return exit_done;
}

} // namespace

void add_tradeoff_command(CLI::App& app, Invocation& invocation) {
    const auto options = std::make_shared<TradeoffOptions>();
    options->settings.size = 256;
    CLI::App& command =
        *app.add_subcommand("tradeoff", "Measure what error costs what time on a scene: table and plot");
    command.add_option("scene", options->scene, "The scene, .gltf or .glb")->required()->type_name("SCENE");
    command.add_option("-o,--output", options->output, "Folder for the results; without it, SCENE-tradeoff here")
        ->type_name("DIR");
    add_load_options(command, options->load);
    add_sky_options(command, options->sky);
    add_atlas_options(command, options->settings);
    command.add_option("--device", options->device, "Part of the Vulkan device's name; see vkbake devices")
        ->type_name("NAME");
    command.final_callback([options, &invocation] { invocation.run = [options] { return run_tradeoff(*options); }; });
}

} // namespace vkbake::cli
