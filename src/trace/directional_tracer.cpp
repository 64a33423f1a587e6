#include "trace/directional_tracer.hpp"

#include <bit>
#include <cmath>
#include <numbers>

namespace vkbake {

DirectionalTracer::DirectionalTracer(const TracedScene& scene, const GeometryImage& geometry, const RayPlan& plan,
                                     const SurfaceLight* light, const EmitterSet* emitters)
    : m_plan(&plan), m_intensity(scene.intensity), m_incident(*scene.sky, scene.intensity, light, *scene.visibility),
      m_rays(*scene.surface, geometry, plan), m_sought(scene, plan, emitters, RaySpread::hemisphere) {}

glm::dvec3 DirectionalTracer::coefficient(std::size_t i, std::size_t lane) const {
    const double share = std::numbers::pi / m_plan->samples();
    return share * (2.0 * m_around.sum(i, lane) + m_intensity * m_sent.sum(i, lane));
}

std::uint64_t DirectionalTracer::rays() const { return m_ray_count + m_sought.rays(); }

void DirectionalTracer::sum_up(const TexelTile& tile) {
    m_around.clear();
    m_sent.clear();
    m_rays.begin(tile);
    for (std::size_t number = 0; number < m_plan->block_count(); ++number) {
        m_block = m_rays.make(number);
        spread(m_block);
        for (const RayBlock::LaneBits active : m_block.active) {
            m_ray_count += static_cast<std::uint64_t>(std::popcount(active));
        }
        m_around.add(m_block, m_incident.along(m_block, m_rays.lanes(), m_sought.emitters()));
    }
    m_sought.add(m_rays.lanes(), m_around, m_sent);
}

// A direction that is below the geometric plane before is so after, farther down its meridian.
void DirectionalTracer::spread(RayBlock& block) const {
    const auto& [nx, ny, nz] = m_rays.lanes().normal;
    const auto& [gx, gy, gz] = m_rays.lanes().geometric_normal;
    for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
        auto& [x, y, z] = block.direction[stratum];
        unsigned above = 0;
        for (std::size_t lane = 0; lane < RayBlock::lanes; ++lane) {
            const float cosine = x[lane] * nx[lane] + y[lane] * ny[lane] + z[lane] * nz[lane];
            const float along = std::sqrt(1.0F + cosine * cosine);
            const float up = cosine * (cosine - along);
            x[lane] = along * x[lane] + up * nx[lane];
            y[lane] = along * y[lane] + up * ny[lane];
            z[lane] = along * z[lane] + up * nz[lane];
            const float height = x[lane] * gx[lane] + y[lane] * gy[lane] + z[lane] * gz[lane];
            above |= height > 0.0F ? 1U << lane : 0U;
        }
        block.active[stratum] = static_cast<RayBlock::LaneBits>(block.active[stratum] & above);
    }
}

} // namespace vkbake
