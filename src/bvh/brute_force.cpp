#include "bvh/brute_force.hpp"

#include <algorithm>

namespace vkbake {

bool BruteForce::occluded(const PreparedRay& ray) const {
    return std::any_of(m_triangles.begin(), m_triangles.end(),
                       [&](const Triangle& triangle) { return test_triangle(m_test, ray, triangle).hit; });
}

NearestHit BruteForce::nearest(const PreparedRay& ray) const {
    NearestHit best(ray);
    for (std::uint32_t rank = 0; rank < m_triangles.size(); ++rank) {
        best.offer(test_triangle(m_test, ray, m_triangles[rank]), rank);
    }
    return best;
}

AcceleratorStatistics BruteForce::statistics() const {
    AcceleratorStatistics statistics;
    statistics.bytes = m_triangles.capacity() * sizeof(Triangle);
    return statistics;
}

} // namespace vkbake
