#include "bvh/prepared_ray.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace vkbake {
namespace {

// The bounds that Ray states: 1 / direction and every product with it stay finite and normal.
constexpr float least_direction = 0x1p-60F;
constexpr float greatest_direction = 0x1p60F;
// 16 · 2⁻²⁴, see PreparedRay.
constexpr float relative_pad = 0x1p-20F;
// Covers what underflow adds where everything lies within about 2⁻¹⁰⁰ of the origin.
constexpr float least_pad = 0x1p-120F;
// A component this much below the largest one moves the ray by less than 2⁻⁴⁰ · M: far less than the pad. So the slabs
// may take it as this large, and neither ±0 nor a denormal gives an infinity, or a NaN where a plane meets the origin.
constexpr float least_slope = 0x1p-40F;

float largest(const glm::vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

bool finite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

} // namespace

PreparedRay::PreparedRay(const Ray& ray, const Box& bounds)
    : origin(ray.origin), direction(ray.direction), max_distance(ray.max_distance), valid(false), x_axis(0), y_axis(1),
      z_axis(2), shear_x(0.0F), shear_y(0.0F), near_origin(0.0F), far_origin(0.0F), inverse(0.0F), negative{} {
    const float length = largest(direction);
    valid = finite(origin) && finite(direction) && length >= least_direction && length <= greatest_direction &&
            max_distance > 0.0F && !bounds.empty();
    if (!valid) {
        return;
    }
    const glm::vec3 magnitude = glm::abs(direction);
    z_axis = magnitude.x == length ? 0 : (magnitude.y == length ? 1 : 2);
    x_axis = (z_axis + 1) % 3;
    y_axis = (z_axis + 2) % 3;
    if (direction[z_axis] < 0.0F) {
        std::swap(x_axis, y_axis);
    }
    shear_x = direction[x_axis] / direction[z_axis];
    shear_y = direction[y_axis] / direction[z_axis];

    const float extent = std::max({largest(origin), largest(bounds.low - origin), largest(bounds.high - origin)});
    const float pad = std::max(extent * relative_pad, least_pad);
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
