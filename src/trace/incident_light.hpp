// What arrives along rays: from the sky, and from surfaces.
#pragma once

#include <array>
#include <cstdint>

#include "trace/emitter_tracer.hpp"
#include "trace/lane_harmonics.hpp"
#include "trace/sky_lookup.hpp"
#include "trace/surface_light.hpp"
#include "trace/visibility.hpp"

namespace vkbake {

/// Of each lane, where its rays ended.
struct LaneEnds {
    std::array<std::uint32_t, RayBlock::lanes> rays{};
    std::array<std::uint32_t, RayBlock::lanes> back_sides{}; ///< of these: on a back that is not to be seen
};

/// For one thread; allocates nothing after it is made. What has rays of its own (lamps, the sky's peaks) is no part of
/// it.
class IncidentLight {
public:
    /// All must outlive it. `intensity` multiplies the sky. `surfaces`: null where surfaces send nothing.
    IncidentLight(const SkyLookup& sky, double intensity, const SurfaceLight* surfaces, const Visibility& visibility)
        : m_sky(&sky), m_intensity(static_cast<float>(intensity)), m_surfaces(surfaces), m_visibility(&visibility),
          m_scratch(visibility.make_scratch()) {}

    /// Of a block's active rays, made of `lanes`. Holds until the next call. `emitters`: brings what these rays are to
    /// leave out; null where it is nothing. `ends`: null, or added to; with surfaces only.
    const RadianceRows& along(const RayBlock& block, const TileLanes& lanes, const EmitterTracer* emitters,
                              LaneEnds* ends = nullptr);

private:
    void dim(const RayBlock& block);
    void add_surfaces(const RayBlock& block, const BlockedRays& met, const TileLanes& lanes,
                      const EmitterTracer* emitters);
    void count_ends(const RayBlock& block, const BlockedRays& blocked, LaneEnds& ends);

    const SkyLookup* m_sky; ///< never null
    float m_intensity;
    const SurfaceLight* m_surfaces;
    const Visibility* m_visibility; ///< never null
    VisibilityScratch m_scratch;
    RadianceRows m_radiance{};
};

} // namespace vkbake
