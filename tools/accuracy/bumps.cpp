// What renderers make of directional maps on bumpy surfaces, beside light that was traced for each bump's own normal.
//   vkbake_bumps SCENE SKY SIZE [PICTURE.png [OBJECT]]
// Prints the errors of the light that a tilted normal gets, relative to the mean, over the first page, or over an
// object's own map. The picture has that thrice, side by side: the light map alone, with vkbake_directional_light, and
// as it was traced.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "base/srgb.hpp"
#include "geometry_image/reference.hpp"
#include "trace/tracer.hpp"
#include "vkbake/vkbake.hpp"
#include "vkbake_light.h"

namespace {

using namespace vkbake;

constexpr int truth_rays = 1024;

/// The surface of even waves through the bake frame, `count` of them along each axis: a smooth field of directions, of
/// which a surface shows what lies along it. Tilts are 25° at the most, and 15° in the mean.
glm::vec3 bumped(const glm::vec3& normal, const glm::vec3& position, double count) {
    const glm::dvec3 place = count * std::numbers::pi * glm::dvec3(position);
    const glm::dvec3 slope(std::cos(place.x), std::cos(place.y), std::cos(place.z));
    const glm::dvec3 n(normal);
    return glm::vec3(glm::normalize(n - 0.33 * (slope - glm::dot(slope, n) * n)));
}

struct Lights {
    glm::vec3 flat{0.0F};
    glm::vec3 directional{0.0F};
    glm::vec3 bands{0.0F};
    glm::vec3 traced{0.0F};
};

std::vector<Lights> compare_bumps(const Bake& bake, const GeometryImage& geometry, const Image& traced,
                                  const GeometryImage& bumps, std::size_t page) {
    const LightMap& map = bake.light_maps.at(page);
    std::vector<Lights> lights(geometry.texel_count());
    for (std::size_t texel = 0; texel < lights.size(); ++texel) {
        if (geometry.triangle[texel] == GeometryImage::empty) {
            continue;
        }
        std::array<glm::vec3, 4> sh{};
        for (std::size_t i = 0; i < sh.size(); ++i) {
            sh[i] = glm::vec3(map.directional[i].texels[texel]);
        }
        const glm::vec3 flat(map.image.texels[texel]);
        const glm::vec3& normal = bumps.shading_normal[texel];
        lights[texel] = {
            flat,
            shared::vkbake_directional_light(flat, sh[0], sh[1], sh[2], sh[3], geometry.shading_normal[texel], normal),
            shared::vkbake_irradiance_sh1(sh[0], sh[1], sh[2], sh[3], normal), glm::vec3(traced.texels[texel])};
    }
    return lights;
}

void print_error(const std::string& name, std::span<const Lights> lights, glm::vec3 Lights::*light) {
    double squares = 0.0;
    double mean = 0.0;
    std::size_t count = 0;
    for (const Lights& texel : lights) {
        const glm::dvec3 difference(texel.*light - texel.traced);
        squares += glm::dot(difference, difference) / 3.0;
        mean += static_cast<double>(texel.traced.r + texel.traced.g + texel.traced.b) / 3.0;
        count += texel.traced == glm::vec3(0.0F) && texel.flat == glm::vec3(0.0F) ? 0 : 1;
    }
    const auto texels = static_cast<double>(std::max<std::size_t>(count, 1));
    fmt::print("  {:<28} {:5.1f} %\n", name, 100.0 * std::sqrt(squares / texels) / (mean / texels));
}

void write_picture(const std::string& file, std::span<const Lights> lights, int width, int height) {
    double mean = 0.0;
    double lit = 0.0;
    for (const Lights& texel : lights) {
        mean += static_cast<double>(texel.flat.g);
        lit += texel.flat.g > 0.0F ? 1.0 : 0.0;
    }
    const double exposure = 0.35 * lit / std::max(mean, 1e-30);
    Image picture{.width = 3 * width, .height = height, .texels = {}, .coverage = {}};
    for (int y = 0; y < height; ++y) {
        for (const auto light : {&Lights::flat, &Lights::directional, &Lights::traced}) {
            for (int x = 0; x < width; ++x) {
                const Lights& texel =
                    lights[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
                glm::vec4 shown(0.0F, 0.0F, 0.0F, 1.0F);
                for (int channel = 0; channel < 3; ++channel) {
                    const double value = exposure * static_cast<double>((texel.*light)[channel]);
                    shown[channel] = static_cast<float>(linear_to_srgb(value / (1.0 + 0.4 * value)));
                }
                picture.texels.push_back(shown);
            }
        }
    }
    write_image(file, picture);
}

std::size_t page_of(const Bake& bake, const std::string& object) {
    const auto found = std::ranges::find_if(bake.light_maps,
                                            [&](const LightMap& map) { return object.empty() || map.name == object; });
    if (found == bake.light_maps.end()) {
        throw Error(ErrorKind::usage, "object \"" + object + "\": the scene has none of that name; choose another");
    }
    return static_cast<std::size_t>(found - bake.light_maps.begin());
}

int run(std::span<char*> arguments) {
    if (arguments.size() < 4) {
        fmt::print(stderr, "usage: vkbake_bumps SCENE SKY SIZE [PICTURE.png]\n");
        return 2;
    }
    const Scene scene = load_scene(arguments[1]);
    const Sky sky = load_sky(arguments[2]);
    Settings settings;
    settings.size = std::stoi(arguments[3]);
    settings.rays = truth_rays;
    settings.directional = Switch::on;
    settings.layout = arguments.size() > 5 ? Layout::object : Layout::atlas;
    const Bake bake = vkbake::bake(scene, sky, settings, open_device());
    const std::size_t page = page_of(bake, arguments.size() > 5 ? arguments[5] : "");
    const GeometryImage geometry = reference_geometry_image(bake.surface, bake.atlas, static_cast<std::uint32_t>(page));
    GeometryImage bumps = geometry;
    for (std::size_t texel = 0; texel < bumps.texel_count(); ++texel) {
        if (bumps.triangle[texel] != GeometryImage::empty) {
            bumps.shading_normal[texel] = bumped(geometry.shading_normal[texel], geometry.position[texel], 24.0);
        }
    }
    const LightMap traced = Tracer(bake.surface, sky, settings, scene.lamps).trace(bumps);
    const std::vector<Lights> lights = compare_bumps(bake, geometry, traced.image, bumps, page);
    fmt::print("{}, sky {}, {} texels a side, {} directional rays\n", scene.name, sky.name, settings.size,
               settings.directional_rays);
    print_error("light map alone", lights, &Lights::flat);
    print_error("vkbake_irradiance_sh1", lights, &Lights::bands);
    print_error("vkbake_directional_light", lights, &Lights::directional);
    if (arguments.size() > 4) {
        write_picture(arguments[4], lights, geometry.width, geometry.height);
    }
    return 0;
}

} // namespace

int main(int argument_count, char** arguments) {
    try {
        return run({arguments, static_cast<std::size_t>(argument_count)});
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
