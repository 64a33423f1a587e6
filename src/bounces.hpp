// Light that goes from surface to surface.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "stage_clock.hpp"
#include "trace/tracer.hpp"
#include "vkbake/geometry_image.hpp"
#include "vkbake/lightmap.hpp"
#include "vkbake/scene.hpp"

namespace vkbake {

/// What leaves surfaces, as SurfaceLight takes it.
struct SentLight {
    std::vector<LeavingLight> pages;     ///< empty where nothing does, or nobody asks
    std::vector<std::uint8_t> two_sided; ///< one a part of the surface
};

/// Adds what surfaces reflect and emit to light maps that hold the sky's light and are not dilated yet, bounce after
/// bounce: each is gathered from the light maps of the one before, so a bounce costs as much as the last. Of a scene
/// that neither reflects nor emits nothing is loaded or traced, and a note says so. `draw`: the geometry image of a
/// page. Returns what left surfaces towards all of the bounces together, where directional maps ask for it.
SentLight add_bounces(const Scene& scene, const Tracer& tracer,
                      const std::function<const GeometryImage&(std::size_t)>& draw, StageClock& clock, Bake& bake);

/// What surfaces send of the light that the light maps, not dilated yet, say that arrives at them, and what they emit.
[[nodiscard]] SentLight light_from_maps(const Scene& scene,
                                        const std::function<const GeometryImage&(std::size_t)>& draw, const Bake& bake);

/// Sets LightMap::directional of maps that are not dilated yet. `sent`: add_bounces'.
void add_directional(const Tracer& tracer, const SentLight& sent,
                     const std::function<const GeometryImage&(std::size_t)>& draw, StageClock& clock, Bake& bake);

} // namespace vkbake
