#include "trace/tile_tracer.hpp"

#include <bit>
#include <optional>

#include "base/random.hpp"
#include "bvh/each_ray.hpp"

namespace vkbake {

namespace {

std::uint64_t ray_count(const BlockedRays& rays) {
    int count = 0;
    for (const RayBlock::LaneBits bits : rays) {
        count += std::popcount(bits);
    }
    return static_cast<std::uint64_t>(count);
}

} // namespace

TileTracer::TileTracer(const Surface& surface, const GeometryImage& geometry, const RayPlan& plan, const SkyLookup& sky,
                       const TriangleAccelerator& accelerator)
    : m_plan(&plan), m_sky(&sky), m_accelerator(&accelerator), m_rays(surface, geometry, plan),
      m_scratch(accelerator.make_scratch()) {}

void TileTracer::sum_up(const TexelTile& tile) {
    m_sums = {};
    m_rays.begin(tile);
    choose_probes();
    for (std::size_t number = 0; number < m_plan->block_count(); ++number) {
        const RayBlock& block = m_rays.make(number);
        const BlockedRays blocked = m_accelerator->blocked(block, m_scratch);
        const std::uint64_t rays = ray_count(block.active);
        m_counts.rays += rays;
        m_counts.skipped_directions += m_rays.asked() - rays;
        m_counts.occluded_rays += ray_count(blocked);
        BlockedRays open{};
        for (std::size_t stratum = 0; stratum < open.size(); ++stratum) {
            open[stratum] = static_cast<RayBlock::LaneBits>(block.active[stratum] & ~blocked[stratum]);
        }
        add_sky(*m_sky, block, open, m_plan->weights(number), m_sums);
        probe(number, block, blocked);
    }
}

void TileTracer::choose_probes() {
    for (std::size_t lane = 0; lane < m_probes.size(); ++lane) {
        // The key's own halves seed the scrambles.
        const std::uint64_t random = mix64(m_rays.lanes().key[lane]) >> 32U;
        m_probes[lane] = random * m_plan->full_strata() >> 32U;
    }
}

void TileTracer::probe(std::size_t number, const RayBlock& block, const BlockedRays& blocked) {
    for (std::size_t lane = 0; lane < m_probes.size(); ++lane) {
        const std::size_t stratum = m_probes[lane] % RayBlock::strata;
        if (m_probes[lane] / RayBlock::strata != number || ((blocked[stratum] >> lane) & 1U) == 0) {
            continue;
        }
        const std::optional<Hit> hit = m_accelerator->nearest(ray_of(block, stratum, lane));
        if (hit) {
            ++m_counts.probed_hits;
            m_counts.back_side_hits += hit->back_side ? 1 : 0;
        }
    }
}

} // namespace vkbake
