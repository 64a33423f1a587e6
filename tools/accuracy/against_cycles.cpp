// A bake beside the map that another renderer made of the same scene, sky and UVs: where both see the same light they
// agree within their noise. Made for maps of Blender's Cycles, which average over half a texel.
//   vkbake_against_cycles SCENE REFERENCE SKY|ao RAYS [DIFFERENCE.png]
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/vec2.hpp>

#include "base/luminance.hpp"
#include "vkbake/vkbake.hpp"

namespace {

using namespace vkbake;

/// Texels of the finer map along a texel's side. Of these the middle 4 × 4 are the square of half a texel.
constexpr int finer = 8;
constexpr int first_inside = finer / 4;
constexpr int last_inside = finer - first_inside;

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// A triangle of the map, in texels.
struct MapTriangle {
    MapTriangle(const Atlas& atlas, std::size_t triangle, int side)
        : a(glm::dvec2(atlas.uvs[3 * triangle]) * static_cast<double>(side)),
          b(glm::dvec2(atlas.uvs[3 * triangle + 1]) * static_cast<double>(side)),
          c(glm::dvec2(atlas.uvs[3 * triangle + 2]) * static_cast<double>(side)) {}

    [[nodiscard]] bool holds(const glm::dvec2& point) const {
        const double ab = cross(b - a, point - a);
        const double bc = cross(c - b, point - b);
        const double ca = cross(a - c, point - c);
        return (ab >= 0.0 && bc >= 0.0 && ca >= 0.0) || (ab <= 0.0 && bc <= 0.0 && ca <= 0.0);
    }

    glm::dvec2 a;
    glm::dvec2 b;
    glm::dvec2 c;
};

/// For each texel the triangle that holds its centre, or `none`.
std::vector<std::uint32_t> owners(const Bake& bake, int side) {
    std::vector<std::uint32_t> owner(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), none);
    for (std::size_t t = 0; t < bake.surface.triangle_count(); ++t) {
        const MapTriangle triangle(bake.atlas, t, side);
        const auto [left, right] = std::minmax({triangle.a.x, triangle.b.x, triangle.c.x});
        const auto [top, bottom] = std::minmax({triangle.a.y, triangle.b.y, triangle.c.y});
        for (int y = std::max(0, static_cast<int>(top)); y < std::min(side, static_cast<int>(bottom) + 1); ++y) {
            for (int x = std::max(0, static_cast<int>(left)); x < std::min(side, static_cast<int>(right) + 1); ++x) {
                if (triangle.holds({x + 0.5, y + 0.5})) {
                    owner[static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x)] =
                        static_cast<std::uint32_t>(t);
                }
            }
        }
    }
    return owner;
}

/// The luminance of texel x, y over the footprint: half a texel wide, inside the one triangle that holds the centre.
std::optional<double> footprint_mean(const Image& fine, const Atlas& atlas, std::uint32_t owner, int side, int x,
                                     int y) {
    const MapTriangle triangle(atlas, owner, side * finer);
    double sum = 0.0;
    int count = 0;
    for (int j = finer * y + first_inside; j < finer * y + last_inside; ++j) {
        for (int i = finer * x + first_inside; i < finer * x + last_inside; ++i) {
            const std::size_t texel = fine.index(i, j);
            if (fine.coverage[texel] > 0.5F && triangle.holds({i + 0.5, j + 0.5})) {
                sum += luminance(glm::dvec3(fine.texels[texel]));
                ++count;
            }
        }
    }
    return count > 0 ? std::optional(sum / count) : std::nullopt;
}

struct Agreement {
    std::uint64_t texels = 0;
    std::uint64_t not_finite = 0; ///< in the reference
    double ours = 0.0;            ///< mean
    double theirs = 0.0;          ///< mean
    std::vector<double> differences;
    Image picture; ///< ours darker: blue; ours brighter: red; 10 % of the mean is full
};

