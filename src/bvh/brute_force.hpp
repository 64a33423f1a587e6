// Every triangle against every ray: the oracle.
#pragma once

#include <utility>
#include <vector>

#include "bvh/ray_caster.hpp"

namespace vkbake {

class BruteForce final : public RayCaster {
public:
    BruteForce(std::vector<Triangle> triangles, TriangleTest test) : m_triangles(std::move(triangles)), m_test(test) {}

    [[nodiscard]] bool occluded(const PreparedRay& ray) const override;
    [[nodiscard]] NearestHit nearest(const PreparedRay& ray) const override;
    [[nodiscard]] bool filter(const PreparedRay& ray, const RankedFilter& filter) const override;
    [[nodiscard]] AcceleratorStatistics statistics() const override;

private:
    std::vector<Triangle> m_triangles; // by rank
    TriangleTest m_test;
};

} // namespace vkbake
