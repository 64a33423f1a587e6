#include "bvh/cluster_list.hpp"

namespace vkbake {

ClusterList::ClusterList(const std::vector<Triangle>& triangles, int splits, int threads, TriangleTest test)
    : m_clustering(cluster_triangles(triangles, splits, threads)), m_test(test) {
    m_triangles.reserve(triangles.size());
    for (const std::uint32_t rank : m_clustering.ranks) {
        m_triangles.push_back(triangles[rank]);
    }
}

bool ClusterList::occluded(const PreparedRay& ray) const {
    for (const Cluster& cluster : m_clustering.clusters) {
        const Interval interval = pass(ray, cluster.box);
        if (interval.entry > interval.exit) {
            continue;
        }
        for (std::uint32_t i = cluster.begin; i < cluster.end; ++i) {
            const bool ignored = m_clustering.ranks[i] == ray.ignored_rank;
            if (!ignored && test_triangle(m_test, ray, m_triangles[i]).hit) {
                return true;
            }
        }
    }
    return false;
}

NearestHit ClusterList::nearest(const PreparedRay& ray) const {
    NearestHit best(ray);
    for (const Cluster& cluster : m_clustering.clusters) {
        const Interval interval = pass(ray, cluster.box);
        if (interval.entry > interval.exit) {
            continue;
        }
        for (std::uint32_t i = cluster.begin; i < cluster.end; ++i) {
            if (m_clustering.ranks[i] != ray.ignored_rank) {
                best.offer(test_triangle(m_test, ray, m_triangles[i]), m_clustering.ranks[i]);
            }
        }
    }
    return best;
}

AcceleratorStatistics ClusterList::statistics() const {
    AcceleratorStatistics statistics;
    statistics.clusters = m_clustering.clusters.size();
    statistics.bytes = m_triangles.capacity() * sizeof(Triangle) + m_clustering.clusters.capacity() * sizeof(Cluster) +
                       m_clustering.ranks.capacity() * sizeof(std::uint32_t);
    return statistics;
}

} // namespace vkbake
