// Where in a triangle a point lies.
#pragma once

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace vkbake {

/// The barycentric coordinates of the point's projection onto the triangle's plane, each moved into [0, 1] and their
/// sum 1; a third each where the triangle has no area.
[[nodiscard]] inline glm::dvec3 barycentric(const std::array<glm::vec3, 3>& corners, const glm::dvec3& point) {
    const glm::dvec3 a(corners[0]);
    const glm::dvec3 ab = glm::dvec3(corners[1]) - a;
    const glm::dvec3 ac = glm::dvec3(corners[2]) - a;
    const glm::dvec3 normal = glm::cross(ab, ac);
    const double area = glm::dot(normal, normal);
    if (!(area > 0.0)) {
        return glm::dvec3(1.0 / 3.0);
    }
    const glm::dvec3 ap = point - a;
    const double v = std::clamp(glm::dot(glm::cross(ap, ac), normal) / area, 0.0, 1.0);
    const double w = std::clamp(glm::dot(glm::cross(ab, ap), normal) / area, 0.0, 1.0);
    const double sum = std::max(v + w, 1.0);
    return {1.0 - (v + w) / sum, v / sum, w / sum};
}

} // namespace vkbake
