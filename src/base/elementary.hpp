// Elementary functions whose bits do not depend on the machine's mathematics library.
//
// Made of additions, multiplications, divisions and square roots alone, which IEEE 754 rounds correctly everywhere; a
// library's sin or exp may differ in the last place between versions and even between processors. The bounds are those
// of the truncated Taylor series; rounding adds a few units of 2⁻⁵³.
#pragma once

#include <algorithm>
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

/// The angle of the point (x, y), in [−π, π] as std::atan2, but nothing is promised for (0, 0) beyond a finite angle.
/// Absolute error below 1e-8 (1/40,000 texel of a panorama 16384 wide). Without a branch: the octant of a random
/// direction cannot be foretold, and a wrong guess costs more than all the arithmetic.
[[nodiscard]] inline double arc_tangent(double y, double x) {
    const double across = std::abs(y);
    const double along = std::abs(x);
    const double longer = std::max(std::max(across, along), 1e-300);
    const double t = std::min(across, along) / longer;
    // arctan(t) / t on [0, 1] as a polynomial in t², interpolated at Chebyshev's nodes: within 9.8e-9 of arctan.
    const double square = t * t;
    // Summed in pairs (Estrin): half as long a chain of dependent operations as Horner's rule.
    const double fourth = square * square;
    const double low = (0.9999999817886557 - 0.33333036709286273 * square) +
                       (0.19991872029109073 - 0.14197797794085124 * square) * fourth;
    const double high = (0.10618370636953849 - 0.07456854826004547 * square) +
                        (0.042137623589193034 - 0.01573124912218365 * square) * fourth;
    const double eighth_power = fourth * fourth;
    const double series = low + (high + 0.002766283501762025 * eighth_power) * eighth_power;
    constexpr double eighth = std::numbers::pi / 4.0;
    constexpr double quarter = std::numbers::pi / 2.0;
    const double first_quadrant = eighth + std::copysign(1.0, across - along) * (eighth - t * series);
    const double upper_half = quarter - std::copysign(1.0, x) * (quarter - first_quadrant);
    return std::copysign(upper_half, y);
}

/// e^x for x ≤ 700; 0 below −700. Relative error below 3e-10: reduced to |r| ≤ ln 2 / 2, where the first term left out
/// is r⁹/9!. The thread must round to nearest (base/float_state.hpp).
[[nodiscard]] inline double exponential(double x) {
    if (!(x >= -700.0)) {
        return 0.0;
    }
    // Added and taken away, this leaves the nearest whole number, without the library call that std::floor may be.
    constexpr double whole = 0x1.8p52;
    const double power = (x * std::numbers::log2e + whole) - whole;
    // ln 2 in two parts (Cody and Waite 1980): the first has zeros at its end, so that its product with `power` is
    // exact.
    constexpr double ln2_high = 0x1.62e42fefa38p-1;
    constexpr double ln2_low = 0x1.ef35793c7673p-45;
    const double rest = (x - power * ln2_high) - power * ln2_low;
    const double square = rest * rest;
    const double fourth = square * square;
    const double low = (1.0 + rest) + (1.0 / 2.0 + rest * (1.0 / 6.0)) * square;
    const double high = (1.0 / 24.0 + rest * (1.0 / 120.0)) + (1.0 / 720.0 + rest * (1.0 / 5040.0)) * square;
    const double series = low + (high + fourth * (1.0 / 40320.0)) * fourth;
    const auto biased_exponent = static_cast<std::uint64_t>(static_cast<std::int64_t>(power) + 1023);
    return series * std::bit_cast<double>(biased_exponent << 52U);
}

} // namespace vkbake
