// What is known of the light of a map's texels.
#pragma once

namespace vkbake {

/// Luminance over the texels.
struct KnownLight {
    double mean = 0.0;
    double variance = 0.0; ///< mean square error
};

} // namespace vkbake
