// What is known of the light of a map's texels.
#pragma once

#include <optional>

#include "vkbake/lightmap.hpp"

namespace vkbake {

/// Luminance over the texels.
struct KnownLight {
    double mean = 0.0;
    double variance = 0.0; ///< mean square error
};

/// The mean over its covered texels; 0 where it has none.
[[nodiscard]] double mean_luminance(const LightMap& map);

/// Of a map as it is; absent where its error was not estimated.
[[nodiscard]] std::optional<KnownLight> known_light(const LightMap& map);

} // namespace vkbake
