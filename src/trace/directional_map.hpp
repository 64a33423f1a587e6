// Geometry image → directional light map.
#pragma once

#include <cstdint>
#include <vector>

#include "trace/surface_light.hpp"
#include "trace/tracer.hpp"
#include "vkbake/geometry_image.hpp"
#include "vkbake/image.hpp"

namespace vkbake {

struct DirectionalMap {
    std::vector<Image> coefficients; ///< as LightMap::directional; no coverage
    std::uint64_t rays = 0;
    double seconds = 0.0;
};

/// LightMap::directional of what the tracer's light map of the page has: sky, its peaks and lamps, and `light`, which
/// leaves surfaces towards all bounces together; null where there are none. `emitters`: of that light, to be sought;
/// null where there are none. Settings::directional_rays a texel. The
/// bits depend on nothing but the arguments. Throws Error{interrupted} where `progress` returned false.
[[nodiscard]] DirectionalMap trace_directional(const Tracer& tracer, const GeometryImage& geometry,
                                               const SurfaceLight* light, const EmitterSet* emitters,
                                               const TraceProgress& progress = {});

} // namespace vkbake
