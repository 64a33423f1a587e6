#include "bench/accelerators/ray_asker.hpp"

#include <cmath>

#include <glm/geometric.hpp>

namespace vkbake::bench {

bool touches(const Triangle& triangle, const Box& box) {
    const Box bounds = triangle.bounds();
    for (int axis = 0; axis < 3; ++axis) {
        if (bounds.low[axis] - reach_of_rounding > box.high[axis] ||
            bounds.high[axis] + reach_of_rounding < box.low[axis]) {
            return false;
        }
    }
    const glm::dvec3 corner(triangle.corners[0]);
    const glm::dvec3 normal =
        glm::cross(glm::dvec3(triangle.corners[1]) - corner, glm::dvec3(triangle.corners[2]) - corner);
    const glm::dvec3 centre = 0.5 * (glm::dvec3(box.low) + glm::dvec3(box.high));
    const glm::dvec3 half = glm::dvec3(box.high) - centre + glm::dvec3(reach_of_rounding);
    const double away = std::abs(glm::dot(normal, centre - corner));
    // The last term: what the products above may round by.
    return away <= glm::dot(glm::abs(normal), half) * (1.0 + 1e-9);
}

} // namespace vkbake::bench
