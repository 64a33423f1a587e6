#include "trace/gather_tracer.hpp"

#include <bit>
#include <optional>

#include "bvh/each_ray.hpp"

namespace vkbake {

void GatherTracer::sum_up(const TexelTile& tile) {
    m_sums.fill(glm::dvec3(0.0));
    m_rays.begin(tile);
    for (std::size_t number = 0; number < m_plan->block_count(); ++number) {
        const RayBlock& block = m_rays.make(number);
        const BlockedRays blocked = m_accelerator->blocked(block, m_scratch);
        const RayPlan::Weights weights = m_plan->weights(number);
        for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
            m_counts.rays += static_cast<std::uint64_t>(std::popcount(block.active[stratum]));
            for (unsigned left = blocked[stratum]; left != 0; left &= left - 1) {
                const auto lane = static_cast<std::size_t>(std::countr_zero(left));
                const Ray ray = ray_of(block, stratum, lane);
                if (const std::optional<Hit> hit = m_accelerator->nearest(ray)) {
                    m_sums[lane] += weights[stratum] * glm::dvec3(m_light->along(ray, *hit));
                }
            }
        }
    }
}

} // namespace vkbake
