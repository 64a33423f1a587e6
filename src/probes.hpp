// Light probes of a bake.
#pragma once

#include <cstddef>
#include <functional>

#include "stage_clock.hpp"
#include "trace/tracer.hpp"
#include "vkbake/geometry_image.hpp"
#include "vkbake/lightmap.hpp"
#include "vkbake/scene.hpp"

namespace vkbake {

/// Whether a bake of that scene has probes.
[[nodiscard]] bool has_probes(const Scene& scene, const Settings& settings);

/// Sets Bake::probes and Bake::probe_grid: those of the scene's nodes first, then the grid's. What surfaces send is
/// what the bake's light maps, which are not dilated yet, say that arrives at them, and what they emit. `draw`: the
/// geometry image of a page.
void add_probes(const Scene& scene, const Tracer& tracer, const std::function<const GeometryImage&(std::size_t)>& draw,
                StageClock& clock, Bake& bake);

} // namespace vkbake
