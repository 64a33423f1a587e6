// Elementary functions whose bits do not depend on the machine's mathematics library.
//
// Made of additions, multiplications, divisions and square roots alone, which IEEE 754 rounds correctly everywhere; a
// library's sin may differ in the last place between versions and even between processors. The bounds are those
// of the truncated Taylor series; rounding adds a few units of 2⁻⁵³.
#pragma once

#include <cmath>
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

} // namespace vkbake
