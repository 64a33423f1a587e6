// Charts, share used, stretch and seconds: ours and xatlas's, on the same welded meshes, with the same gutter and the
// same texels per metre, counted by the same counter from the UVs that each gives.
#include <algorithm>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "atlas/make_atlas.hpp"
#include "atlas/measure_uvs.hpp"
#include "bench/atlas/xatlas_contender.hpp"
#include "bench/common/program.hpp"
#include "bench/common/timing.hpp"
#include "surface/make_surface.hpp"
#include "vkbake/vkbake.hpp"

namespace {

using namespace vkbake;
using namespace vkbake::bench;

Unwrapped unwrap_by_us(const Surface& surface, const Settings& settings) {
    const Stopwatch watch;
    const Atlas atlas = make_atlas({}, surface, settings);
    Unwrapped result;
    watch.read(result);
    result.density = atlas.density;
    result.page = atlas.page;
    result.uvs = atlas.uvs;
    for (const AtlasPage& page : atlas.pages) {
        result.page_sizes.emplace_back(page.width, page.height);
        result.pages_area += static_cast<double>(page.width) * page.height;
    }
    return result;
}

/// Prints a line; the seconds are the medians.
void report(const std::string& scene, const std::string& who, const Surface& surface, int repeats,
            const std::function<Unwrapped()>& unwrap) {
    std::vector<double> wall;
    std::vector<double> cpu;
    Unwrapped last;
    for (int repeat = 0; repeat < repeats; ++repeat) {
        last = unwrap();
        wall.push_back(last.wall_seconds);
        cpu.push_back(last.cpu_seconds);
    }
    const UvFigures figures = measure_uvs({surface.positions, last.uvs, last.page, last.page_sizes});
    fmt::print("| {} | {} | {} | {} | {:.3f} | {:.4f} | {:.3f} | {:.3f} | {:.0f} | {:.6g} | {} | {} | {} |\n", scene,
               who, surface.triangle_count(), figures.charts, figures.uv_area / last.pages_area, figures.stretch,
               median(wall), median(cpu), last.pages_area, last.density, figures.overlapping, figures.mirrored,
               figures.unmapped);
    std::fflush(stdout);
}

int run(int argument_count, char** arguments) {
    std::vector<std::filesystem::path> scenes;
    Settings settings{.uv = UvSource::make, .charts = ChartMaker::grown, .gutter = 4};
    int repeats = 3;
    bool ours_alone = false;
    CLI::App app("Our charts and xatlas's, side by side.", "vkbake_bench_atlas");
    app.add_option("scene", scenes, "glTF files")->required();
    app.add_option("--size", settings.size, "the side that xatlas is asked for");
    app.add_option("--gutter", settings.gutter, "empty texels between charts");
    app.add_option("--repeats", repeats, "runs; the median is printed")->check(CLI::Range(1, 100));
    app.add_option("--density", settings.density, "with --ours: texels a metre, on a page as high as is needed");
    app.add_flag_callback(
        "--polypack", [&] { settings.charts = ChartMaker::polypack; }, "the thesis's charts");
    app.add_flag("--ours", ours_alone, "leave xatlas out: pages of --size, filled");
    CLI11_PARSE(app, argument_count, arguments);
    fmt::print("| scene | by | triangles | charts | own share | L2 | wall s | cpu s | texels | a metre | overlapping | "
               "mirrored | unmapped |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const auto& file : scenes) {
        const Scene scene = load_scene(file);
        const Surface surface = make_surface(scene);
        Settings same = settings;
        if (!ours_alone) {
            report(scene.name, "xatlas", surface, repeats, [&] {
                Unwrapped result = unwrap_by_xatlas(surface, settings.size, settings.gutter);
                same.density = result.density;
                return result;
            });
        }
        same.size = same.density ? 0 : same.size; // the least that holds them
        report(scene.name, "vkbake", surface, repeats, [&] { return unwrap_by_us(surface, same); });
    }
    return 0;
}

} // namespace

int main(int argument_count, char** arguments) {
    return run_program("vkbake_bench_atlas", [&] { return run(argument_count, arguments); });
}
