#include "bvh/brute_force.hpp"

namespace vkbake {

bool BruteForce::occluded(const PreparedRay& ray) const {
    for (std::uint32_t rank = 0; rank < m_triangles.size(); ++rank) {
        if (rank != ray.ignored_rank && test_triangle(m_test, ray, m_triangles[rank]).hit) {
            return true;
        }
    }
    return false;
}

NearestHit BruteForce::nearest(const PreparedRay& ray) const {
    NearestHit best(ray);
    for (std::uint32_t rank = 0; rank < m_triangles.size(); ++rank) {
        if (rank != ray.ignored_rank) {
            best.offer(test_triangle(m_test, ray, m_triangles[rank]), rank);
        }
    }
    return best;
}

bool BruteForce::filter(const PreparedRay& ray, const RankedFilter& filter) const {
    for (std::uint32_t rank = 0; rank < m_triangles.size(); ++rank) {
        if (rank != ray.ignored_rank && filter_triangle(m_test, ray, m_triangles[rank], rank, filter)) {
            return true;
        }
    }
    return false;
}

AcceleratorStatistics BruteForce::statistics() const {
    AcceleratorStatistics statistics;
    statistics.bytes = m_triangles.capacity() * sizeof(Triangle);
    return statistics;
}

} // namespace vkbake
