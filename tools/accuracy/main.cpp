// What `--target-error` promises, measured: the error that a bake really has, and the rays it took, beside those of
// bakes in which all texels have the same number.
//   vkbake_accuracy SIZE 'SKY[;SKY…]' SCENE…
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "accuracy/measure.hpp"

namespace {

using namespace vkbake;
using namespace vkbake::accuracy;

constexpr std::array<double, 3> targets{0.02, 0.01, 0.005};
constexpr double reference_error = 0.002;
constexpr std::uint32_t most_uniform_rays = 4096;

/// Over all cases: the geometric mean of rays against uniform rays.
struct Total {
    double sum_of_logs = 0.0;
    double worst = 0.0;
    int cases = 0;
};

std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(';', begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

/// One map of a bake by itself: what is asked for is asked of each.
Bake page_of(const Bake& bake, std::size_t page) {
    Bake one;
    one.light_maps.push_back(bake.light_maps.at(page));
    return one;
}

struct Case {
    std::string name;
    std::vector<std::pair<std::uint32_t, Bake>> uniform; ///< by rays a texel
    std::vector<std::pair<double, Bake>> asked;          ///< by error
    Bake reference;
};

Case bake_all(const std::string& file, const std::string& sky_name, int size, const Device& device) {
    const Scene scene = load_scene(file);
    const Sky sky = load_sky(sky_name);
    Case result;
    result.name = std::filesystem::path(file).stem().string() + ", " + std::filesystem::path(sky_name).stem().string();
    Settings settings;
    settings.size = size;
    settings.seed = 1000;
    settings.target_error = reference_error;
    settings.reuse = Switch::off;
    result.reference = bake(scene, sky, settings, device);
    settings.seed = 0;
    settings.target_error.reset();
    settings.reuse.reset();
    for (settings.rays = 16; settings.rays <= most_uniform_rays; settings.rays *= 4) {
        result.uniform.emplace_back(settings.rays, bake(scene, sky, settings, device));
    }
    for (const double target : targets) {
        settings.target_error = target;
        result.asked.emplace_back(target, bake(scene, sky, settings, device));
    }
    return result;
}

void measure(const Case& all, std::size_t page, Total& total) {
    const Bake reference = page_of(all.reference, page);
    std::vector<std::pair<double, double>> uniform;
    for (const auto& [rays, some] : all.uniform) {
        uniform.emplace_back(rays, compare_bakes(page_of(some, page), reference).relative_rmse);
    }
    const Slope slope = fit_slope(uniform);
    for (const auto& [target, some] : all.asked) {
        const Bake result = page_of(some, page);
        const BakeError error = compare_bakes(result, reference);
        const double rays = mean_rays(result);
        const double same = rays_for(uniform, error.relative_rmse);
        const MapError& estimate = *result.light_maps.front().error;
        fmt::print("| {} {} | {:.2f} ± {:.2f} | {:.3g} % | {:.2f} | {:.2f} | {:+.3f} | {:.0f} | {:.2f} | {:.2f} | "
                   "{:.1f} s |\n",
                   all.name, page + 1, slope.value, 2.0 * slope.standard_error, 100.0 * target,
                   error.relative_rmse / target, estimate.relative_rmse / target, error.bias / target, rays,
                   rays / same, estimate.best_mean_rays / same, trace_seconds(result));
        std::fflush(stdout);
        if (rays > 16.5) { // else nothing could be saved
            total.sum_of_logs += std::log(rays / same);
            total.worst = std::max(total.worst, rays / same);
            ++total.cases;
        }
    }
}

} // namespace

int main(int argument_count, char** arguments) {
    if (argument_count < 4) {
        fmt::print(stderr, "usage: vkbake_accuracy SIZE 'SKY[;SKY...]' SCENE...\n");
        return EXIT_FAILURE;
    }
    try {
        const Device device = open_device();
        Total total;
        fmt::print(
            "| scene, sky, map | slope | asked | true / asked | estimated / asked | bias / asked | rays a texel | "
            "rays / uniform | best / uniform | tracing |\n|---|---|---|---|---|---|---|---|---|---|\n");
        for (int scene = 3; scene < argument_count; ++scene) {
            for (const std::string& sky : split(arguments[2])) {
                const Case all = bake_all(arguments[scene], sky, std::atoi(arguments[1]), device);
                for (std::size_t page = 0; page < all.reference.light_maps.size(); ++page) {
                    measure(all, page, total);
                }
            }
        }
        if (total.cases > 0) {
            fmt::print("\nRays against uniform: {:.2f} in the geometric mean of {} cases, {:.2f} at worst.\n",
                       std::exp(total.sum_of_logs / total.cases), total.cases, total.worst);
        }
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
