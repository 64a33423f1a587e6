// The triangle test in double precision, and how far a ray is from changing its answer.
#pragma once

#include <cmath>

#include <glm/geometric.hpp>

#include "unit/bvh/ray_scenes.hpp"

namespace vkbake::test {

struct Reference {
    bool inside = false;    ///< the line through the ray passes the triangle
    double distance = 0.0;  ///< where it meets the triangle's plane; anything if parallel to it
    double margin = 0.0;    ///< distance of the triangle's outline from the line, in the plane across the largest axis
    double steepness = 0.0; ///< how much the distance changes as the ray moves by 1 across that axis
    double extent = 0.0;    ///< the largest coordinate of origin, or of a corner as seen from it
};

inline double largest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

inline double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

inline double distance_to_segment(const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 along = b - a;
    const double length2 = glm::dot(along, along);
    const double place = length2 > 0.0 ? std::clamp(-glm::dot(a, along) / length2, 0.0, 1.0) : 0.0;
    return glm::length(a + place * along);
}

inline Reference refer(const Ray& ray, const std::array<glm::vec3, 3>& triangle) {
    const glm::dvec3 origin(ray.origin);
    const glm::dvec3 direction(ray.direction);
    const glm::dvec3 magnitude = glm::abs(direction);
    int z = 2;
    if (magnitude.x >= magnitude.y && magnitude.x >= magnitude.z) {
        z = 0;
    } else if (magnitude.y >= magnitude.z) {
        z = 1;
    }
    Reference result;
    std::array<glm::dvec3, 3> corners{};
    std::array<glm::dvec2, 3> flat{};
    result.extent = largest(origin);
    for (std::size_t i = 0; i < 3; ++i) {
        corners[i] = glm::dvec3(triangle[i]) - origin;
        result.extent = std::max(result.extent, largest(corners[i]));
        const glm::dvec3 moved = corners[i] - direction * (corners[i][z] / direction[z]);
        flat[i] = {moved[(z + 1) % 3], moved[(z + 2) % 3]};
    }
    const double u = cross(flat[2], flat[1]);
    const double v = cross(flat[0], flat[2]);
    const double w = cross(flat[1], flat[0]);
    result.inside = ((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) && u + v + w != 0.0;
    result.margin = std::min({distance_to_segment(flat[0], flat[1]), distance_to_segment(flat[1], flat[2]),
                              distance_to_segment(flat[2], flat[0])});
    const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double facing = glm::dot(normal, direction);
    result.distance = glm::dot(normal, corners[0]) / facing;
    result.steepness = glm::length(normal) / std::abs(facing);
    return result;
}

} // namespace vkbake::test
