// How the errors of neighbouring texels cancel: the error of means over k × k texels, beside what independent texels
// would leave.
//   vkbake_neighbours SIZE SKY SCENE…
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <fmt/format.h>

#include "base/luminance.hpp"
#include "vkbake/vkbake.hpp"

namespace {

using namespace vkbake;

constexpr double reference_error = 0.003;
constexpr std::array<std::size_t, 4> sides{1, 2, 4, 6};

/// Sums over all maps of one bake.
struct Tally {
    std::array<double, sides.size()> squares{};
    std::array<double, sides.size()> blocks{};
    double light = 0.0;

    /// Every block of the map, wherever it begins, all of whose texels are covered.
    void add(const LightMap& map, const LightMap& reference) {
        const auto width = static_cast<std::size_t>(map.image.width);
        const auto height = static_cast<std::size_t>(map.image.height);
        const auto of = [](const LightMap& some, std::size_t texel) {
            return luminance(glm::dvec3(some.image.texels[texel]));
        };
        for (std::size_t level = 0; level < sides.size(); ++level) {
            const std::size_t side = sides[level];
            for (std::size_t top = 0; top + side <= height; ++top) {
                for (std::size_t left = 0; left + side <= width; ++left) {
                    double error = 0.0;
                    double light_here = 0.0;
                    bool covered = true;
                    for (std::size_t i = 0; i < side * side; ++i) {
                        const std::size_t texel = (top + i / side) * width + left + i % side;
                        covered = covered && map.image.coverage[texel] > 0.5F;
                        const double truth = of(reference, texel);
                        light_here += truth;
                        error += of(map, texel) - truth;
                    }
                    if (covered) {
                        const double mean = error / static_cast<double>(side * side);
                        squares[level] += mean * mean;
                        blocks[level] += 1.0;
                        light += level == 0 ? light_here : 0.0;
                    }
                }
            }
        }
    }

    /// Relative to the mean light of all covered texels.
    [[nodiscard]] double error(std::size_t level) const {
        return std::sqrt(squares[level] / blocks[level]) * blocks[0] / light;
    }
};

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
    settings.target_error.reset();
    for (const std::uint32_t rays : {64U, 256U, 1024U}) {
        settings.rays = rays;
        const Bake result = bake(scene, sky, settings, device);
        Tally tally;
        for (std::size_t map = 0; map < result.light_maps.size(); ++map) {
            tally.add(result.light_maps[map], reference.light_maps[map]);
        }
        fmt::print("| {}, {} | {} | {:.2f} % |", std::filesystem::path(file).stem().string(), size, rays,
                   100.0 * tally.error(0));
        for (std::size_t level = 1; level < sides.size(); ++level) {
            fmt::print(" {:.2f} % | {:.2f} |", 100.0 * tally.error(level),
                       tally.error(level) * static_cast<double>(sides[level]) / tally.error(0));
        }
        fmt::print("\n");
        std::fflush(stdout);
    }
}

} // namespace

int main(int argument_count, char** arguments) {
    if (argument_count < 4) {
        fmt::print(stderr, "usage: vkbake_neighbours SIZE SKY SCENE...\n");
        return EXIT_FAILURE;
    }
    try {
        const Device device = open_device();
        fmt::print("| scene, size | rays | texels | 2 x 2 | of independent | 4 x 4 | of independent | 6 x 6 | of "
                   "independent |\n|---|---|---|---|---|---|---|---|---|\n");
        for (int scene = 3; scene < argument_count; ++scene) {
            measure(arguments[scene], arguments[2], std::atoi(arguments[1]), device);
        }
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
