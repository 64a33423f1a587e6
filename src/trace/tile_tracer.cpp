#include "trace/tile_tracer.hpp"

#include <bit>
#include <limits>
#include <optional>

#include "base/random.hpp"
#include "bvh/each_ray.hpp"

namespace vkbake {

namespace {

constexpr std::uint64_t no_probe = std::numeric_limits<std::uint64_t>::max();

std::uint64_t ray_count(const BlockedRays& rays) {
    int count = 0;
    for (const RayBlock::LaneBits bits : rays) {
        count += std::popcount(bits);
    }
    return static_cast<std::uint64_t>(count);
}

} // namespace

TileTracer::TileTracer(const Surface& surface, const GeometryImage& geometry, const RayPlan& plan, const SkyLookup& sky,
                       const TriangleAccelerator& accelerator, const LampSet* lamps)
    : m_plan(&plan), m_sky(&sky), m_accelerator(&accelerator), m_rays(surface, geometry, plan),
      m_scratch(accelerator.make_scratch()) {
    if (lamps != nullptr) {
        m_lamps.emplace(*lamps, accelerator);
        m_lamps->set_plan(plan);
    }
}

void TileTracer::sum_up(const TexelTile& tile) {
    m_sums = {};
    m_rays.begin(tile);
    choose_probes();
    for (std::size_t number = 0; number < m_plan->block_count(); ++number) {
        const RayBlock& block = m_rays.make(number, m_with_parts ? &m_indices : nullptr);
        const BlockedRays blocked = m_accelerator->blocked(block, m_scratch);
        const std::uint64_t rays = ray_count(block.active);
        m_counts.rays += rays;
        m_counts.skipped_directions += m_rays.asked() - rays;
        m_counts.occluded_rays += ray_count(blocked);
        BlockedRays open{};
        for (std::size_t stratum = 0; stratum < open.size(); ++stratum) {
            open[stratum] = static_cast<RayBlock::LaneBits>(block.active[stratum] & ~blocked[stratum]);
        }
        add_sky(*m_sky, block, open, m_plan->weights(number), m_sums, m_with_parts ? &m_luminance : nullptr);
        if (m_with_parts) {
            add_parts(open, blocked);
        }
        probe(number, block, blocked);
    }
    if (m_lamps) {
        m_lamps->sum_up(m_rays.lanes(), m_with_parts ? &m_parts : nullptr);
        m_counts.lamp_rays = m_lamps->rays();
    }
}

void TileTracer::add_parts(const BlockedRays& open, const BlockedRays& blocked) {
    const unsigned shift = part_shift(m_plan->samples());
    const double scale = luminance_scale(*m_sky);
    for (std::size_t stratum = 0; stratum < open.size(); ++stratum) {
        for (unsigned bits = open[stratum]; bits != 0; bits &= bits - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
            const std::uint32_t part = m_indices.of[stratum][lane] >> shift;
            if (part < part_count) { // those beyond a power of two belong to none
                m_parts.luminance[part][lane] += scale * static_cast<double>(m_luminance[stratum][lane]);
            }
            ++m_parts.open[lane];
        }
        for (unsigned bits = blocked[stratum]; bits != 0; bits &= bits - 1) {
            ++m_parts.blocked[static_cast<std::size_t>(std::countr_zero(bits))];
        }
    }
}

void TileTracer::choose_probes() {
    for (std::size_t lane = 0; lane < m_probes.size(); ++lane) {
        if (m_plan->first() > 0) { // chosen, and looked at, when the texel had its first rays
            m_probes[lane] = no_probe;
            continue;
        }
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
