#include "bvh/cluster_list.hpp"

namespace vkbake {

ClusterList::ClusterList(const ListedTriangles& triangles, int splits, int threads, TriangleTest test)
    : m_triangles(triangles.size()), m_ranks(triangles.size()), m_test(test) {
    m_clusters = cluster_triangles(triangles, splits, threads,
                                   [&](std::uint32_t place, std::uint32_t rank, const Box& /*bounds*/) {
                                       m_triangles[place] = triangles[rank];
                                       m_ranks[place] = rank;
                                   });
}

bool ClusterList::occluded(const PreparedRay& ray) const {
    for (const Cluster& cluster : m_clusters) {
        const Interval interval = pass(ray, cluster.box);
        if (interval.entry > interval.exit) {
            continue;
        }
        for (std::uint32_t i = cluster.begin; i < cluster.end; ++i) {
            const bool ignored = m_ranks[i] == ray.ignored_rank;
            if (!ignored && test_triangle(m_test, ray, m_triangles[i]).hit) {
                return true;
            }
        }
    }
    return false;
}

NearestHit ClusterList::nearest(const PreparedRay& ray) const {
    NearestHit best(ray);
    for (const Cluster& cluster : m_clusters) {
        const Interval interval = pass(ray, cluster.box);
        if (interval.entry > interval.exit) {
            continue;
        }
        for (std::uint32_t i = cluster.begin; i < cluster.end; ++i) {
            if (m_ranks[i] != ray.ignored_rank) {
                best.offer(test_triangle(m_test, ray, m_triangles[i]), m_ranks[i]);
            }
        }
    }
    return best;
}

bool ClusterList::filter(const PreparedRay& ray, const RankedFilter& filter) const {
    for (const Cluster& cluster : m_clusters) {
        const Interval interval = pass(ray, cluster.box);
        if (interval.entry > interval.exit) {
            continue;
        }
        for (std::uint32_t i = cluster.begin; i < cluster.end; ++i) {
            if (m_ranks[i] != ray.ignored_rank && filter_triangle(m_test, ray, m_triangles[i], m_ranks[i], filter)) {
                return true;
            }
        }
    }
    return false;
}

AcceleratorStatistics ClusterList::statistics() const {
    AcceleratorStatistics statistics;
    statistics.clusters = m_clusters.size();
    statistics.bytes = m_triangles.capacity() * sizeof(Triangle) + m_clusters.capacity() * sizeof(Cluster) +
                       m_ranks.capacity() * sizeof(std::uint32_t);
    return statistics;
}

} // namespace vkbake
