// The light that a tile's texels get from the sky's peaks.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <glm/vec3.hpp>

#include "trace/directions.hpp"
#include "trace/lane_harmonics.hpp"
#include "trace/lane_parts.hpp"
#include "trace/peak_directions.hpp"
#include "trace/sky_peaks.hpp"
#include "trace/tile_lanes.hpp"
#include "trace/tile_rays.hpp"
#include "trace/visibility.hpp"

namespace vkbake {

/// As many rays as a plan has samples, from scrambles of their own, go where the peaks' light comes from. For one
/// thread; allocates nothing after it is made.
class PeakTracer {
public:
    /// Both must outlive it.
    PeakTracer(const SkyPeaks& peaks, const Visibility& visibility);

    /// From now on the samples of this plan, of sampler cosine, which must outlive it.
    void set_plan(const RayPlan& plan);
    /// Sums up for a tile's lanes; where `parts` is not null, also the parts of the samples.
    void sum_up(const TileLanes& lanes, LaneParts* parts);
    /// Adds their radiance for a tile's lanes, whatever its angle to their surface: π / samples() times what is added
    /// is ∫ L Y. With Horizon::none the lanes' normals mean nothing.
    void add_harmonics(const TileLanes& lanes, Horizon horizon, LaneHarmonics& harmonics);
    /// Of the last tile that was summed up, in the unit of RayPlan's sums: scale() times it is E/π.
    [[nodiscard]] const glm::dvec3& sum(std::size_t lane) const { return m_sums[lane]; }
    [[nodiscard]] std::uint64_t rays() const { return m_ray_count; } ///< traced so far

private:
    /// What there is to do for the lanes, into m_sums and `parts`, or into m_harmonics.
    void trace(const TileLanes& lanes, LaneParts* parts);
    /// Rays and weights of a block of samples.
    void aim(const TileLanes& lanes);
    void trace_block(LaneParts* parts);

    const SkyPeaks* m_peaks;        ///< never null
    const Visibility* m_visibility; ///< never null
    const RayPlan* m_plan = nullptr;
    const CosineStrata* m_strata = nullptr;
    VisibilityScratch m_scratch;
    TileLanes m_own_lanes; ///< keys of its own
    StratumTables m_tables;
    SampleIndices m_indices;
    RayBlock m_block;
    PeakSamples m_samples; ///< the light: E/π of a sample; of one that is faced, for harmonics
    std::array<glm::dvec3, RayBlock::lanes> m_sums{};
    Horizon m_horizon = Horizon::surface;
    LaneHarmonics* m_harmonics = nullptr; ///< while they are asked for
    std::uint64_t m_ray_count = 0;
};

} // namespace vkbake
