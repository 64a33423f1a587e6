// Skies as pictures of what is seen in each direction.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "vkbake/sky.hpp"

namespace vkbake::test {

using Radiance = std::function<glm::dvec3(const glm::dvec3&)>; // of a unit direction

/// 2 `height` × `height` texels, each of what its middle shows.
inline Sky panorama_of(int height, const Radiance& radiance, std::string name = "panorama") {
    Image image{.width = 2 * height, .height = height, .texels = {}, .coverage = {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const double azimuth = (2.0 * (x + 0.5) / image.width - 1.0) * std::numbers::pi;
            const double polar = (y + 0.5) / height * std::numbers::pi;
            const glm::dvec3 direction(std::cos(azimuth) * std::sin(polar), std::cos(polar),
                                       std::sin(azimuth) * std::sin(polar));
            image.texels.emplace_back(glm::vec3(radiance(direction)), 1.0F);
        }
    }
    return {.source = EquirectangularSky{std::move(image)}, .name = std::move(name)};
}

} // namespace vkbake::test
