// The light of a tile's texels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <glm/vec3.hpp>

#include "trace/lamp_tracer.hpp"
#include "trace/lane_parts.hpp"
#include "trace/peak_tracer.hpp"
#include "trace/sky_sum.hpp"
#include "trace/tile_rays.hpp"
#include "trace/visibility.hpp"

namespace vkbake {

/// What was seen while tracing; sums of these do not depend on their order.
struct RayCounts {
    std::uint64_t rays = 0;
    std::uint64_t occluded_rays = 0;
    std::uint64_t filtered_rays = 0;
    std::uint64_t skipped_directions = 0;
    std::uint64_t probed_hits = 0;
    std::uint64_t back_side_hits = 0;
    std::uint64_t lamp_rays = 0;    ///< beside `rays`
    std::uint64_t peak_rays = 0;    ///< beside both
    std::uint64_t emitter_rays = 0; ///< beside all of these

    [[nodiscard]] std::uint64_t all() const { return rays + lamp_rays + peak_rays + emitter_rays; }

    RayCounts& operator+=(const RayCounts& other) {
        rays += other.rays;
        occluded_rays += other.occluded_rays;
        filtered_rays += other.filtered_rays;
        skipped_directions += other.skipped_directions;
        probed_hits += other.probed_hits;
        back_side_hits += other.back_side_hits;
        lamp_rays += other.lamp_rays;
        peak_rays += other.peak_rays;
        emitter_rays += other.emitter_rays;
        return *this;
    }
};

/// What has rays of its own; null where there is none of it, and nothing asks for it.
struct LightSources {
    const LampSet* lamps = nullptr;
    const SkyPeaks* peaks = nullptr; ///< sampler cosine only
};

/// Traces one tile after the other, for one thread; allocates nothing after it is made.
///
/// Of each texel one sample, which its key chooses, is a *probe*: where its ray is blocked, the nearest hit is asked
/// for, to see whether it is a back side. So over a map the probes are spread as its rays are, at the cost of a few in
/// a thousand.
class TileTracer {
public:
    /// All must outlive it, and what `sources` names too.
    TileTracer(const Surface& surface, const GeometryImage& geometry, const RayPlan& plan, const SkyLookup& sky,
               const Visibility& visibility, const LightSources& sources);

    /// From now on another plan: TileRays::set_plan.
    void set_plan(const RayPlan& plan) {
        m_plan = &plan;
        m_rays.set_plan(plan);
        if (m_lamps) {
            m_lamps->set_plan(plan);
        }
        if (m_peaks) {
            m_peaks->set_plan(plan);
        }
    }

    /// Calls store(texel, sum) for each texel of the tile: Σ weight · L, not yet scaled.
    template<typename Store>
    void trace(const TexelTile& tile, const Store& store) {
        sum_up(tile);
        for (std::uint32_t lane = 0; lane < tile.count; ++lane) {
            store(tile.texels[lane], light(lane));
        }
    }

    /// As trace(), and sums up the parts of the sequence; sampler cosine only. Calls store(lane, sum), after which
    /// parts() holds what the lanes have.
    template<typename Store>
    void trace_parts(const TexelTile& tile, const Store& store) {
        m_parts = {};
        m_with_parts = true;
        sum_up(tile);
        m_with_parts = false;
        for (std::uint32_t lane = 0; lane < tile.count; ++lane) {
            store(lane, light(lane));
        }
    }
    [[nodiscard]] const LaneParts& parts() const { return m_parts; }

    /// Of all tiles so far.
    [[nodiscard]] const RayCounts& counts() const { return m_counts; }
    [[nodiscard]] const std::optional<LampTracer>& lamps() const { return m_lamps; }

private:
    void sum_up(const TexelTile& tile);
    /// Of the last tile.
    [[nodiscard]] glm::dvec3 light(std::size_t lane) const {
        glm::dvec3 sum = total(*m_sky, m_sums, lane) + m_dimmed[lane];
        if (m_plan->settings().mode == Mode::bent_normal) {
            return bent_normal(lane, sum.x);
        }
        if (m_peaks) {
            sum += m_peaks->sum(lane);
        }
        if (m_lamps) {
            sum += m_lamps->sum(lane);
        }
        return sum;
    }
    /// Adds the rays of a block that come dimmed, and takes them out of `open`.
    void add_dimmed(const RayBlock& block, const RayPlan::Weights& weights, BlockedRays& open);
    /// Adds the rays of a block one by one, each with its own weight, and takes them out of `open`.
    void add_weighted(const RayBlock& block, BlockedRays& open);
    /// Adds a block's rays that are not blocked to the mean open direction.
    void add_directions(const RayBlock& block, const RayPlan::Weights& weights, const BlockedRays& blocked);
    [[nodiscard]] glm::dvec3 bent_normal(std::size_t lane, double visibility) const;
    /// Adds a block's rays to the parts that their samples belong to.
    void add_parts(const BlockedRays& open, const BlockedRays& blocked);
    /// Adds a sample that light came along.
    void add_to_part(std::size_t stratum, std::size_t lane, double luminance);
    /// Chooses each texel's probe.
    void choose_probes();
    /// Follows the probes that lie in a block.
    void probe(std::size_t number, const RayBlock& block, const BlockedRays& blocked);

    const RayPlan* m_plan;          ///< never null
    const SkyLookup* m_sky;         ///< never null
    const Visibility* m_visibility; ///< never null
    TileRays m_rays;
    VisibilityScratch m_scratch;
    LaneSums m_sums;
    std::array<glm::dvec3, RayBlock::lanes> m_dimmed{};     ///< sums of what comes through surfaces, or is weighted
    std::array<glm::dvec3, RayBlock::lanes> m_directions{}; ///< mode bent_normal: sums of those that are open
    bool m_with_parts = false;
    LaneParts m_parts;
    SampleIndices m_indices;
    LuminanceRows m_luminance{};
    std::array<std::uint64_t, RayBlock::lanes> m_probes{}; ///< a stratum
    std::optional<LampTracer> m_lamps;
    std::optional<PeakTracer> m_peaks;
    RayCounts m_counts;
};

} // namespace vkbake
