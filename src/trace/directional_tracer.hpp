// Where the light of a tile's texels comes from.
#pragma once

#include <cstddef>
#include <cstdint>

#include <glm/vec3.hpp>

#include "trace/incident_light.hpp"
#include "trace/lane_harmonics.hpp"
#include "trace/sought_light.hpp"
#include "trace/tile_rays.hpp"

namespace vkbake {

/// Spherical harmonics, l ≤ 1, of the radiance that arrives at each texel from above its surface. For one thread;
/// allocates nothing after it is made.
///
/// Rays of their own, evenly spread over the hemisphere. A light map's are cosine-weighted: each would count by
/// 1 / cos θ here, and the variance of that has no bound. The samples are the same strata: a direction with the
/// cosine z goes on along its meridian to the cosine z², which makes cosine-weighted directions even ones (both take
/// the squared radius 1 − z² of the disc for what is uniform).
class DirectionalTracer {
public:
    /// All must outlive it. `plan`: of sampler cosine. `light`: null where surfaces send nothing. `emitters`: of it, to
    /// be sought; null where there are none.
    DirectionalTracer(const TracedScene& scene, const GeometryImage& geometry, const RayPlan& plan,
                      const SurfaceLight* light, const EmitterSet* emitters);

    /// Calls store(texel, lane) for each texel of the tile, for which coefficient(i, lane) then holds.
    template<typename Store>
    void trace(const TexelTile& tile, const Store& store) {
        sum_up(tile);
        for (std::uint32_t lane = 0; lane < tile.count; ++lane) {
            store(tile.texels[lane], lane);
        }
    }
    /// ∫ L Y of the hemisphere.
    [[nodiscard]] glm::dvec3 coefficient(std::size_t i, std::size_t lane) const;
    [[nodiscard]] std::uint64_t rays() const; ///< traced so far, those that seek light with them

private:
    void sum_up(const TexelTile& tile);
    /// From cosine-weighted to even directions.
    void spread(RayBlock& block) const;

    const RayPlan* m_plan; ///< never null
    double m_intensity;
    IncidentLight m_incident;
    TileRays m_rays;
    RayBlock m_block;
    SoughtLight m_sought;
    LaneHarmonics m_around{directional_coefficients};
    LaneHarmonics m_sent{directional_coefficients}; ///< by lamps and peaks
    std::uint64_t m_ray_count = 0;
};

} // namespace vkbake
