// What tracing will take, and how good it will be, from a few texels that are traced.
#pragma once

#include <cstdint>
#include <optional>

#include "vkbake/atlas.hpp"
#include "vkbake/scene.hpp"
#include "vkbake/settings.hpp"
#include "vkbake/sky.hpp"
#include "vkbake/surface.hpp"

namespace vkbake {

/// Of the direct light of all maps.
struct ForetoldTrace {
    double rays = 0.0;           ///< to lamps and the sky's peaks too
    double seconds = 0.0;        ///< on this machine, with the threads that the settings say
    std::optional<double> error; ///< relative, over all maps; absent where it is not estimated
};

/// Traces some ten thousand texels in squares all over the maps, for 3 % of error, two seconds or 1024 rays at the
/// most, and brings what they take to all: by the texels that are covered, and where more is asked for by the slope
/// that their own errors show. `covered_texels`: of all maps, as expected. Without a device.
[[nodiscard]] ForetoldTrace foretell_trace(const Scene& scene, const Surface& surface, const Atlas& atlas,
                                           const Settings& settings, const Sky& sky, std::uint64_t covered_texels);

} // namespace vkbake
