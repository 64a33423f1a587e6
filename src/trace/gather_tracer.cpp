#include "trace/gather_tracer.hpp"

#include <bit>

#include "bvh/each_ray.hpp"

namespace vkbake {

void GatherTracer::sum_up(const TexelTile& tile) {
    m_sums.fill(glm::dvec3(0.0));
    m_rays.begin(tile);
    for (std::size_t number = 0; number < m_plan->block_count(); ++number) {
        const RayBlock& block = m_rays.make(number);
        const BlockedRays met = m_visibility->met(block, m_scratch);
        const RayPlan::Weights weights = m_plan->weights(number);
        for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
            m_counts.rays += static_cast<std::uint64_t>(std::popcount(block.active[stratum]));
            for (unsigned left = met[stratum]; left != 0; left &= left - 1) {
                const auto lane = static_cast<std::size_t>(std::countr_zero(left));
                const Ray ray = ray_of(block, stratum, lane);
                const double weight = weights[stratum] * m_rays.weight(stratum, lane);
                for (const SeenSurface& seen : m_visibility->surfaces(ray, m_scratch)) {
                    m_sums[lane] += weight * (glm::dvec3(seen.share) * glm::dvec3(arriving(lane, ray, seen.hit)));
                }
            }
        }
    }
    if (m_emitters) {
        m_emitters->add(m_rays.lanes(), m_sums);
        m_counts.emitter_rays = m_emitters->rays();
    }
}

glm::vec3 GatherTracer::arriving(std::size_t lane, const Ray& ray, const Hit& hit) const {
    return m_emitters ? m_emitters->arriving(*m_light, m_rays.lanes(), lane, ray, hit) : m_light->along(ray, hit);
}

} // namespace vkbake
