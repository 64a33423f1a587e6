#include "bvh/sheared_ray.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>

namespace vkbake {
namespace {

bool finite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

} // namespace

ShearedRay::ShearedRay(const Ray& ray) : origin(ray.origin), direction(ray.direction), max_distance(ray.max_distance) {
    const glm::vec3 magnitude = glm::abs(direction);
    const float length = std::max({magnitude.x, magnitude.y, magnitude.z});
    valid = finite(origin) && finite(direction) && length >= least_direction && length <= greatest_direction &&
            max_distance > 0.0F;
    if (!valid) {
        return;
    }
    z_axis = magnitude.x == length ? 0 : (magnitude.y == length ? 1 : 2);
    x_axis = (z_axis + 1) % 3;
    y_axis = (z_axis + 2) % 3;
    if (direction[z_axis] < 0.0F) {
        std::swap(x_axis, y_axis);
    }
    const float inverse = 1.0F / direction[z_axis];
    shear_x = direction[x_axis] * inverse;
    shear_y = direction[y_axis] * inverse;
}

} // namespace vkbake
