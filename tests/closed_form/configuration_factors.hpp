// Configuration factors in closed form: the share of what leaves a surface element that arrives at another surface,
// which is the cosine-weighted share of its hemisphere that the other surface covers. All from R. Siegel and J. R.
// Howell, Thermal Radiation Heat Transfer, appendix of configuration factors; also J. R. Howell, A Catalog of Radiation
// Heat Transfer Configuration Factors.
#pragma once

#include <cmath>
#include <numbers>

namespace vkbake::test {

/// Element to a rectangle a × b in a parallel plane at distance c, one of whose corners is on the element's normal.
inline double element_to_parallel_rectangle(double a, double b, double c) {
    const double x = a / c;
    const double y = b / c;
    const double along = std::sqrt(1.0 + x * x);
    const double across = std::sqrt(1.0 + y * y);
    return (x / along * std::atan(y / along) + y / across * std::atan(x / across)) / (2.0 * std::numbers::pi);
}

/// Element to a rectangle in a plane at right angles to the element's, at distance c from it: `height` high from the
/// element's plane, `width` wide from the foot of the perpendicular onto it.
inline double element_to_perpendicular_rectangle(double height, double width, double c) {
    const double x = height / width;
    const double y = c / width;
    const double far = std::sqrt(x * x + y * y);
    return (std::atan(1.0 / y) - y / far * std::atan(1.0 / far)) / (2.0 * std::numbers::pi);
}

/// Square to an equal, parallel, directly opposed square; `ratio` is side by distance.
inline double square_to_opposed_square(double ratio) {
    const double x = ratio;
    const double square = 1.0 + x * x;
    const double root = std::sqrt(square);
    return 2.0 / (std::numbers::pi * x * x) *
           (0.5 * std::log(square * square / (1.0 + 2.0 * x * x)) + 2.0 * x * root * std::atan(x / root) -
            2.0 * x * std::atan(x));
}

/// Element to a sphere that lies wholly above its horizon; `cosine` between its normal and the direction of the centre.
inline double element_to_sphere(double radius, double distance, double cosine) {
    return cosine * radius * radius / (distance * distance);
}

} // namespace vkbake::test
