#include "trace/ray_origin.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

namespace vkbake {

namespace {

glm::dvec3 kept_off_edges(const std::array<glm::vec3, 3>& corners, const glm::dvec3& point) {
    const glm::dvec3 corner(corners[0]);
    const glm::dvec3 first = glm::dvec3(corners[1]) - corner;
    const glm::dvec3 second = glm::dvec3(corners[2]) - corner;
    const glm::dvec3 normal = glm::cross(first, second);
    const double doubled_area = glm::length(normal);
    if (!(doubled_area > 0.0)) {
        return point;
    }

    // Barycentric coordinate k is the distance from the edge opposite corner k in units of the height on it.
    const glm::dvec3 across = point - corner;
    const double squared = glm::dot(normal, normal);
    const double b1 = glm::dot(normal, glm::cross(across, second)) / squared;
    const double b2 = glm::dot(normal, glm::cross(first, across)) / squared;
    const std::array<double, 3> place{1.0 - b1 - b2, b1, b2};
    const std::array<double, 3> edges{glm::length(second - first), glm::length(second), glm::length(first)};
    std::array<double, 3> least{};
    bool near_edge = false;
    double free = 1.0;  // what the least coordinates leave to share out
    double slack = 0.0; // what the point has above them
    for (std::size_t k = 0; k < 3; ++k) {
        least[k] = std::min(1.0 / 3.0, origin_from_edges * edges[k] / doubled_area);
        near_edge = near_edge || place[k] < least[k];
        free -= least[k];
        slack += std::max(0.0, place[k] - least[k]);
    }
    if (!near_edge) {
        return point;
    }
    const auto moved = [&](std::size_t k) {
        return least[k] + (slack > 0.0 ? free * (std::max(0.0, place[k] - least[k]) / slack) : 0.0);
    };
    return corner + moved(1) * first + moved(2) * second;
}

} // namespace

glm::vec3 ray_origin(const std::array<glm::vec3, 3>& corners, const glm::vec3& position, const glm::vec3& normal) {
    return glm::vec3(kept_off_edges(corners, glm::dvec3(position)) + origin_off_surface * glm::dvec3(normal));
}

} // namespace vkbake
