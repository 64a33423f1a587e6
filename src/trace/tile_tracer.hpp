// The light of a tile's texels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <glm/vec3.hpp>

#include "trace/lamp_tracer.hpp"
#include "trace/peak_tracer.hpp"
#include "trace/sky_sum.hpp"
#include "trace/tile_rays.hpp"
#include "trace/tile_sampler.hpp"
#include "trace/visibility.hpp"

namespace vkbake {

/// What has rays of its own; null where there is none of it, and nothing asks for it.
struct LightSources {
    const LampSet* lamps = nullptr;
    const SkyPeaks* peaks = nullptr; ///< sampler cosine only
};

/// Traces one tile after the other, for one thread; allocates nothing after it is made.
///
/// Of each texel one sample, which chance chooses, is a *probe*: where its ray is blocked, the nearest hit is asked
/// for, to see whether it is a back side. So over a map the probes are spread as its rays are, at the cost of a few in
/// a thousand.
class TileTracer final : public TileSampler {
public:
    /// All must outlive it, and what `sources` names too.
    TileTracer(const Surface& surface, const GeometryImage& geometry, const RayPlan& plan, const SkyLookup& sky,
               const Visibility& visibility, const LightSources& sources);

    void set_plan(const RayPlan& plan) override;

    /// Calls store(texel, sum) for each texel of the tile: Σ weight · L, not yet scaled.
    template<typename Store>
    void trace(const TexelTile& tile, const Store& store) {
        sum_up(tile, nullptr);
        for (std::uint32_t lane = 0; lane < tile.count; ++lane) {
            store(tile.texels[lane], light(lane));
        }
    }

    void sample(const TexelTile& tile, CellVisibility* seen) override;
    [[nodiscard]] glm::dvec3 light(std::size_t lane) const override;
    [[nodiscard]] const LaneParts& parts() const override { return m_parts; }
    [[nodiscard]] const RayCounts& counts() const override { return m_counts; }
    [[nodiscard]] const std::optional<LampTracer>& lamps() const { return m_lamps; }

private:
    void plan_for_sources();
    /// What the rays of a block met: those that something, but not all, comes along are of both.
    struct Met {
        BlockedRays nothing{};
        BlockedRays something{};
    };

    void sum_up(const TexelTile& tile, CellVisibility* seen);
    /// Traces the strata whose answers `seen` does not tell, and adds what it tells of the others.
    void trace_unknown(const CosineStrata& strata, CellVisibility& seen);
    Met trace_strata(const BlockStrata& strata, CellVisibility& seen);
    /// Traces the plan's block `number`, or the strata that come as such.
    Met trace_block(std::size_t number, const RayBlock& block, const RayPlan::Weights& weights);
    /// Of the last block, into its rays' cells.
    void remember(const Met& met, CellVisibility& seen) const;
    /// Adds the sky's light along all rays of a block, none of which is traced.
    void add_open(const RayBlock& block);
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
    void add_to_part(std::size_t stratum, std::size_t lane, unsigned shift, double luminance);
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
    std::size_t m_traced_blocks = 0; ///< of this tile, where not all are
    LaneParts m_parts;
    SampleIndices m_indices;
    LuminanceRows m_luminance{};
    std::array<std::uint64_t, RayBlock::lanes> m_probes{}; ///< a stratum
    std::optional<LampTracer> m_lamps;
    std::optional<PeakTracer> m_peaks;
    RayCounts m_counts;
};

} // namespace vkbake
