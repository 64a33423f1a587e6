#include "imageio/color_difference.hpp"

#include <cmath>
#include <numbers>

#include "base/srgb.hpp"
#include "vkbake/compare.hpp"
#include "vkbake/error.hpp"

namespace vkbake {
namespace {

constexpr double degrees(double radians) { return radians * (180.0 / std::numbers::pi); }
double cosine(double angle) { return std::cos(angle * (std::numbers::pi / 180.0)); }
double sine(double angle) { return std::sin(angle * (std::numbers::pi / 180.0)); }

/// CIE 15: the cube root, and a straight line where it is too steep.
double compressed(double share) {
    constexpr double delta = 6.0 / 29.0;
    return share > delta * delta * delta ? std::cbrt(share) : share / (3.0 * delta * delta) + 4.0 / 29.0;
}

/// Of a mean chroma: √(C⁷ / (C⁷ + 25⁷)).
double chroma_share(double chroma) {
    const double seventh = std::pow(chroma, 7.0);
    return std::sqrt(seventh / (seventh + 6103515625.0));
}

struct Hue {
    double chroma = 0.0;
    double angle = 0.0; ///< degrees, [0, 360)
};

Hue hue_of(double a, double b) {
    const double angle = a == 0.0 && b == 0.0 ? 0.0 : degrees(std::atan2(b, a));
    return {std::hypot(a, b), angle < 0.0 ? angle + 360.0 : angle};
}

/// From the one to the other, (−180, 180]; 0 where one has none.
double hue_step(const Hue& from, const Hue& to) {
    if (from.chroma * to.chroma == 0.0) {
        return 0.0;
    }
    const double step = to.angle - from.angle;
    return step > 180.0 ? step - 360.0 : step < -180.0 ? step + 360.0 : step;
}

double mean_hue(const Hue& a, const Hue& b) {
    const double sum = a.angle + b.angle;
    if (a.chroma * b.chroma == 0.0) {
        return sum;
    }
    if (std::abs(a.angle - b.angle) <= 180.0) {
        return 0.5 * sum;
    }
    return sum < 360.0 ? 0.5 * (sum + 360.0) : 0.5 * (sum - 360.0);
}

glm::dvec3 linear_of(const glm::vec4& encoded) {
    return {srgb_to_linear(static_cast<double>(encoded.x)), srgb_to_linear(static_cast<double>(encoded.y)),
            srgb_to_linear(static_cast<double>(encoded.z))};
}

bool is_black(const glm::vec4& pixel) { return pixel.x == 0.0F && pixel.y == 0.0F && pixel.z == 0.0F; }

} // namespace

glm::dvec3 lab_of(const glm::dvec3& linear) {
    // IEC 61966-2-1's matrix; each row's sum is the white's coordinate.
    const double x = compressed((0.4124 * linear.x + 0.3576 * linear.y + 0.1805 * linear.z) / 0.9505);
    const double y = compressed(0.2126 * linear.x + 0.7152 * linear.y + 0.0722 * linear.z);
    const double z = compressed((0.0193 * linear.x + 0.1192 * linear.y + 0.9505 * linear.z) / 1.0890);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

double ciede2000(const glm::dvec3& a, const glm::dvec3& b) {
    const double widening = 1.5 - 0.5 * chroma_share(0.5 * (std::hypot(a.y, a.z) + std::hypot(b.y, b.z)));
    const Hue hue_a = hue_of(widening * a.y, a.z);
    const Hue hue_b = hue_of(widening * b.y, b.z);

    const double lightness_step = b.x - a.x;
    const double chroma_step = hue_b.chroma - hue_a.chroma;
    const double hue_distance = 2.0 * std::sqrt(hue_a.chroma * hue_b.chroma) * sine(0.5 * hue_step(hue_a, hue_b));

    const double from_middle = 0.5 * (a.x + b.x) - 50.0;
    const double chroma = 0.5 * (hue_a.chroma + hue_b.chroma);
    const double hue = mean_hue(hue_a, hue_b);
    const double by_hue = 1.0 - 0.17 * cosine(hue - 30.0) + 0.24 * cosine(2.0 * hue) + 0.32 * cosine(3.0 * hue + 6.0) -
                          0.20 * cosine(4.0 * hue - 63.0);
    const double in_lightness =
        lightness_step / (1.0 + 0.015 * from_middle * from_middle / std::sqrt(20.0 + from_middle * from_middle));
    const double in_chroma = chroma_step / (1.0 + 0.045 * chroma);
    const double in_hue = hue_distance / (1.0 + 0.015 * chroma * by_hue);
    const double blue = (hue - 275.0) / 25.0;
    const double turn = -sine(60.0 * std::exp(-blue * blue)) * 2.0 * chroma_share(chroma);
    return std::sqrt(in_lightness * in_lightness + in_chroma * in_chroma + in_hue * in_hue + turn * in_chroma * in_hue);
}

double color_difference(const Image& a, const Image& b) {
    if (a.width != b.width || a.height != b.height) {
        throw Error(ErrorKind::bad_input, "comparison: the pictures differ in size; give two of one size");
    }
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < a.texels.size(); ++i) {
        if (!is_black(a.texels[i]) || !is_black(b.texels[i])) {
            sum += ciede2000(lab_of(linear_of(a.texels[i])), lab_of(linear_of(b.texels[i])));
            count += 1.0;
        }
    }
    return count > 0.0 ? sum / count : 0.0;
}

} // namespace vkbake
