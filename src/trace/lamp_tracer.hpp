// The light that a tile's texels get from lamps.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "trace/directions.hpp"
#include "trace/lamp_set.hpp"
#include "trace/lane_harmonics.hpp"
#include "trace/lane_parts.hpp"
#include "trace/tile_lanes.hpp"
#include "trace/tile_rays.hpp"
#include "trace/visibility.hpp"

namespace vkbake {

/// For one thread; allocates nothing after it is made.
///
/// A hard lamp is asked for by one ray a texel: its light has no noise. A soft one is seen from the texel as a disc of
/// directions, whose points are the samples of a plan (as many as the sky's, from scrambles of their own), scaled: so
/// they are stratified over the disc as the sky's over the hemisphere's, and what is said of a sample's parts and their
/// error (contrasts.hpp) holds for both together. Of a disc of sine s about the direction w, a uniform point (x, y)
/// stands for ω = x u + y v + √(1 − x² − y²) w; with the density that this has, E is the mean over the points of
/// (n · ω) / (w · ω) times what a hard lamp at w would give if it were faced: for a sphere that is wholly above the
/// horizon, the point's inverse-square law.
///
/// Rays go to the near side of the sphere, so a body inside it hides nothing, and end a little before (lamp_gap), so
/// neither does a surface that the lamp lies in.
class LampTracer {
public:
    /// Both must outlive it.
    LampTracer(const LampSet& lamps, const Visibility& visibility);

    /// From now on the samples of this plan, which must outlive it.
    void set_plan(const RayPlan& plan);
    /// Sums up for a tile's lanes; where `parts` is not null, also the parts of the soft lamps' samples.
    void sum_up(const TileLanes& lanes, LaneParts* parts);
    /// Adds their radiance for a tile's lanes, whatever its angle to their surface: π / samples() times what is added
    /// is ∫ L Y. With Horizon::none the lanes' normals mean nothing.
    void add_harmonics(const TileLanes& lanes, Horizon horizon, LaneHarmonics& harmonics);
    /// Of the last tile that was summed up, in the unit of RayPlan's sums: scale() times it is E/π.
    [[nodiscard]] const glm::dvec3& sum(std::size_t lane) const { return m_sums[lane]; }

    [[nodiscard]] std::uint64_t rays() const { return m_ray_count; } ///< traced so far
    /// For each of the lamps that the set was made from: the rays so far that reached it.
    [[nodiscard]] const std::vector<std::uint64_t>& reached() const { return m_reached; }

private:
    using Row = RayBlock::LaneRow;
    using Rows = std::array<Row, 3>;

    /// A soft lamp as the lanes see it.
    struct Disc {
        alignas(64) Rows tangent{};
        alignas(64) Rows bitangent{};
        alignas(64) Rows centre{};                      ///< direction
        alignas(64) Rows shading{};                     ///< the shading normal in these three
        alignas(64) Rows geometric{};                   ///< the geometric normal in these three
        alignas(64) Row sine{};                         ///< of its half width
        alignas(64) Row distance{};                     ///< of its centre
        std::array<double, RayBlock::lanes> strength{}; ///< without its colour: attenuation / d²
        RayBlock::LaneBits lit = 0;                     ///< lanes that are in range and cone
    };

    /// What there is to do for the lanes, into m_sums and `parts`, or into m_harmonics.
    void trace(const TileLanes& lanes, LaneParts* parts);
    void trace_hard(const TileLanes& lanes);
    /// The rays of up to 16 hard lamps, a stratum each.
    void trace_hard(const TileLanes& lanes, std::size_t first, std::size_t count);
    void see(const ReadyLamp& lamp, const TileLanes& lanes, Disc& disc) const;
    void see_lane(const ReadyLamp& lamp, const TileLanes& lanes, std::size_t lane, Disc& disc) const;
    /// The rays of a block of samples towards a soft lamp, their weights, and which need no tracing.
    void aim(const ReadyLamp& lamp, const Disc& disc);
    void trace_soft(const ReadyLamp& lamp, const Disc& disc, LaneParts* parts);
    /// Adds one of the block's open rays to the harmonics.
    void add_soft(const ReadyLamp& lamp, const Disc& disc, std::size_t stratum, std::size_t lane);

    const LampSet* m_lamps;         ///< never null
    const Visibility* m_visibility; ///< never null
    const RayPlan* m_plan = nullptr;
    const CosineStrata* m_strata = nullptr;
    std::optional<CosineStrata> m_own_strata; ///< where the plan has none
    VisibilityScratch m_scratch;
    TileLanes m_points_lanes; ///< +Z up, keys of their own
    StratumTables m_tables;
    RayBlock m_points; ///< a block of samples as directions about +Z
    SampleIndices m_indices;
    std::vector<Disc> m_discs; ///< of the soft lamps
    RayBlock m_block;
    std::array<Row, RayBlock::strata> m_weights{};
    BlockedRays m_beside{}; ///< samples that lie inside the lamp's sphere
    std::array<glm::dvec3, RayBlock::lanes> m_sums{};
    Horizon m_horizon = Horizon::surface;
    LaneHarmonics* m_harmonics = nullptr; ///< while they are asked for
    std::uint64_t m_ray_count = 0;
    std::vector<std::uint64_t> m_reached;
};

} // namespace vkbake
