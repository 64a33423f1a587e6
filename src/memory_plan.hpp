// How much memory a bake takes, foretold from what is counted before the work starts.
#pragma once

#include <cstdint>
#include <optional>

#include "vkbake/atlas.hpp"
#include "vkbake/scene.hpp"
#include "vkbake/settings.hpp"
#include "vkbake/sky.hpp"

namespace vkbake {

/// What decides it.
struct MemoryNeed {
    std::uint64_t held = 0;       ///< bytes that scene and sky take already
    std::uint64_t sky_texels = 0; ///< of a picture; it is copied for look-ups
    bool images = false;          ///< whether scene or sky have image files
    std::uint64_t triangles = 0;  ///< over all instances
    std::uint64_t opacity = 0;    ///< bytes: opacity_bytes()
    std::uint64_t maps = 1;
    int size = 1;              ///< side of each map, texels
    double touched = 1.0;      ///< share of all maps' texels that may be written to, as memory: see the .cpp
    double most_touched = 1.0; ///< of the map with the largest
    bool bounces = false;      ///< whether light is followed from surface to surface
    bool directional = false;  ///< with maps of where light comes from
    bool estimated = false;    ///< with the texels' errors
    bool denoised = false;
    bool copied = false; ///< whether a map is copied as a whole for one of these, or to be written
};

/// Of a bake of that scene into maps of settings.size: the atlas's; before there is one, as many as there are at least,
/// all of whose texels are covered.
[[nodiscard]] MemoryNeed memory_need(const Scene& scene, const Sky& sky, const Settings& settings,
                                     const Atlas* atlas = nullptr);

/// Bytes that the process takes at most from bake to the end of write_bake, Mesa's software driver included (other
/// drivers keep much of this in the device's own memory). An upper bound of what was measured: see the .cpp. Small maps
/// written as HDR, of a scene without images, may take 100 MiB more.
[[nodiscard]] std::uint64_t peak_memory(const MemoryNeed& need);

/// What a bake may take: settings.memory_limit, or three quarters of what the machine has.
[[nodiscard]] std::uint64_t memory_limit(const Settings& settings);

/// Throws Error{usage} where the peak lies above the limit, with the size that would fit.
void check_memory(const MemoryNeed& need, const Settings& settings);

/// The same before there is an atlas: where the peak lies above the limit even if the maps are all but empty.
void check_least_memory(const MemoryNeed& need, const Settings& settings);

} // namespace vkbake
