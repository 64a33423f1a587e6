// How bright the light is that a picture must cope with.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "vkbake/image.hpp"

namespace vkbake {

/// The mean over the covered texels of all maps (coverage, or where a map has none: A above 0) that are finite and not
/// black; 0 if there are none. Black ones, below 1 % of the mean of all, are mostly inside of something: nobody sees
/// them, and there may be many.
[[nodiscard]] glm::dvec3 mean_light(const std::vector<Image>& light_maps);

/// The factor by which a white surface in the mean light is shown at 0.4, so a middling one (base colour 0.45) at the
/// photographer's middle grey, 18 %. A noon and a night so give pictures of like brightness. 1 where all is dark.
[[nodiscard]] double automatic_exposure(const std::vector<Image>& light_maps);

} // namespace vkbake
