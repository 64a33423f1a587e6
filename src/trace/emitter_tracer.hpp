// The light that lanes get along rays that seek emitters.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <glm/vec3.hpp>

#include "trace/directions.hpp"
#include "trace/emitter_set.hpp"
#include "trace/lane_harmonics.hpp"
#include "trace/lane_parts.hpp"
#include "trace/surface_light.hpp"
#include "trace/tile_lanes.hpp"
#include "trace/tile_rays.hpp"
#include "trace/visibility.hpp"

namespace vkbake {

/// How the rays that find what emits by chance are spread.
enum class RaySpread {
    cosine,     ///< about the shading normal, by its cosine
    hemisphere, ///< evenly over what is above the shading normal's plane
    sphere,     ///< evenly over all directions; lanes have no surface
};

/// Along a ray.
struct ArrivingLight {
    glm::vec3 all{0.0F};
    glm::vec3 sought{0.0F}; ///< of it, from emitters that other rays seek
};

/// As many rays as a plan has samples, from scrambles of their own, go to points of emitters; what they and the plan's
/// own rays bring is joined by the power heuristic (E. Veach, L. Guibas, Optimally Combining Sampling
/// Techniques for Monte Carlo Rendering, 1995): p being the density of the plan's rays over solid angle and q that of
/// the choice, radiance L found by chance counts L · p² / (p² + q²), and found by choice L · p · q / (p² + q²). (The
/// balance heuristic takes more from the rays that hardly ever find a small lamp: with 16 rays twice the error.)
///
/// For one thread; allocates nothing after it is made.
class EmitterTracer {
public:
    /// All must outlive it. `plan`: of sampler cosine.
    EmitterTracer(const EmitterSet& emitters, const RayPlan& plan, RaySpread spread, const Visibility& visibility);

    /// From now on another plan, of the same seed, which must outlive it.
    void set_plan(const RayPlan& plan);

    /// Adds to `sums`, in the unit of the plan's rays; and to `parts`, unless null, the same light.
    void add(const TileLanes& lanes, std::array<glm::dvec3, RayBlock::lanes>& sums, LaneParts* parts = nullptr);
    /// Likewise.
    void add_harmonics(const TileLanes& lanes, LaneHarmonics& sums);
    /// What arrives of `light` along a ray of the plan's that met a surface, less what rays that seek emitters bring.
    [[nodiscard]] ArrivingLight arriving(const SurfaceLight& light, const TileLanes& lanes, std::size_t lane,
                                         const Ray& ray, const Hit& hit) const;

    [[nodiscard]] std::uint64_t rays() const { return m_ray_count; } ///< traced so far

private:
    [[nodiscard]] Receiver receiver_of(const TileLanes& lanes, std::size_t lane) const;
    /// Calls arrive(stratum, lane, light) for each ray that nothing stops.
    template<class Arrive>
    void trace(const TileLanes& lanes, const Arrive& arrive);
    /// Rays of a block of samples, and what they bring if nothing is in the way.
    void aim(const TileLanes& lanes);

    const EmitterSet* m_emitters; ///< never null
    RaySpread m_spread;
    const RayPlan* m_plan;          ///< never null
    const CosineStrata* m_strata;   ///< never null
    const Visibility* m_visibility; ///< never null
    VisibilityScratch m_scratch;
    TileLanes m_own_lanes; ///< keys of its own
    StratumTables m_tables;
    SampleIndices m_indices;
    RayBlock m_block;
    std::array<Receiver, RayBlock::lanes> m_receivers;
    std::array<std::array<glm::dvec3, RayBlock::lanes>, RayBlock::strata> m_light{};
    std::uint64_t m_ray_count = 0;
};

} // namespace vkbake
