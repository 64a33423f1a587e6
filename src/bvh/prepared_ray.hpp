// A ray with all that is computed once for it: the shear of the triangle test and the slabs of the box test.
#pragma once

#include <array>

#include <glm/vec3.hpp>

#include "bvh/accelerator.hpp"
#include "bvh/box.hpp"

namespace vkbake {

/// Shear after Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection" (2013); slabs after Williams et al., "An
/// Efficient and Robust Ray–Box Intersection Algorithm" (2005), made conservative (the thought is Ize's, "Robust BVH
/// Ray Traversal", 2013) against the rounding of both the slabs and the triangle test.
///
/// Why no box loses a triangle. Let u = 2⁻²⁴ and M the largest distance along an axis from the origin to anything, or
/// the origin's own largest coordinate. Relative to its true place a sheared corner is off by at most 6·u·M
/// (subtraction of the origin in two axes, the slope, the product, the difference). What follows is exact to double
/// precision, and t is then rounded to float (1·u·M), so the ray's point at the computed t lies within 7·u·M of the
/// triangle, hence of its box. A slab's distance is off by what moving its plane by 3·u·M would do, and moving it by
/// the pad rounds by 1·u·M. So boxes that are padded by 16·u·M always hold the point: entry(box) ≤ t ≤ exit(box). The
/// pad sits in the ray (two origins an axis), so that it costs nothing and does not depend on which boxes there are.
struct PreparedRay {
    glm::vec3 origin;
    glm::vec3 direction;
    float max_distance;

    bool valid; ///< false: meets nothing, and the members below mean nothing

    int x_axis, y_axis, z_axis; ///< z: of the largest component of the direction; x and y so that winding is kept
    float shear_x, shear_y;     ///< slopes along z

    glm::vec3 near_origin, far_origin; ///< where to measure the near and the far planes of boxes from
    glm::vec3 inverse;                 ///< 1 / direction, finite
    std::array<bool, 3> negative;      ///< the sign bit of each component of the direction: high planes are near

    /// `bounds` holds every triangle that is going to be tested.
    PreparedRay(const Ray& ray, const Box& bounds);
};

/// Where a ray passes a box: t in [entry, exit], empty if entry > exit. Monotone in the box: a larger box never gives a
/// smaller interval, because each rounding is monotone.
struct Interval {
    float entry;
    float exit;
};

[[nodiscard]] inline Interval pass(const PreparedRay& ray, const Box& box) {
    Interval interval{0.0F, ray.max_distance};
    for (int axis = 0; axis < 3; ++axis) {
        const bool negative = ray.negative[static_cast<std::size_t>(axis)];
        const float near_plane = negative ? box.high[axis] : box.low[axis];
        const float far_plane = negative ? box.low[axis] : box.high[axis];
        const float entry = (near_plane - ray.near_origin[axis]) * ray.inverse[axis];
        const float exit = (far_plane - ray.far_origin[axis]) * ray.inverse[axis];
        interval.entry = entry > interval.entry ? entry : interval.entry;
        interval.exit = exit < interval.exit ? exit : interval.exit;
    }
    return interval;
}

} // namespace vkbake
