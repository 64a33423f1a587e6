#include "vkbake/compare.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "base/luminance.hpp"
#include "vkbake/error.hpp"

namespace vkbake {
namespace {

bool covers(const Image& image, std::size_t texel) {
    return (image.coverage.empty() ? image.texels[texel].w : image.coverage[texel]) > 0.5F;
}

bool finite(const glm::vec4& texel) {
    return std::isfinite(texel.x) && std::isfinite(texel.y) && std::isfinite(texel.z);
}

std::string size_of(const Image& image) { return std::to_string(image.width) + " × " + std::to_string(image.height); }

/// Sums over the channels of the texels that count.
struct Sums {
    double a = 0.0;
    double b = 0.0;
    double squares = 0.0;
    double luminance_a = 0.0;
    double luminance_squares = 0.0;
};

/// 0 for 0 ÷ 0.
double relative(double error, double mean) {
    return error == 0.0 ? 0.0 : (mean != 0.0 ? error / mean : std::numeric_limits<double>::infinity());
}

void compare_texel(const Image& a, const Image& b, std::size_t texel, Comparison& result, Sums& sums) {
    glm::vec4& difference = result.difference.texels[texel];
    difference.w = 1.0F;
    const double luminance_a = luminance(glm::dvec3(a.texels[texel]));
    const double luminance_error = luminance(glm::dvec3(b.texels[texel])) - luminance_a;
    sums.luminance_a += luminance_a;
    sums.luminance_squares += luminance_error * luminance_error;
    for (int channel = 0; channel < 3; ++channel) {
        const double value_a = static_cast<double>(a.texels[texel][channel]);
        const double value_b = static_cast<double>(b.texels[texel][channel]);
        const double distance = std::abs(value_a - value_b);
        sums.a += value_a;
        sums.b += value_b;
        sums.squares += distance * distance;
        difference[channel] = static_cast<float>(distance);
        if (distance > result.maximum) {
            result.maximum = distance;
            result.maximum_x = static_cast<int>(texel % static_cast<std::size_t>(a.width));
            result.maximum_y = static_cast<int>(texel / static_cast<std::size_t>(a.width));
        }
    }
}

} // namespace

Comparison compare(const Image& a, const Image& b) {
    if (a.width != b.width || a.height != b.height) {
        throw Error(ErrorKind::bad_input, "comparison: the images have different sizes, " + size_of(a) + " and " +
                                              size_of(b) + " texels; give two of one size");
    }
    Comparison result;
    result.difference = {a.width, a.height, std::vector<glm::vec4>(a.texels.size(), glm::vec4(0.0F)), {}};
    Sums sums;
    for (std::size_t texel = 0; texel < a.texels.size(); ++texel) {
        const bool in_a = covers(a, texel);
        const bool in_b = covers(b, texel);
        result.covered_a += in_a ? 1U : 0U;
        result.covered_b += in_b ? 1U : 0U;
        if (!in_a || !in_b) {
            continue;
        }
        ++result.covered_both;
        if (finite(a.texels[texel]) && finite(b.texels[texel])) {
            compare_texel(a, b, texel, result, sums);
        } else {
            ++result.not_finite;
        }
    }
    if (result.covered_both == result.not_finite) {
        throw Error(ErrorKind::bad_input, std::string("comparison: no texel is ") +
                                              (result.covered_both == 0 ? "covered" : "finite") +
                                              " in both images; give two maps of the same UVs");
    }
    const double values = 3.0 * static_cast<double>(result.covered_both - result.not_finite);
    result.mean_a = sums.a / values;
    result.mean_b = sums.b / values;
    result.root_mean_square = std::sqrt(sums.squares / values);
    result.relative_root_mean_square = relative(result.root_mean_square, result.mean_a);
    const double texels = values / 3.0;
    result.relative_luminance_rmse = relative(std::sqrt(sums.luminance_squares / texels), sums.luminance_a / texels);
    return result;
}

} // namespace vkbake