Agreement compare_with(const Bake& bake, const Image& reference) {
    const int side = reference.width;
    const std::vector<std::uint32_t> owner = owners(bake, side);
    Agreement result;
    result.picture = {side, side, std::vector<glm::vec4>(reference.texels.size(), {0.0F, 0.0F, 0.0F, 1.0F}), {}};
    std::vector<std::size_t> places;
    for (std::size_t texel = 0; texel < reference.texels.size(); ++texel) {
        const int x = static_cast<int>(texel % static_cast<std::size_t>(side));
        const int y = static_cast<int>(texel / static_cast<std::size_t>(side));
        const auto ours = owner[texel] == none
                              ? std::nullopt
                              : footprint_mean(bake.light_maps[0].image, bake.atlas, owner[texel], side, x, y);
        if (!ours || reference.texels[texel].w < 0.5F) {
            continue;
        }
        const double theirs = luminance(glm::dvec3(reference.texels[texel]));
        if (!std::isfinite(theirs)) {
            ++result.not_finite;
            continue;
        }
        ++result.texels;
        result.ours += *ours;
        result.theirs += theirs;
        result.differences.push_back(*ours - theirs);
        places.push_back(texel);
    }
    result.ours /= static_cast<double>(result.texels);
    result.theirs /= static_cast<double>(result.texels);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto share = static_cast<float>(result.differences[i] / result.theirs / 0.1);
        result.picture.texels[places[i]] = {0.1F + std::max(share, 0.0F), 0.1F, 0.1F + std::max(-share, 0.0F), 1.0F};
    }
    return result;
}

void print(const std::string& name, Agreement result) {
    std::vector<double>& all = result.differences;
    std::ranges::sort(all, {}, [](double difference) { return std::abs(difference); });
    const auto rmse = [&](std::size_t count) {
        double squares = 0.0;
        for (std::size_t i = 0; i < count; ++i) {
            squares += all[i] * all[i];
        }
        return 100.0 * std::sqrt(squares / static_cast<double>(count)) / result.theirs;
    };
    const auto far = std::ranges::count_if(all, [&](double d) { return std::abs(d) > 0.05 * result.theirs; });
    fmt::print("| {} | {} | {:+.3f} % | {:.2f} % | {:.2f} % | {:.2f} % | {:.2f} % | {} |\n", name, result.texels,
               100.0 * (result.ours / result.theirs - 1.0), rmse(all.size()), rmse(all.size() - all.size() / 100),
               100.0 * std::abs(all[all.size() / 2]) / result.theirs,
               100.0 * static_cast<double>(far) / static_cast<double>(all.size()), result.not_finite);
}

int run(const std::vector<std::string>& arguments) {
    const Scene scene = load_scene(arguments[0]);
    const Image reference = read_image(arguments[1]);
    Settings settings;
    settings.size = finer * reference.width;
    settings.uv = UvSource::trust; // Blender's smart projection overlaps itself by a twentieth of a texel
    settings.padding = 0;
    settings.rays = static_cast<std::uint32_t>(std::stoul(arguments[3]));
    settings.mode = arguments[2] == "ao" ? Mode::ao : Mode::irradiance;
    const Sky sky = settings.mode == Mode::ao ? load_sky("1,1,1") : load_sky(arguments[2]);
    const Bake fine = bake(scene, sky, settings, open_device());
    const Agreement result = compare_with(fine, reference);
    if (arguments.size() > 4) {
        write_image(arguments[4], result.picture);
    }
    print(std::filesystem::path(arguments[1]).stem().string(), result);
    return EXIT_SUCCESS;
}

} // namespace

int main(int argument_count, char** arguments) {
    try {
        if (argument_count == 5 || argument_count == 6) {
            return run({arguments + 1, arguments + argument_count});
        }
        fmt::print(stderr, "usage: vkbake_against_cycles SCENE REFERENCE SKY|ao RAYS [DIFFERENCE.png]\n");
    } catch (const std::exception& error) {
        fmt::print(stderr, "vkbake_against_cycles: {}\n", error.what());
    }
    return EXIT_FAILURE;
}
