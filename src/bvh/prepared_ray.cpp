#include "bvh/prepared_ray.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace vkbake {
namespace {

float largest(const glm::vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

} // namespace

PreparedRay::PreparedRay(const Ray& ray, const Box& bounds)
    : ShearedRay(ray), extent(0.0F), near_origin(0.0F), far_origin(0.0F), inverse(0.0F), negative{} {
    valid = valid && !bounds.empty();
    if (!valid) {
        return;
    }
    const glm::vec3 magnitude = glm::abs(direction);
    const float length = magnitude[z_axis];
    extent = std::max({largest(origin), largest(bounds.low - origin), largest(bounds.high - origin)});
    const float pad = padding_of(extent);
    for (int axis = 0; axis < 3; ++axis) {
        const bool minus = std::signbit(direction[axis]);
        const float inward = minus ? -pad : pad;
        negative[static_cast<std::size_t>(axis)] = minus;
        near_origin[axis] = origin[axis] + inward;
        far_origin[axis] = origin[axis] - inward;
        inverse[axis] = 1.0F / std::copysign(std::max(magnitude[axis], length * least_slope), direction[axis]);
    }
}

} // namespace vkbake
