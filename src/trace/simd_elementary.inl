// Elementary functions of vectors. Included after simd_rows.inl.
//
// Polynomials interpolated at Chebyshev's nodes, coefficients rounded to float. The errors named are those of the
// polynomial in exact arithmetic, relative; rounding adds one or two units of 2⁻²⁴.

struct SineCosineOf {
    Vector sine, cosine;
};

/// For |angle| ≤ π/4. 1.3e-8 and 8.4e-10.
HWY_INLINE SineCosineOf sine_cosine(Vector angle) {
    const Vector square = angle * angle;
    const Vector sine = (set(-0x1.9ac9bp-13F) * square + set(0x1.110c28p-7F)) * square - set(0x1.555552p-3F);
    const Vector cosine = (set(0x1.9bd89cp-16F) * square - set(0x1.6c12d2p-10F)) * square + set(0x1.555554p-5F);
    return {angle + angle * (square * sine), (set(1.0F) - set(0.5F) * square) + (square * square) * cosine};
}

/// The angle of the point (x, y) in [−π, π]; of (0, 0) some finite angle. 2.8e-9, after one reduction: above the
/// diagonal x and y change places, and above tan(π/8) the angle is taken from π/4.
HWY_INLINE Vector arc_tangent(Vector y, Vector x) {
    const Vector across = hn::Abs(y);
    const Vector along = hn::Abs(x);
    const Vector least = hn::Min(across, along);
    const Vector greatest = hn::Max(hn::Max(across, along), set(0x1p-100F));
    const Mask steep = hn::Gt(least, set(0x1.a8279ap-2F) * greatest);
    const Vector t =
        hn::IfThenElse(steep, least - greatest, least) / hn::IfThenElse(steep, least + greatest, greatest);
    const Vector square = t * t;
    Vector series = set(-0x1.08455ep-4F) * square + set(0x1.b8103p-4F);
    series = series * square - set(0x1.242036p-3F);
    series = series * square + set(0x1.99973p-3F);
    series = series * square - set(0x1.555554p-2F);
    constexpr float quarter = 0x1.921fb6p-1F; // π/4
    const Vector octant = (t + t * (square * series)) + hn::IfThenElseZero(steep, set(quarter));
    const Vector first_quadrant = hn::IfThenElse(hn::Gt(across, along), set(2.0F * quarter) - octant, octant);
    const Vector upper_half = hn::IfThenElse(hn::Lt(x, set(0.0F)), set(4.0F * quarter) - first_quadrant, first_quadrant);
    return hn::CopySign(upper_half, y);
}

/// e^x for −80 ≤ x ≤ 80. 1.0e-8: of the part of x that is left beside a multiple of ln 2.
HWY_INLINE Vector exponential(Vector x) {
    // Added and taken away, this leaves the nearest whole number; the thread rounds to nearest (base/float_state.hpp).
    const Vector whole = set(0x1.8p23F);
    const Vector power = (x * set(0x1.715476p+0F) + whole) - whole;
    // ln 2 in two parts (Cody and Waite 1980): the first is so short that its product with `power` is exact.
    const Vector rest = (x - power * set(0x1.62e4p-1F)) - power * set(0x1.7f7d1cp-20F);
    Vector series = set(0x1.6d05aap-10F) * rest + set(0x1.120b9ep-7F);
    series = series * rest + set(0x1.555522p-5F);
    series = series * rest + set(0x1.5554dcp-3F);
    series = series * rest + set(0.5F);
    const Vector value = (set(1.0F) + rest) + (rest * rest) * series;
    const WholeLanes wholes;
    const Wholes exponent = hn::ShiftLeft<23>(hn::ConvertTo(wholes, power) + hn::Set(wholes, 127));
    return value * hn::BitCast(Lanes(), exponent);
}
