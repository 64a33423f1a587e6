#include "trace/peak_tracer.hpp"

#include <bit>
#include <variant>

#include <glm/geometric.hpp>

#include "base/luminance.hpp"

namespace vkbake {

PeakTracer::PeakTracer(const SkyPeaks& peaks, const Visibility& visibility)
    : m_peaks(&peaks), m_visibility(&visibility), m_scratch(visibility.make_scratch()) {}

void PeakTracer::set_plan(const RayPlan& plan) {
    m_plan = &plan;
    m_strata = &std::get<CosineStrata>(plan.directions());
}

void PeakTracer::sum_up(const TileLanes& lanes, LaneParts* parts) {
    m_sums.fill(glm::dvec3(0.0));
    trace(lanes, parts);
    if (parts != nullptr) {
        for (std::size_t lane = 0; lane < m_sums.size(); ++lane) {
            parts->of_lights[lane] += luminance(m_sums[lane]);
        }
    }
}

void PeakTracer::add_harmonics(const TileLanes& lanes, Horizon horizon, LaneHarmonics& harmonics) {
    m_horizon = horizon;
    m_harmonics = &harmonics;
    trace(lanes, nullptr);
    m_horizon = Horizon::surface;
    m_harmonics = nullptr;
}

void PeakTracer::trace(const TileLanes& lanes, LaneParts* parts) {
    constexpr std::uint64_t of_peaks = 0x7065616B; // scrambles that neither the sky's samples nor the lamps' have
    m_block.origin = lanes.origin;
    m_block.ignored_triangle = lanes.triangle;
    m_own_lanes.scrambles = lanes.scrambles.salted(of_peaks);
    m_own_lanes.covered = lanes.covered;
    invert_scrambles(*m_strata, m_own_lanes, m_tables);
    for (std::size_t number = 0; number < m_strata->block_count(); ++number) {
        set_points(*m_strata, m_tables, m_own_lanes, number, m_block, &m_indices);
        aim(lanes);
        trace_block(parts);
    }
}

void PeakTracer::aim(const TileLanes& lanes) {
    set_peak_directions(*m_peaks, m_block, m_samples);
    for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
        const TileLanes::Rows& direction = m_block.direction[stratum];
        auto& [red, green, blue] = m_samples.light[stratum];
        unsigned faced = 0;
        for (std::size_t lane = 0; lane < RayBlock::lanes; ++lane) {
            const auto along = [&](const TileLanes::Rows& rows) {
                return direction[0][lane] * rows[0][lane] + direction[1][lane] * rows[1][lane] +
                       direction[2][lane] * rows[2][lane];
            };
            const float cosine = along(lanes.normal);
            const bool faces = m_horizon == Horizon::none || (cosine > 0.0F && along(lanes.geometric_normal) > 0.0F);
            faced |= static_cast<unsigned>(faces) << lane;
            const float factor = m_harmonics != nullptr ? 1.0F : cosine;
            red[lane] *= factor;
            green[lane] *= factor;
            blue[lane] *= factor;
        }
        m_block.active[stratum] = static_cast<RayBlock::LaneBits>(m_block.active[stratum] & faced);
    }
}

void PeakTracer::trace_block(LaneParts* parts) {
    const BlockedRays blocked = m_visibility->blocked(m_block, m_scratch);
    const unsigned shift = parts != nullptr ? part_shift(m_plan->samples()) : 0;
    for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
        m_ray_count += static_cast<std::uint64_t>(std::popcount(m_block.active[stratum]));
        const unsigned open = m_block.active[stratum] & ~static_cast<unsigned>(blocked[stratum]);
        for (unsigned left = open; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            const auto& [red, green, blue] = m_samples.light[stratum];
            const glm::dvec3 light =
                glm::dvec3(m_scratch.transmittance(stratum, lane)) * glm::dvec3(red[lane], green[lane], blue[lane]);
            if (m_harmonics != nullptr) {
                const auto& [x, y, z] = m_block.direction[stratum];
                m_harmonics->add(lane, {x[lane], y[lane], z[lane]}, light);
                continue;
            }
            m_sums[lane] += light;
            if (parts != nullptr) {
                parts->add(lane, m_indices.of[stratum][lane], shift, luminance(light));
            }
        }
    }
}

} // namespace vkbake
