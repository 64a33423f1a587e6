// The watertight test for sixteen pairs of a ray and a triangle: one ray and the triangles of a leaf, or sixteen rays
// and one triangle. It says yes or no where floats can tell for certain what test_watertight (triangle_test.hpp) says,
// and leaves the rest in doubt. No include guard: see row.inl, which must come first.

#include "bvh/edge_functions.inl"

/// A ray in all lanes, or sixteen rays, as the test wants them. z is the axis of the direction's largest component, x
/// and y those of ShearedRay. z is turned so that the ray runs towards +z, which changes no bit but signs.
template<std::size_t Parts>
struct LeafRays {
    using Lane = Wide<Parts>;
    Lane origin_x, origin_y;
    Lane sign, turned_origin_z;          ///< ±1; sign · origin.z
    Lane turned_shear_x, turned_shear_y; ///< sign · slope
    Lane sure_depth, futile_depth;       ///< along z: below the first a hit is near enough, from the second on too far
};

/// What all rays of a block have in common.
template<std::size_t Parts>
struct LeafLimits {
    bool limited;                 ///< false: there is no limit, and no depth is too far
    Wide<Parts> behind, in_front; ///< see test_corners and sure_sum_of

    HWY_INLINE LeafLimits(bool has_limit, float sure_sum)
        : limited(has_limit), behind(fill<Parts>(-sure_sum)), in_front(fill<Parts>(sure_sum)) {}
};

/// Vertices as the ray or rays see them: sheared, and how far along z.
template<std::size_t Parts>
struct LeafVertices {
    Wide<Parts> z, x, y;

    HWY_INLINE LeafVertices(const LeafRays<Parts>& ray, const Wide<Parts>& at_x, const Wide<Parts>& at_y,
                            const Wide<Parts>& at_z)
        : z(multiply_subtract(ray.sign, at_z, ray.turned_origin_z)), // exact product: one rounding
          x(shear(at_x - ray.origin_x, ray.turned_shear_x, z)), y(shear(at_y - ray.origin_y, ray.turned_shear_y, z)) {}
};

constexpr float surely_in_front = 0x1p-60F;

/// A triangle's corners.
template<std::size_t Parts>
struct LeafCorners {
    ShearedTriangle<Wide<Parts>> at;
    Wide<Parts> az, bz, cz;
};

template<std::size_t Parts>
struct LeafAnswer {
    WideMask<Parts> hit;   ///< met, for certain
    WideMask<Parts> doubt; ///< perhaps; those of `hit` too
};

/// Why `hit` is never wrong. Float edge functions have no wrong sign, so strictly inside is inside in double too. There
/// t is a mean of the corners' depths, weighted by the edge functions. Where all corners are in front by more than
/// could underflow, t is positive. Elsewhere the weighted sum tells its sign: with M the extent of PreparedRay, sheared
/// coordinates are below 2·M and depths below M, so an edge function is off by at most 16·2⁻²⁴·M², the sum by
/// 48·2⁻²⁴·M³ from these and by 72·2⁻²⁴·M³ from its own roundings: beyond 256·2⁻²⁴·M³ its sign is that of t.
template<std::size_t Parts>
HWY_INLINE LeafAnswer<Parts> test_corners(const LeafRays<Parts>& ray, const LeafLimits<Parts>& limits,
                                          const LeafCorners<Parts>& corner) {
    using Lane = Wide<Parts>;
    const Lane zero = fill<Parts>(0.0F);
    const EdgeFunctions<Lane> edge(corner.at);
    const Lane least = min(edge.u, min(edge.v, edge.w));
    const Lane greatest = max(edge.u, max(edge.v, edge.w));
    const Lane nearest = min(corner.az, min(corner.bz, corner.cz));
    const Lane farthest = max(corner.az, max(corner.bz, corner.cz));
    const Lane sum = edge.u * corner.az + edge.v * corner.bz + edge.w * corner.cz;
    // Positive where all signs are the same and none is 0; where it underflows there is doubt.
    const Lane alike = least * greatest;
    const auto strictly = zero < alike;
    const auto perhaps = zero <= alike;
    const Lane depth = turned_by_sign(sum, least + greatest);
    const auto ahead = (fill<Parts>(surely_in_front) < nearest) | (limits.in_front < depth);
    LeafAnswer<Parts> answer{strictly & ahead, perhaps & (zero < farthest) & (limits.behind <= depth)};
    if (limits.limited) {
        answer.hit = answer.hit & (farthest < ray.sure_depth);
        answer.doubt = answer.doubt & (nearest < ray.futile_depth);
    }
    return answer;
}

/// Along which axis of the scene each one of the ray lies.
struct LeafAxes {
    std::uint32_t x, y, z;
};

/// Triangles of a leaf, a bit each; see LeafAnswer.
struct LeafBits {
    unsigned hit = 0, doubt = 0;
};

/// One ray against so many triangles of a leaf, a vector of them at a time: more do not fit the registers of AVX2, and
/// most leaves have fewer than nine.
HWY_INLINE LeafBits test_leaf(const LeafRays<1>& ray, const LeafLimits<1>& limits, const LeafAxes& axes,
                              const Leaf& leaf, std::size_t triangles) {
    Row x;
    Row y;
    Row z;
    for (std::size_t p = 0; p < part_count; ++p) {
        const LeafVertices<1> at(ray, load_part(leaf.vertices[axes.x], p), load_part(leaf.vertices[axes.y], p),
                                 load_part(leaf.vertices[axes.z], p));
        x.part[p] = at.x.part[0];
        y.part[p] = at.y.part[0];
        z.part[p] = at.z.part[0];
    }
    LeafBits bits;
    for (std::size_t p = 0; p < part_count && p * part_size < triangles; ++p) {
        const Places a = unpack_places<0>(leaf.corners, p);
        const Places b = unpack_places<4>(leaf.corners, p);
        const Places c = unpack_places<8>(leaf.corners, p);
        const LeafAnswer<1> answer =
            test_corners<1>(ray, limits,
                            {{pick(x, a), pick(y, a), pick(x, b), pick(y, b), pick(x, c), pick(y, c)},
                             pick(z, a),
                             pick(z, b),
                             pick(z, c)});
        bits.hit |= answer.hit.bits() << (p * part_size);
        bits.doubt |= answer.doubt.bits() << (p * part_size);
    }
    return bits;
}
