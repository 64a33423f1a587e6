// The watertight test for sixteen pairs of a ray and a triangle: one ray and the triangles of a leaf, or sixteen rays
// and one triangle. It says yes or no where floats can tell for certain what test_watertight (triangle_test.hpp) says,
// and leaves the rest in doubt. No include guard: see row.inl, which must come first.

#include "bvh/edge_functions.inl"

/// A ray, or sixteen, as the test wants them. z is the axis of the direction's largest component, x and y those of
/// ShearedRay. z is turned so that the ray runs towards +z, which changes no bit but signs.
struct LeafRays {
    Row origin_x, origin_y;
    Row sign, turned_origin_z;          ///< ±1; sign · origin.z
    Row turned_shear_x, turned_shear_y; ///< sign · slope
    Row sure_depth, futile_depth;       ///< along z: below the first a hit is near enough, from the second on too far
    bool limited = false;                       ///< false: there is no limit, and no depth is too far
    Row sure_sum;                       ///< see test_corners and sure_sum_of
};

/// Vertices as the ray or rays see them: sheared, and how far along z.
struct LeafVertices {
    Row z, x, y;

    HWY_INLINE LeafVertices(const LeafRays& ray, const Row& at_x, const Row& at_y, const Row& at_z)
        : z(multiply_subtract(ray.sign, at_z, ray.turned_origin_z)), // exact product: one rounding
          x(shear(at_x - ray.origin_x, ray.turned_shear_x, z)), y(shear(at_y - ray.origin_y, ray.turned_shear_y, z)) {}
};

constexpr float surely_in_front = 0x1p-60F;

/// A triangle's corners.
struct LeafCorners {
    ShearedTriangle<Row> at;
    Row az, bz, cz;
};

HWY_INLINE LeafCorners corners_of(const Leaf& leaf, const LeafVertices& vertices) {
    const RowPlaces a = unpack_places<0>(leaf.corners);
    const RowPlaces b = unpack_places<4>(leaf.corners);
    const RowPlaces c = unpack_places<8>(leaf.corners);
    return {{pick(vertices.x, a), pick(vertices.y, a), pick(vertices.x, b), pick(vertices.y, b), pick(vertices.x, c),
             pick(vertices.y, c)},
            pick(vertices.z, a),
            pick(vertices.z, b),
            pick(vertices.z, c)};
}

struct LeafAnswer {
    RowMask hit;   ///< met, for certain
    RowMask doubt; ///< perhaps; those of `hit` too
};

/// Why `hit` is never wrong. Float edge functions have no wrong sign, so strictly inside is inside in double too. There
/// t is a mean of the corners' depths, weighted by the edge functions. Where all corners are in front by more than
/// could underflow, t is positive. Elsewhere the weighted sum tells its sign: with M the extent of PreparedRay, sheared
/// coordinates are below 2·M and depths below M, so an edge function is off by at most 16·2⁻²⁴·M², the sum by
/// 48·2⁻²⁴·M³ from these and by 72·2⁻²⁴·M³ from its own roundings: beyond 256·2⁻²⁴·M³ its sign is that of t.
HWY_INLINE LeafAnswer test_corners(const LeafRays& ray, const LeafCorners& corner) {
    const Row zero = fill(0.0F);
    const EdgeFunctions<Row> edge(corner.at);
    const Row least = min(edge.u, min(edge.v, edge.w));
    const Row greatest = max(edge.u, max(edge.v, edge.w));
    const Row nearest = min(corner.az, min(corner.bz, corner.cz));
    const Row farthest = max(corner.az, max(corner.bz, corner.cz));
    const Row sum = edge.u * corner.az + edge.v * corner.bz + edge.w * corner.cz;
    // Positive where all signs are the same and none is 0; where it underflows there is doubt.
    const Row alike = least * greatest;
    const RowMask strictly = zero < alike;
    const RowMask perhaps = zero <= alike;
    const Row depth = turned_by_sign(sum, least + greatest);
    const RowMask ahead = (fill(surely_in_front) < nearest) | (ray.sure_sum < depth);
    LeafAnswer answer{strictly & ahead, perhaps & (zero < farthest) & (zero - ray.sure_sum <= depth)};
    if (ray.limited) {
        answer.hit = answer.hit & (farthest < ray.sure_depth);
        answer.doubt = answer.doubt & (nearest < ray.futile_depth);
    }
    return answer;
}
