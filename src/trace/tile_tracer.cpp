#include "trace/tile_tracer.hpp"

#include <bit>
#include <limits>
#include <optional>
#include <variant>

#include "base/luminance.hpp"
#include "bvh/each_ray.hpp"
#include "trace/spared_strata.hpp"

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

BlockedRays joined(BlockedRays rays, const BlockedRays& others) {
    for (std::size_t stratum = 0; stratum < rays.size(); ++stratum) {
        rays[stratum] |= others[stratum];
    }
    return rays;
}

/// Of samples of one texel that count alike.
RayPlan::Weights even_weights() {
    RayPlan::Weights weights{};
    weights.fill(1.0);
    return weights;
}

} // namespace

TileTracer::TileTracer(const Surface& surface, const GeometryImage& geometry, const RayPlan& plan, const SkyLookup& sky,
                       const Visibility& visibility, const LightSources& sources)
    : m_plan(&plan), m_sky(&sky), m_visibility(&visibility), m_rays(surface, geometry, plan),
      m_scratch(visibility.make_scratch()) {
    if (sources.lamps != nullptr) {
        m_lamps.emplace(*sources.lamps, visibility);
    }
    if (sources.peaks != nullptr) {
        m_peaks.emplace(*sources.peaks, visibility);
    }
    plan_for_sources();
}

void TileTracer::set_plan(const RayPlan& plan) {
    m_plan = &plan;
    m_rays.set_plan(plan);
    plan_for_sources();
}

void TileTracer::plan_for_sources() {
    if (m_lamps) {
        m_lamps->set_plan(*m_plan);
    }
    if (m_peaks) {
        m_peaks->set_plan(*m_plan);
    }
}

void TileTracer::sample(const TexelTile& tile, CellVisibility* seen) {
    m_parts = {};
    m_with_parts = true;
    sum_up(tile, seen);
    m_with_parts = false;
}

glm::dvec3 TileTracer::light(std::size_t lane) const {
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

void TileTracer::sum_up(const TexelTile& tile, CellVisibility* seen) {
    m_sums = {};
    m_dimmed = {};
    m_directions = {};
    m_traced_blocks = 0;
    m_rays.begin(tile);
    choose_probes();
    if (seen != nullptr) {
        trace_unknown(*std::get_if<CosineStrata>(&m_plan->directions()), *seen);
    } else {
        for (std::size_t number = 0; number < m_plan->block_count(); ++number) {
            trace_block(number, m_rays.make(number, m_with_parts ? &m_indices : nullptr), m_plan->weights(number));
        }
    }
    if (m_peaks) {
        m_peaks->sum_up(m_rays.lanes(), m_with_parts ? &m_parts : nullptr);
        m_counts.peak_rays = m_peaks->rays();
    }
    if (m_lamps) {
        m_lamps->sum_up(m_rays.lanes(), m_with_parts ? &m_parts : nullptr);
        m_counts.lamp_rays = m_lamps->rays();
    }
}

void TileTracer::trace_unknown(const CosineStrata& strata, CellVisibility& seen) {
    using Answer = KnownCells::Answer;
    const RayCounts before = m_counts;
    const auto texels = static_cast<std::uint32_t>(std::popcount(m_rays.lanes().covered));
    const SparedStrata parted(strata, seen, texels, m_rays.lanes().scrambles.random(0));
    bool holds = true;
    parted.each_checked(Answer::open, [&](const BlockStrata& some) {
        holds = ray_count(trace_strata(some, seen).something) == 0 && holds;
    });
    parted.each_checked(Answer::blocked, [&](const BlockStrata& some) {
        holds = ray_count(trace_strata(some, seen).nothing) == 0 && holds;
    });
    if (holds) {
        parted.each_unknown([&](const BlockStrata& some) { trace_strata(some, seen); });
        parted.each_spared(Answer::open, [&](const BlockStrata& some) { add_open(m_rays.make(some, &m_indices)); });
        parted.known().mark(seen);
    } else { // whatever else is thought to be known may be as wrong
        parted.each_unchecked([&](const BlockStrata& some) { trace_strata(some, seen); });
    }
    m_counts.spared_rays += std::uint64_t{texels} * (strata.rays() - strata.first()) - (m_counts.rays - before.rays) -
                            (m_counts.skipped_directions - before.skipped_directions);
}

TileTracer::Met TileTracer::trace_strata(const BlockStrata& strata, CellVisibility& seen) {
    const Met met = trace_block(m_traced_blocks++, m_rays.make(strata, &m_indices), even_weights());
    remember(met, seen);
    return met;
}

TileTracer::Met TileTracer::trace_block(std::size_t number, const RayBlock& block, const RayPlan::Weights& weights) {
    const BlockedRays blocked = m_visibility->blocked(block, m_scratch);
    const std::uint64_t rays = ray_count(block.active);
    m_counts.rays += rays;
    m_counts.skipped_directions += m_rays.asked() - rays;
    BlockedRays open{};
    for (std::size_t stratum = 0; stratum < open.size(); ++stratum) {
        open[stratum] = static_cast<RayBlock::LaneBits>(block.active[stratum] & ~blocked[stratum]);
    }
    Met met{open, blocked};
    if (m_visibility->dims()) {
        met.something = joined(blocked, m_scratch.dimmed());
        add_dimmed(block, weights, open);
    }
    const BlockedRays stopped = m_visibility->fades() ? joined(blocked, m_scratch.dimmed()) : blocked;
    m_counts.occluded_rays += ray_count(stopped);
    if (m_plan->weighs_rays()) {
        add_weighted(block, open);
    }
    add_sky(*m_sky, block, open, weights, m_sums, m_with_parts ? &m_luminance : nullptr);
    if (m_with_parts) {
        add_parts(open, blocked);
    }
    if (m_plan->settings().mode == Mode::bent_normal) {
        add_directions(block, weights, blocked);
    }
    probe(number, block, stopped);
    return met;
}

void TileTracer::remember(const Met& met, CellVisibility& seen) const {
    for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
        const unsigned nothing = met.nothing[stratum];
        const unsigned something = met.something[stratum];
        for (unsigned bits = nothing | something; bits != 0; bits &= bits - 1) {
            const auto lane = static_cast<unsigned>(std::countr_zero(bits));
            const std::uint32_t column = m_indices.column[stratum][lane];
            seen.add(m_indices.row[stratum][lane], (nothing >> lane & 1U) << column,
                     (something >> lane & 1U) << column);
        }
    }
}

