// A map whose texels know how well they are known.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "trace/cell_visibility.hpp"
#include "trace/contrasts.hpp"
#include "trace/known_light.hpp"
#include "trace/texel_tiles.hpp"
#include "trace/tile_sampler.hpp"
#include "vkbake/lightmap.hpp"
#include "vkbake/settings.hpp"

namespace vkbake {

/// The error of a whole map, of what was sampled so far.
struct MapEstimate {
    KnownLight sampled;
    KnownLight before;  ///< of other light, which is added to what is sampled
    double ratio = 0.0; ///< FallOfVariance::ratio

    /// Of both.
    [[nodiscard]] double mean() const { return before.mean + sampled.mean; }
    /// Root of the mean square error over the mean, of both; 0 where there is no error.
    [[nodiscard]] double relative_rmse() const;
};

/// Which tile gets samples up to how many.
struct TileOrder {
    std::uint32_t tile = 0;
    std::uint32_t rays = 0; ///< a texel, more than it has
};

/// The samples of all texels of a map, tile by tile: those of a tile have the same number. Values and estimates depend
/// on those numbers alone, and not on the steps in which they were reached, but for the rounding of sums; where
/// visibility is reused each step spares what those before it tell.
class SampledMap {
public:
    /// The tiles must outlive it. `intensity` multiplies all that is seen. `settings`: sampler cosine. `before`: what
    /// the texels have already, to which the samples are added: errors are relative to both together.
    SampledMap(std::span<const TexelTile> tiles, const Settings& settings, float max_distance, double intensity,
               const KnownLight& before = {});

    /// Traces what is ordered: a power of two, ≥ 16 rays, in all steps of a tile but the last. Returns how many orders
    /// were carried out: all, unless `report` (as of TileLoop) returned false.
    std::size_t extend(std::span<const TileOrder> orders, const Samplers& samplers,
                       const std::function<bool(std::size_t done)>& report);

    [[nodiscard]] std::span<const TexelTile> tiles() const { return m_tiles; }
    [[nodiscard]] std::size_t texel_count() const { return m_records.size(); }
    [[nodiscard]] std::uint32_t rays(std::size_t tile) const { return m_rays[tile]; } ///< a texel
    /// Of a tile's next samples, those that take a ray if nothing contradicts: 1 unless visibility is reused.
    [[nodiscard]] double traced_share(std::size_t tile) const { return m_sums[tile].traced_share; }

    [[nodiscard]] MapEstimate estimate() const;
    /// Σ σ² over a tile's texels, luminance.
    [[nodiscard]] double tile_variance(std::size_t tile, double ratio) const;
    /// Sets colours, coverage, rays and standard errors of the texels, all of the samples alone, and the error of the
    /// map, in which relative_rmse is of all light.
    void write_to(LightMap& map) const;
    /// σ² of each of `texels` texels' luminance as its samples show it, brought to the sum that estimate() has; 0 where
    /// not baked.
    [[nodiscard]] std::vector<float> variances(std::size_t texels) const;

private:
    struct Record {
        glm::dvec3 sum{0.0};
        double of_lights = 0.0; ///< luminance in `sum`, as LaneParts has it
        std::array<float, part_count> parts{};
        std::uint32_t open = 0;
        std::uint32_t blocked = 0;
    };

    /// Of a tile: sums over its texels, to which all estimates of the map are linear. So deciding what to trace next
    /// takes a sixteenth of the work, and this is kept by whoever traced the tile.
    struct TileSums {
        double luminance = 0.0; ///< of the means
        Contrasts contrasts;
        double traced_share = 1.0;
    };

    /// Adds what a worker has just traced.
    void add(std::size_t slot, std::size_t lane, const glm::dvec3& sum, const LaneParts& parts, std::uint32_t had,
             std::uint32_t has);
    [[nodiscard]] TileSums sums_of(std::size_t tile) const;
    /// Calls visit(texel, record, rays) in the tiles' order.
    template<typename Visit>
    void each_texel(const Visit& visit) const;
    /// That the sky's own rays bring to any texel.
    [[nodiscard]] double greatest_luminance() const;
    [[nodiscard]] double standard_error(const Record& record, std::uint32_t rays, double ratio, double greatest) const;

    std::span<const TexelTile> m_tiles;
    Settings m_settings;
    float m_max_distance;
    double m_intensity;
    KnownLight m_before;
    std::vector<std::uint32_t> m_first_slot; ///< of each tile, in m_records
    std::vector<std::uint32_t> m_rays;       ///< of each tile
    std::vector<TileSums> m_sums;            ///< of each tile
    std::vector<Record> m_records;
    std::vector<CellVisibility> m_seen; ///< of each tile, where visibility is reused; else empty
};

} // namespace vkbake
