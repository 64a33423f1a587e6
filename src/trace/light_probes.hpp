// Points in the air → the light that arrives there.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "trace/lane_harmonics.hpp"
#include "trace/surface_light.hpp"
#include "trace/tracer.hpp"

namespace vkbake {

/// LightProbe's values.
struct ProbeLight {
    std::array<glm::vec3, probe_coefficients> coefficients{};
    double back_sides = 0.0;
};

struct TracedProbes {
    std::vector<ProbeLight> probes; ///< one a place
    std::uint64_t rays = 0;
};

/// Of the tracer's sky with its peaks, its lamps, and of `light`, which leaves surfaces. `places`: bake frame. Each
/// probe sends Settings::probe_rays evenly over the sphere, and as many more to the sky's peaks, to each soft lamp and
/// to emitters; its bits depend on its place, and on no other probe. Throws Error{interrupted} where `progress`
/// returned false.
[[nodiscard]] TracedProbes trace_probes(const Tracer& tracer, std::span<const glm::vec3> places,
                                        const SurfaceLight& light, const TraceProgress& progress = {});

} // namespace vkbake