void TileTracer::add_open(const RayBlock& block) {
    m_counts.skipped_directions += m_rays.asked() - ray_count(block.active);
    add_sky(*m_sky, block, block.active, even_weights(), m_sums, m_with_parts ? &m_luminance : nullptr);
    if (m_with_parts) {
        add_parts(block.active, {});
    }
}

void TileTracer::add_dimmed(const RayBlock& block, const RayPlan::Weights& weights, BlockedRays& open) {
    m_counts.filtered_rays = m_scratch.filtered_rays();
    const bool grey = m_plan->settings().mode != Mode::irradiance;
    for (std::size_t stratum = 0; stratum < open.size(); ++stratum) {
        const RayBlock::LaneBits dimmed = m_scratch.dimmed()[stratum];
        open[stratum] = static_cast<RayBlock::LaneBits>(open[stratum] & ~dimmed);
        for (unsigned bits = dimmed; bits != 0; bits &= bits - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
            const auto through = glm::dvec3(m_scratch.transmittance(stratum, lane));
            const glm::dvec3 light =
                grey ? glm::dvec3(luminance(through))
                     : through * glm::dvec3(radiance(*m_sky, ray_of(block, stratum, lane).direction));
            m_dimmed[lane] += weights[stratum] * m_rays.weight(stratum, lane) * light;
            if (m_with_parts) {
                add_to_part(stratum, lane, part_shift(m_plan->samples()), luminance(light));
            }
        }
    }
}

void TileTracer::add_weighted(const RayBlock& block, BlockedRays& open) {
    for (std::size_t stratum = 0; stratum < open.size(); ++stratum) {
        for (unsigned bits = open[stratum]; bits != 0; bits &= bits - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
            const glm::dvec3 light(radiance(*m_sky, ray_of(block, stratum, lane).direction));
            m_dimmed[lane] += m_rays.weight(stratum, lane) * light;
        }
        open[stratum] = 0;
    }
}

void TileTracer::add_directions(const RayBlock& block, const RayPlan::Weights& weights, const BlockedRays& blocked) {
    for (std::size_t stratum = 0; stratum < blocked.size(); ++stratum) {
        const auto& [x, y, z] = block.direction[stratum];
        for (unsigned bits = block.active[stratum] & ~static_cast<unsigned>(blocked[stratum]); bits != 0;
             bits &= bits - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
            const double through = luminance(glm::dvec3(m_scratch.transmittance(stratum, lane)));
            m_directions[lane] +=
                weights[stratum] * m_rays.weight(stratum, lane) * through * glm::dvec3(x[lane], y[lane], z[lane]);
        }
    }
}

glm::dvec3 TileTracer::bent_normal(std::size_t lane, double visibility) const {
    const double length = glm::length(m_directions[lane]);
    return length > 0.0 ? visibility / length * m_directions[lane] : glm::dvec3(0.0);
}

void TileTracer::add_to_part(std::size_t stratum, std::size_t lane, unsigned shift, double luminance) {
    m_parts.add(lane, m_indices.of[stratum][lane], shift, luminance);
    ++m_parts.open[lane];
}

void TileTracer::add_parts(const BlockedRays& open, const BlockedRays& blocked) {
    const double scale = luminance_scale(*m_sky);
    const unsigned shift = part_shift(m_plan->samples());
    for (std::size_t stratum = 0; stratum < open.size(); ++stratum) {
        for (unsigned bits = open[stratum]; bits != 0; bits &= bits - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
            add_to_part(stratum, lane, shift, scale * static_cast<double>(m_luminance[stratum][lane]));
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
        const std::uint64_t random = m_rays.lanes().scrambles.random(lane) >> 32U;
        m_probes[lane] = random * m_plan->full_strata() >> 32U;
    }
}

void TileTracer::probe(std::size_t number, const RayBlock& block, const BlockedRays& blocked) {
    for (std::size_t lane = 0; lane < m_probes.size(); ++lane) {
        const std::size_t stratum = m_probes[lane] % RayBlock::strata;
        if (m_probes[lane] / RayBlock::strata != number || ((blocked[stratum] >> lane) & 1U) == 0) {
            continue;
        }
        const std::optional<Hit> hit = m_visibility->nearest(ray_of(block, stratum, lane), m_scratch);
        if (hit) {
            ++m_counts.probed_hits;
            m_counts.back_side_hits += hit->back_side ? 1 : 0;
        }
    }
}

} // namespace vkbake
