// The thesis's accelerator: a flat list of clusters.
#pragma once

#include <vector>

#include "bvh/clusters.hpp"
#include "bvh/ray_caster.hpp"

namespace vkbake {

/// Walks all clusters in order; where the ray passes a cluster's box, all of its triangles. As in the thesis (§3.3.3)
/// it stops at the first hit if any will do, and skips nothing else.
class ClusterList final : public RayCaster {
public:
    ClusterList(const ListedTriangles& triangles, int splits, int threads, TriangleTest test);

    [[nodiscard]] bool occluded(const PreparedRay& ray) const override;
    [[nodiscard]] NearestHit nearest(const PreparedRay& ray) const override;
    [[nodiscard]] bool filter(const PreparedRay& ray, const RankedFilter& filter) const override;
    [[nodiscard]] AcceleratorStatistics statistics() const override;

private:
    std::vector<Cluster> m_clusters;
    std::vector<Triangle> m_triangles;  // by place
    std::vector<std::uint32_t> m_ranks; // by place
    TriangleTest m_test;
};

} // namespace vkbake
