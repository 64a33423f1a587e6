// What the denoiser is worth: the error of denoised bakes beside that of plain ones which take the same time, and
// beside what the denoised ones tell of themselves.
//   vkbake_denoised SIZE 'SKY[;SKY…]' SCENE…
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "accuracy/measure.hpp"
#include "base/luminance.hpp"

namespace {

using namespace vkbake;
using namespace vkbake::accuracy;

constexpr double reference_error = 0.004; // which compare_bakes takes off again
constexpr std::array<double, 3> targets{0.05, 0.02, 0.01};

double denoise_seconds(const Bake& bake) {
    const auto stage = std::ranges::find(bake.stages, "denoise", &StageSeconds::stage);
    return stage == bake.stages.end() ? 0.0 : stage->seconds;
}

/// Over all maps, as they tell it.
double told_error(const Bake& bake) {
    double squares = 0.0;
    double light = 0.0;
    double texels = 0.0;
    for (const LightMap& map : bake.light_maps) {
        const auto covered = static_cast<double>(map.statistics.covered_texels);
        double mean = 0.0;
        for (std::size_t texel = 0; texel < map.image.texels.size(); ++texel) {
            if (map.image.coverage[texel] > 0.5F) {
                mean += luminance(glm::dvec3(map.image.texels[texel])) / covered;
            }
        }
        squares += covered * std::pow(map.error->relative_rmse * mean, 2.0);
        light += covered * mean;
        texels += covered;
    }
    return std::sqrt(squares * texels) / light;
}

/// Rays a texel and the error that they leave.
using Point = std::pair<double, double>;

/// The error of plain bakes with so many rays a texel: on straight lines between logarithms.
double error_with(const std::vector<Point>& plain, double rays) {
    const std::size_t second = rays > plain[1].first ? 2 : 1;
    const auto& [from_rays, from_error] = plain[second - 1];
    const auto& [to_rays, to_error] = plain[second];
    return from_error * std::pow(rays / from_rays, std::log(to_error / from_error) / std::log(to_rays / from_rays));
}

void measure(const std::string& file, const std::string& sky_name, int size, const Device& device) {
    const Scene scene = load_scene(file);
    const Sky sky = load_sky(sky_name);
    Settings settings;
    settings.size = size;
    settings.seed = 1000;
    settings.target_error = reference_error;
    settings.reuse = Switch::off;
    const Bake reference = bake(scene, sky, settings, device);
    settings.seed = 0;
    settings.reuse.reset();
    std::vector<Point> plain;
    for (const double target : targets) {
        settings.target_error = target;
        const Bake result = bake(scene, sky, settings, device);
        plain.emplace_back(mean_rays(result), compare_bakes(result, reference).relative_rmse);
    }
    settings.denoise = Switch::on;
    for (std::size_t i = 0; i + 1 < targets.size(); ++i) {
        settings.target_error = targets[i];
        const Bake result = bake(scene, sky, settings, device);
        const BakeError error = compare_bakes(result, reference);
        // What denoising took in rays: within one bake the clock compares what goes on under one load.
        const double rays_in_time = mean_rays(result) * (1.0 + denoise_seconds(result) / trace_seconds(result));
        double texels = 0.0;
        for (const LightMap& map : result.light_maps) {
            texels += static_cast<double>(map.statistics.covered_texels);
        }
        fmt::print("| {}, {} | {:.1f} | {:g} % | {:.2f} % | {:.2f} | {:.2f} | {:.0f}, {:.0f} | {:+.3f} % | {:.2f} s + "
                   "{:.2f} s |\n",
                   std::filesystem::path(file).stem().string(), std::filesystem::path(sky_name).stem().string(),
                   texels / result.atlas.chart_count, 100.0 * targets[i], 100.0 * error.relative_rmse,
                   told_error(result) / error.relative_rmse, error.relative_rmse / error_with(plain, rays_in_time),
                   mean_rays(result), plain[i].first, 100.0 * error.bias, trace_seconds(result),
                   denoise_seconds(result));
        std::fflush(stdout);
    }
}

} // namespace

int main(int argument_count, char** arguments) {
    if (argument_count < 4) {
        fmt::print(stderr, "usage: vkbake_denoised SIZE 'SKY[;SKY...]' SCENE...\n");
        return EXIT_FAILURE;
    }
    try {
        const Device device = open_device();
        fmt::print("| scene, sky | texels a chart | asked | true | told / true | true / plain of the same time | rays: "
                   "denoised, plain | bias | tracing + denoising |\n|---|---|---|---|---|---|---|---|---|\n");
        for (int scene = 3; scene < argument_count; ++scene) {
            std::istringstream skies(arguments[2]);
            for (std::string sky; std::getline(skies, sky, ';');) {
                measure(arguments[scene], sky, std::atoi(arguments[1]), device);
            }
        }
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
