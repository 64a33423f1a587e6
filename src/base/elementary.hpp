// Elementary functions whose bits do not depend on the machine's mathematics library.
//
// Made of additions, multiplications, divisions and square roots alone, which IEEE 754 rounds correctly everywhere; a
// library's sin or exp may differ in the last place between versions and even between processors. The bounds are those
// of the truncated Taylor series; rounding adds a few units of 2⁻⁵³.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace vkbake {

struct SineCosine {
    double sine = 0.0;
    double cosine = 1.0;
};

/// For |angle| ≤ π/4, in radians. Absolute error below 1e-11: the first terms left out are x¹³/13! and x¹⁴/14!.
[[nodiscard]] inline SineCosine sine_cosine(double angle) {
    const double square = angle * angle;
    double sine = -1.0 / 39916800.0;
    sine = sine * square + 1.0 / 362880.0;
    sine = sine * square - 1.0 / 5040.0;
    sine = sine * square + 1.0 / 120.0;
    sine = sine * square - 1.0 / 6.0;
    sine = sine * square + 1.0;
    double cosine = 1.0 / 479001600.0;
    cosine = cosine * square - 1.0 / 3628800.0;
    cosine = cosine * square + 1.0 / 40320.0;
    cosine = cosine * square - 1.0 / 720.0;
    cosine = cosine * square + 1.0 / 24.0;
    cosine = cosine * square - 0.5;
    cosine = cosine * square + 1.0;
    return {sine * angle, cosine};
}

/// For any finite angle in degrees; multiples of 90 are exact.
[[nodiscard]] inline SineCosine sine_cosine_degrees(double degrees) {
    const double turn = std::remainder(degrees, 360.0);    // exact
    const double quarters = std::floor(turn / 90.0 + 0.5); // −2 … 2
    const SineCosine base = sine_cosine((turn - 90.0 * quarters) * (std::numbers::pi / 180.0));
    if (quarters == 1.0) {
        return {base.cosine, -base.sine};
    }
    if (quarters == -1.0) {
        return {-base.cosine, base.sine};
    }
    return quarters == 0.0 ? base : SineCosine{-base.sine, -base.cosine};
}

/// The angle of the point (x, y), in [−π, π] as std::atan2, but the sign of a zero is not looked at: (0, 0) gives 0.
/// Absolute error below 2e-11: reduced to |t| ≤ tan(π/12), where the first term left out is t¹⁷/17.
[[nodiscard]] inline double arc_tangent(double y, double x) {
    const double across = std::abs(y);
    const double along = std::abs(x);
    const double longer = across > along ? across : along;
    if (!(longer > 0.0)) {
        return 0.0;
    }
    double t = (across > along ? along : across) / longer;
    double offset = 0.0;
    constexpr double tangent_of_15_degrees = 2.0 - std::numbers::sqrt3;
    if (t > tangent_of_15_degrees) {
        t = (t * std::numbers::sqrt3 - 1.0) / (t + std::numbers::sqrt3);
        offset = std::numbers::pi / 6.0;
    }
    const double square = t * t;
    double series = -1.0 / 15.0;
    series = series * square + 1.0 / 13.0;
    series = series * square - 1.0 / 11.0;
    series = series * square + 1.0 / 9.0;
    series = series * square - 1.0 / 7.0;
    series = series * square + 1.0 / 5.0;
    series = series * square - 1.0 / 3.0;
    series = series * square + 1.0;
    double angle = offset + t * series;
    angle = across > along ? std::numbers::pi / 2.0 - angle : angle;
    angle = x < 0.0 ? std::numbers::pi - angle : angle;
    return y < 0.0 ? -angle : angle;
}

/// e^x for x ≤ 700; 0 below −700. Relative error below 2e-14: reduced to |r| ≤ ln 2 / 2, where the first term left out
/// is r¹²/12!.
[[nodiscard]] inline double exponential(double x) {
    if (!(x >= -700.0)) {
        return 0.0;
    }
    const double power = std::floor(x * std::numbers::log2e + 0.5);
    // ln 2 in two parts (Cody and Waite 1980): the first has zeros at its end, so that its product with `power` is
    // exact.
    constexpr double ln2_high = 0x1.62e42fefa38p-1;
    constexpr double ln2_low = 0x1.ef35793c7673p-45;
    const double rest = (x - power * ln2_high) - power * ln2_low;
    double series = 1.0 / 39916800.0;
    series = series * rest + 1.0 / 3628800.0;
    series = series * rest + 1.0 / 362880.0;
    series = series * rest + 1.0 / 40320.0;
    series = series * rest + 1.0 / 5040.0;
    series = series * rest + 1.0 / 720.0;
    series = series * rest + 1.0 / 120.0;
    series = series * rest + 1.0 / 24.0;
    series = series * rest + 1.0 / 6.0;
    series = series * rest + 0.5;
    series = series * rest + 1.0;
    series = series * rest + 1.0;
    const auto biased_exponent = static_cast<std::uint64_t>(static_cast<std::int64_t>(power) + 1023);
    return series * std::bit_cast<double>(biased_exponent << 52U);
}

} // namespace vkbake
