// The light that a tile's texels get from surfaces.
#pragma once

#include <array>
#include <optional>

#include <glm/vec3.hpp>

#include "trace/emitter_tracer.hpp"
#include "trace/surface_light.hpp"
#include "trace/tile_rays.hpp"
#include "trace/tile_sampler.hpp"
#include "trace/visibility.hpp"

namespace vkbake {

/// As TileTracer, for light that comes from where rays end in place of where they end nowhere. Which rays meet
/// something is asked in blocks; what they see of it, of those alone, ray by ray.
class GatherTracer final : public TileSampler {
public:
    /// All must outlive it. `emitters`: of the same light, to be sought; null where there are none.
    GatherTracer(const Surface& surface, const GeometryImage& geometry, const RayPlan& plan, const SurfaceLight& light,
                 const Visibility& visibility, const EmitterSet* emitters)
        : m_plan(&plan), m_light(&light), m_visibility(&visibility), m_rays(surface, geometry, plan),
          m_scratch(visibility.make_scratch()) {
        if (emitters != nullptr) {
            m_emitters.emplace(*emitters, plan, RaySpread::cosine, visibility);
        }
    }

    /// Calls store(texel, sum) for each texel of the tile: Σ weight · L, not yet scaled.
    template<typename Store>
    void trace(const TexelTile& tile, const Store& store) {
        sum_up(tile);
        for (std::uint32_t lane = 0; lane < tile.count; ++lane) {
            store(tile.texels[lane], m_sums[lane]);
        }
    }

    void set_plan(const RayPlan& plan) override;
    /// Spares no rays: where they end is not what their neighbours tell.
    void sample(const TexelTile& tile, CellVisibility* seen) override;
    [[nodiscard]] glm::dvec3 light(std::size_t lane) const override { return m_sums[lane]; }
    /// All rays count as blocked: where each brings light no bound is needed, as surfaces differ. Where none does, some
    /// might.
    [[nodiscard]] const LaneParts& parts() const override { return m_parts; }
    /// It has no probes.
    [[nodiscard]] const RayCounts& counts() const override { return m_counts; }

private:
    void sum_up(const TexelTile& tile);
    /// Adds a sample's light, and what of it is from emitters, to the part it belongs to.
    void add_to_part(std::size_t stratum, std::size_t lane, double light, double sought);
    /// What arrives along a ray that met a surface, less what rays that seek emitters bring of it.
    [[nodiscard]] ArrivingLight arriving(std::size_t lane, const Ray& ray, const Hit& hit) const;

    const RayPlan* m_plan;          ///< never null
    const SurfaceLight* m_light;    ///< never null
    const Visibility* m_visibility; ///< never null
    TileRays m_rays;
    VisibilityScratch m_scratch;
    std::optional<EmitterTracer> m_emitters;
    std::array<glm::dvec3, RayBlock::lanes> m_sums{};
    bool m_with_parts = false;
    LaneParts m_parts;
    SampleIndices m_indices;
    RayCounts m_counts;
};

} // namespace vkbake
