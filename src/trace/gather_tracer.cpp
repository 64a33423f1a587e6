#include "trace/gather_tracer.hpp"

#include <bit>

#include "base/luminance.hpp"
#include "bvh/each_ray.hpp"

namespace vkbake {

void GatherTracer::set_plan(const RayPlan& plan) {
    m_plan = &plan;
    m_rays.set_plan(plan);
    if (m_emitters) {
        m_emitters->set_plan(plan);
    }
}

void GatherTracer::sample(const TexelTile& tile, CellVisibility* /*seen*/) {
    m_parts = {};
    m_parts.blocked.fill(m_plan->samples());
    m_with_parts = true;
    sum_up(tile);
    m_with_parts = false;
}

void GatherTracer::sum_up(const TexelTile& tile) {
    m_sums.fill(glm::dvec3(0.0));
    m_rays.begin(tile);
    for (std::size_t number = 0; number < m_plan->block_count(); ++number) {
        const RayBlock& block = m_rays.make(number, m_with_parts ? &m_indices : nullptr);
        const BlockedRays met = m_visibility->met(block, m_scratch);
        const RayPlan::Weights weights = m_plan->weights(number);
        for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
            m_counts.rays += static_cast<std::uint64_t>(std::popcount(block.active[stratum]));
            for (unsigned left = met[stratum]; left != 0; left &= left - 1) {
                const auto lane = static_cast<std::size_t>(std::countr_zero(left));
                const Ray ray = ray_of(block, stratum, lane);
                const double weight = weights[stratum] * m_rays.weight(stratum, lane);
                glm::dvec3 light(0.0);
                glm::dvec3 sought(0.0);
                for (const SeenSurface& seen : m_visibility->surfaces(ray, m_scratch)) {
                    const ArrivingLight some = arriving(lane, ray, seen.hit);
                    light += glm::dvec3(seen.share) * glm::dvec3(some.all);
                    sought += glm::dvec3(seen.share) * glm::dvec3(some.sought);
                }
                m_sums[lane] += weight * light;
                if (m_with_parts) {
                    add_to_part(stratum, lane, luminance(light), luminance(sought));
                }
            }
        }
    }
    if (m_emitters) {
        m_emitters->add(m_rays.lanes(), m_sums, m_with_parts ? &m_parts : nullptr);
        m_counts.emitter_rays = m_emitters->rays();
    }
}

void GatherTracer::add_to_part(std::size_t stratum, std::size_t lane, double light, double sought) {
    m_parts.add(lane, m_indices.of[stratum][lane], part_shift(m_plan->samples()), light);
    m_parts.of_lights[lane] += sought;
    if (light > sought) {
        ++m_parts.open[lane];
    }
}

ArrivingLight GatherTracer::arriving(std::size_t lane, const Ray& ray, const Hit& hit) const {
    return m_emitters ? m_emitters->arriving(*m_light, m_rays.lanes(), lane, ray, hit)
                      : ArrivingLight{.all = m_light->along(ray, hit)};
}

} // namespace vkbake
