// Where on its triangle a ray ends.
#pragma once

#include <cstddef>

#include <glm/vec3.hpp>

#include "base/barycentric.hpp"
#include "bvh/accelerator.hpp"
#include "vkbake/surface.hpp"

namespace vkbake {

/// Barycentric coordinates of the hit.
[[nodiscard]] inline glm::dvec3 weights_at(const Surface& surface, const Ray& ray, const Hit& hit) {
    const std::size_t first = std::size_t{3} * hit.triangle;
    const glm::dvec3 point = glm::dvec3(ray.origin) + static_cast<double>(hit.distance) * glm::dvec3(ray.direction);
    return barycentric({surface.positions[first], surface.positions[first + 1], surface.positions[first + 2]}, point);
}

} // namespace vkbake
