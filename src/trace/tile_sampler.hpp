// What has the tiles of a map traced, sample by sample.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "trace/cell_visibility.hpp"
#include "trace/lane_parts.hpp"
#include "trace/texel_tiles.hpp"
#include "trace/tile_rays.hpp"

namespace vkbake {

/// What was seen while tracing; sums of these do not depend on their order.
struct RayCounts {
    std::uint64_t rays = 0;
    std::uint64_t occluded_rays = 0;
    std::uint64_t filtered_rays = 0;
    std::uint64_t skipped_directions = 0;
    std::uint64_t spared_rays = 0; ///< not traced: what they meet was known
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
        spared_rays += other.spared_rays;
        probed_hits += other.probed_hits;
        back_side_hits += other.back_side_hits;
        lamp_rays += other.lamp_rays;
        peak_rays += other.peak_rays;
        emitter_rays += other.emitter_rays;
        return *this;
    }
};

/// Traces one tile after the other, for one thread. Whose light that is, its implementations know: what comes from the
/// sky and from lamps (TileTracer), or from surfaces (GatherTracer).
class TileSampler {
public:
    TileSampler() = default;
    virtual ~TileSampler() = default;
    TileSampler(TileSampler&&) = default;
    TileSampler& operator=(TileSampler&&) = default;
    TileSampler(const TileSampler&) = delete;
    TileSampler& operator=(const TileSampler&) = delete;

    /// From now on another plan, of the same seed and distance limit, which must outlive it.
    virtual void set_plan(const RayPlan& plan) = 0;
    /// Traces a tile, with the parts of its texels' sequences; sampler cosine only. `seen`: what the tile's rays met so
    /// far, to which it adds what these meet; rays are spared whose answer it tells. Null where each ray is to be
    /// traced.
    virtual void sample(const TexelTile& tile, CellVisibility* seen) = 0;
    /// Of a lane of the last tile: Σ weight · L, not yet scaled.
    [[nodiscard]] virtual glm::dvec3 light(std::size_t lane) const = 0;
    /// Of the last tile that was sampled.
    [[nodiscard]] virtual const LaneParts& parts() const = 0;
    /// Of all tiles so far.
    [[nodiscard]] virtual const RayCounts& counts() const = 0;
};

/// One a worker, none null.
using Samplers = std::vector<TileSampler*>;

} // namespace vkbake
