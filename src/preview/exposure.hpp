// How bright the light is that a picture must cope with.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "vkbake/image.hpp"

namespace vkbake {

/// The mean over the covered texels of all maps (coverage, or where a map has none: A above 0) that are finite and not
/// black; 0 if there are none. Black ones, below 1 % of the mean of all, are mostly inside of something: nobody sees
/// them, and there may be many.
[[nodiscard]] glm::dvec3 mean_light(const std::vector<Image>& light_maps);

/// The factor by which a white surface is shown at 0.4 in the geometric mean of the light (linear RGB, E/π) that falls
/// on what a picture shows, so a middling one (base colour 0.45) at the photographer's middle grey, 18 %. `light` has
/// one value a pixel; those with alpha 0 show no surface and do not count, nor do ones that are not finite or are black
/// (below 1 % of the mean). nullopt where none counts.
[[nodiscard]] std::optional<double> metered_exposure(std::span<const glm::vec4> light);

} // namespace vkbake
