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
};

/// Corners: rows of their coordinates along x, y and z of the ray or rays.
struct LeafCorners {
    Row ax, ay, az, bx, by, bz, cx, cy, cz;
};

/// What of the test is worth keeping for the pairs in doubt.
struct LeafEdges {
    Row az, bz, cz;
    ShearedTriangle<Row> at;
    EdgeFunctions<Row> edge;

    HWY_INLINE LeafEdges(const LeafRays& ray, const LeafCorners& corner)
        : az(multiply_subtract(ray.sign, corner.az, ray.turned_origin_z)), // exact product: one rounding
          bz(multiply_subtract(ray.sign, corner.bz, ray.turned_origin_z)),
          cz(multiply_subtract(ray.sign, corner.cz, ray.turned_origin_z)),
          at{shear(corner.ax - ray.origin_x, ray.turned_shear_x, az),
             shear(corner.ay - ray.origin_y, ray.turned_shear_y, az),
             shear(corner.bx - ray.origin_x, ray.turned_shear_x, bz),
             shear(corner.by - ray.origin_y, ray.turned_shear_y, bz),
             shear(corner.cx - ray.origin_x, ray.turned_shear_x, cz),
             shear(corner.cy - ray.origin_y, ray.turned_shear_y, cz)},
          edge(at) {}
    [[nodiscard]] HWY_INLINE Row least() const { return min(edge.u, min(edge.v, edge.w)); }
    [[nodiscard]] HWY_INLINE Row greatest() const { return max(edge.u, max(edge.v, edge.w)); }
};

struct LeafAnswer {
    RowMask hit;   ///< met, for certain
    RowMask doubt; ///< perhaps; those of `hit` too
};

/// `hit` is never wrong: float edge functions have no wrong sign, so strictly inside is inside in double too; there t
/// is a weighted mean of the corners' depths, all of which exceed what could underflow.
HWY_INLINE LeafAnswer test_leaf(const LeafRays& ray, const LeafEdges& leaf) {
    const Row zero = fill(0.0F);
    const Row least = leaf.least();
    const Row greatest = leaf.greatest();
    const Row nearest = min(leaf.az, min(leaf.bz, leaf.cz));
    const Row farthest = max(leaf.az, max(leaf.bz, leaf.cz));
    const RowMask strictly = (zero < least) | (greatest < zero);
    const RowMask in_front = (fill(0x1p-60F) < nearest) & (farthest < ray.sure_depth);
    const RowMask met = (zero <= least) | (greatest <= zero);
    return {strictly & in_front, met & (zero < farthest) & (nearest < ray.futile_depth)};
}

/// Of the pairs in doubt those that are met for certain, or cannot be told: for rays without a limit.
/// With X, Y, Z the greatest magnitudes of the corners along the axes, an edge function is off by at most 4·2⁻²⁴·X·Y,
/// so their sum weighted by depths is off by at most 12·2⁻²⁴·X·Y·Z, and its own roundings add 18·2⁻²⁴·X·Y·Z. Beyond
/// 64·2⁻²⁴·X·Y·Z its sign is that of t. The least values keep this true where products underflow.
HWY_INLINE LeafAnswer test_depth(const LeafEdges& leaf) {
    const Row zero = fill(0.0F);
    const Row x = max(abs(leaf.at.ax), max(abs(leaf.at.bx), abs(leaf.at.cx)));
    const Row y = max(abs(leaf.at.ay), max(abs(leaf.at.by), abs(leaf.at.cy)));
    const Row z = max(abs(leaf.az), max(abs(leaf.bz), abs(leaf.cz)));
    const Row bound = max(x * y, fill(0x1p-100F)) * max(z, fill(0x1p-60F)) * fill(0x1p-18F);
    const Row sum = leaf.edge.u * leaf.az + leaf.edge.v * leaf.bz + leaf.edge.w * leaf.cz;
    const Row least = leaf.least();
    const Row depth = select(zero <= least, sum, zero - sum);
    const RowMask strictly = (zero < least) | (leaf.greatest() < zero);
    return {strictly & (bound < depth), zero - bound <= depth};
}
