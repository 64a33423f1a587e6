// The rays of a tile, block after block.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <variant>

#include "bvh/ray_block.hpp"
#include "trace/cosine_strata.hpp"
#include "trace/directions.hpp"
#include "trace/random_points.hpp"
#include "trace/texel_tiles.hpp"
#include "trace/thesis_directions.hpp"
#include "trace/tile_lanes.hpp"
#include "vkbake/geometry_image.hpp"
#include "vkbake/settings.hpp"
#include "vkbake/surface.hpp"

namespace vkbake {

/// In which directions every texel looks, and what each counts. The same for all tiles; may be shared by threads.
class RayPlan {
public:
    using Weights = std::array<double, RayBlock::strata>;
    using Directions = std::variant<CosineStrata, RandomPoints, ThesisDirections>;

    /// Of the settings it takes sampler, rays and seed. `max_distance`: bake frame. `first`: the samples below it are
    /// left out; sampler cosine only, as in CosineStrata.
    RayPlan(const Settings& settings, float max_distance, std::uint32_t first = 0);

    [[nodiscard]] const Settings& settings() const { return m_settings; }
    [[nodiscard]] float max_distance() const { return m_max_distance; }
    [[nodiscard]] const Directions& directions() const { return m_directions; }
    /// Blocks a tile.
    [[nodiscard]] std::size_t block_count() const;
    [[nodiscard]] std::uint32_t samples() const; ///< a texel, those left out with them
    [[nodiscard]] std::uint32_t first() const;   ///< so many are left out
    /// The first so many strata all hold a sample; ≥ 1.
    [[nodiscard]] std::uint64_t full_strata() const;
    /// E/π is estimated by scale() · Σ weight · L. With cosine-weighted samples it is the plain mean of L, and a
    /// hemisphere of radiance 1 gives 1.
    [[nodiscard]] double scale() const;
    /// Of one block's strata.
    [[nodiscard]] Weights weights(std::size_t block) const;
    /// Whether each ray has a weight of its own beside its stratum's: TileRays::weight.
    [[nodiscard]] bool weighs_rays() const;

private:
    Settings m_settings;
    float m_max_distance;
    Directions m_directions;
};

/// One tile after the other; for each its blocks of rays in any order. For one thread; allocates nothing after it is
/// made. A ray depends on its texel and on the stratum, and on nothing else: neither on the tile nor on the lane.
///
///     TileRays rays(surface, geometry, plan);
///     for (const TexelTile& tile : make_tiles(geometry, surface.triangle_count())) {
///         rays.begin(tile);
///         for (std::size_t block = 0; block < plan.block_count(); ++block) {
///             const RayBlock& some = rays.make(block);
class TileRays {
public:
    /// All must outlive it.
    TileRays(const Surface& surface, const GeometryImage& geometry, const RayPlan& plan);

    void begin(const TexelTile& tile);
    /// From now on another plan, of the same seed and distance limit, which must outlive it.
    void set_plan(const RayPlan& plan) { m_plan = &plan; }
    /// `block` < plan.block_count(). Holds until the next call. Active are the samples that lie above their texel's
    /// geometric plane. Where `indices` is not null it is filled; sampler cosine only.
    const RayBlock& make(std::size_t block, SampleIndices* indices = nullptr);
    /// The same of some strata, wherever they lie; sampler cosine only.
    const RayBlock& make(const BlockStrata& strata, SampleIndices* indices = nullptr);
    /// Of a ray of the last block, beside its stratum's; 1 unless the plan weighs rays.
    [[nodiscard]] double weight(std::size_t stratum, std::size_t lane) const;
    /// The samples of the last block, those below the plane with them.
    [[nodiscard]] std::uint32_t asked() const { return m_asked; }
    [[nodiscard]] const TileLanes& lanes() const { return m_lanes; }

private:
    const Surface* m_surface;        ///< never null
    const GeometryImage* m_geometry; ///< never null
    const RayPlan* m_plan;           ///< never null
    TileLanes m_lanes;
    StratumTables m_tables;
    RayBlock m_block;
    std::uint32_t m_asked = 0;
};

} // namespace vkbake
