// Light that goes from surface to surface.
#pragma once

#include <cstddef>
#include <functional>

#include "stage_clock.hpp"
#include "trace/tracer.hpp"
#include "vkbake/geometry_image.hpp"
#include "vkbake/lightmap.hpp"
#include "vkbake/scene.hpp"

namespace vkbake {

/// Adds what surfaces reflect and emit to light maps that hold the sky's light and are not dilated yet, bounce after
/// bounce: each is gathered from the light maps of the one before, so a bounce costs as much as the last. Of a scene
/// that neither reflects nor emits nothing is loaded or traced, and a note says so. `draw`: the geometry image of a
/// page.
void add_bounces(const Scene& scene, const Tracer& tracer, const std::function<const GeometryImage&(std::size_t)>& draw,
                 StageClock& clock, Bake& bake);

} // namespace vkbake
