// What a preview shows of known radiance.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include "preview/preview.hpp"

namespace vkbake::test {

/// Looks along −Z, 90° high.
inline Camera camera_at_origin() {
    Camera camera;
    camera.vertical_field_of_view = std::acos(0.0);
    return camera;
}

inline PreviewSettings square(int side) { return {.width = side, .height = side, .exposure = 1.0, .samples = 2}; }

/// What the display shows for linear radiance: Khronos PBR Neutral as its specification states it, then sRGB; in
/// double.
inline glm::dvec3 displayed(const glm::dvec3& radiance) {
    const double least = std::min({radiance.r, radiance.g, radiance.b});
    const double offset = least <= 0.08 ? least - least * least / (4.0 * 0.04) : 0.04;
    const glm::dvec3 reduced = radiance - offset;
    const double peak = std::max({reduced.r, reduced.g, reduced.b});
    glm::dvec3 mapped = reduced;
    if (peak > 0.76) {
        const double compressed = 1.0 - (1.0 - 0.76) * (1.0 - 0.76) / (peak + 1.0 - 2.0 * 0.76);
        const double saturation = 1.0 / (0.15 * (peak - compressed) + 1.0);
        mapped = glm::dvec3(compressed) * (1.0 - saturation) + reduced * (compressed / peak) * saturation;
    }
    const auto encode = [](double v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055; };
    return {encode(mapped.r), encode(mapped.g), encode(mapped.b)};
}

inline void expect_shows(const Image& picture, int x, int y, const glm::dvec3& radiance) {
    const glm::dvec3 expected = displayed(radiance);
    const glm::vec4& pixel = picture.texels.at(picture.index(x, y));
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(pixel[channel], expected[channel], 2e-4) << "pixel " << x << ", " << y << " channel " << channel;
    }
    EXPECT_EQ(pixel.a, 1.0F);
}

inline Image map_of(int width, const std::vector<glm::vec3>& values) {
    Image map{.width = width, .height = static_cast<int>(values.size()) / width, .texels = {}, .coverage = {}};
    for (const glm::vec3& value : values) {
        map.texels.emplace_back(value, 1.0F);
    }
    return map;
}

} // namespace vkbake::test
