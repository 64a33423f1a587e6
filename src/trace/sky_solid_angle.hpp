// The solid angle of a texel of a sky's picture.
#pragma once

#include <cmath>
#include <numbers>

namespace vkbake {

/// Of a cube's face of size × size texels, at (x, y) texels from the first one's centre: dω = dA / |d|³.
[[nodiscard]] inline double cube_solid_angle(double x, double y, int size) {
    const double a = 2.0 * (x + 0.5) / size - 1.0;
    const double b = 2.0 * (y + 0.5) / size - 1.0;
    const double square = 1.0 + a * a + b * b;
    return 4.0 / (static_cast<double>(size) * size) / (square * std::sqrt(square));
}

/// Of an equirectangular picture where the sine of the polar angle is that.
[[nodiscard]] inline double panorama_solid_angle(double sine, int width, int height) {
    return 2.0 * std::numbers::pi / width * (std::numbers::pi / height) * sine;
}

} // namespace vkbake
