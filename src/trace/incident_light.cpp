#include "trace/incident_light.hpp"

#include <bit>
#include <cstddef>
#include <optional>

#include "bvh/each_ray.hpp"
#include "trace/sky_sum.hpp"

namespace vkbake {

const RadianceRows& IncidentLight::along(const RayBlock& block, const TileLanes& lanes, const EmitterTracer* emitters,
                                         LaneEnds* ends) {
    const BlockedRays blocked = m_visibility->blocked(block, m_scratch);
    BlockedRays open{};
    for (std::size_t stratum = 0; stratum < open.size(); ++stratum) {
        open[stratum] = static_cast<RayBlock::LaneBits>(block.active[stratum] & ~blocked[stratum]);
    }
    look_up_sky(*m_sky, block, open, m_radiance);
    for (auto& rows : m_radiance) {
        for (auto& row : rows) {
            for (float& value : row) {
                value *= m_intensity;
            }
        }
    }
    if (m_visibility->dims()) {
        dim(block);
    }
    if (m_surfaces != nullptr) {
        add_surfaces(block, m_visibility->dims() ? m_visibility->met(block, m_scratch) : blocked, lanes, emitters);
        if (ends != nullptr) {
            count_ends(block, blocked, *ends);
        }
    }
    return m_radiance;
}

void IncidentLight::dim(const RayBlock& block) {
    for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
        for (unsigned left = m_scratch.dimmed()[stratum] & block.active[stratum]; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            const glm::vec3 through = m_scratch.transmittance(stratum, lane);
            for (std::size_t channel = 0; channel < 3; ++channel) {
                m_radiance[stratum][channel][lane] *= through[static_cast<glm::length_t>(channel)];
            }
        }
    }
}

void IncidentLight::add_surfaces(const RayBlock& block, const BlockedRays& met, const TileLanes& lanes,
                                 const EmitterTracer* emitters) {
    for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
        for (unsigned left = met[stratum]; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            const Ray ray = ray_of(block, stratum, lane);
            for (const SeenSurface& seen : m_visibility->surfaces(ray, m_scratch)) {
                const glm::vec3 light =
                    seen.share * (emitters != nullptr ? emitters->arriving(*m_surfaces, lanes, lane, ray, seen.hit).all
                                                      : m_surfaces->along(ray, seen.hit));
                for (std::size_t channel = 0; channel < 3; ++channel) {
                    m_radiance[stratum][channel][lane] += light[static_cast<glm::length_t>(channel)];
                }
            }
        }
    }
}

void IncidentLight::count_ends(const RayBlock& block, const BlockedRays& blocked, LaneEnds& ends) {
    for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
        for (unsigned left = block.active[stratum]; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            ++ends.rays[lane];
            if ((blocked[stratum] >> lane & 1U) != 0) {
                const std::optional<Hit> hit = m_visibility->nearest(ray_of(block, stratum, lane), m_scratch);
                ends.back_sides[lane] += hit && !m_surfaces->shows(*hit) ? 1 : 0;
            }
        }
    }
}

} // namespace vkbake
