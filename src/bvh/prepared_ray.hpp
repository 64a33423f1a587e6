// A ray with all that is computed once for it: the shear of the triangle test and the slabs of the box test.
#pragma once

#include <array>

#include <glm/vec3.hpp>

#include "bvh/box.hpp"
#include "bvh/sheared_ray.hpp"

namespace vkbake {

constexpr float relative_pad = 0x1p-20F; ///< 16 · 2⁻²⁴
/// Covers what underflow adds where everything lies within about 2⁻¹⁰⁰ of the origin.
constexpr float least_pad = 0x1p-120F;
/// A component this much below the largest one moves the ray by less than 2⁻⁴⁰ · M: far less than the pad. So the slabs
/// may take it as this large, and neither ±0 nor a denormal gives an infinity, or a NaN where a plane meets the origin.
constexpr float least_slope = 0x1p-40F;

/// On either side of a distance, this far from it relatively, floats tell for certain which side it is.
constexpr float nearly_one = 1.0F - 0x1p-20F;
constexpr float just_over_one = 1.0F + 0x1p-19F; ///< more than its inverse

/// `extent`: M, see PreparedRay.
[[nodiscard]] inline float padding_of(float extent) {
    return extent * relative_pad > least_pad ? extent * relative_pad : least_pad;
}

/// 256 · 2⁻²⁴ · M³, and no less than what underflow adds: from there on the sum that stands for t has the sign of t
/// (see leaf_test.inl).
[[nodiscard]] inline float sure_sum_of(float extent) {
    const float sum = extent * extent * extent * 0x1p-16F;
    return sum > 0x1p-100F ? sum : 0x1p-100F;
}

/// Slabs after Williams et al., "An Efficient and Robust Ray–Box Intersection Algorithm" (2005), made conservative (the
/// thought is Ize's, "Robust BVH Ray Traversal", 2013) against the rounding of both the slabs and the triangle test.
///
/// Why no box loses a triangle. Let u = 2⁻²⁴ and M the largest distance along an axis from the origin to anything, or
/// the origin's own largest coordinate. Relative to its true place a sheared corner is off by at most 7·u·M
/// (subtraction of the origin in two axes, the slope's two roundings, the product, the difference). What follows is
/// exact to double precision, and t is then rounded to float (1·u·M), so the ray's point at the computed t lies within
/// 8·u·M of the triangle, hence of its box. A slab's distance is off by what moving its plane by 3·u·M would do, and
/// moving it by the pad rounds by 1·u·M. So boxes that are padded by 16·u·M always hold the point: entry(box) ≤ t ≤
/// exit(box). The pad sits in the ray (two origins an axis), so that it costs nothing and does not depend on which
/// boxes there are.
struct PreparedRay : ShearedRay {
    float extent;                      ///< M, see above
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
