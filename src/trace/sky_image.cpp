#include "trace/sky_image.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>

namespace vkbake {

namespace {

constexpr int least_step = -126; // of normal floats

/// The exponent of the step that packed channels count in.
int step_of(const glm::vec3& value) {
    int exponent = 0;
    (void)std::frexp(std::max({value.x, value.y, value.z}), &exponent);
    return std::max(exponent - 8, least_step);
}

glm::vec3 in_steps(const glm::vec3& value, double (*rounded)(double steps)) {
    const int step = step_of(value);
    glm::vec3 result(0.0F);
    for (int channel = 0; channel < 3; ++channel) {
        const double steps = std::ldexp(static_cast<double>(value[channel]), -step);
        result[channel] = static_cast<float>(std::ldexp(rounded(steps), step));
    }
    return result;
}

} // namespace

glm::vec3 packed_near(const glm::vec3& value) {
    return in_steps(value, [](double steps) { return std::min(std::round(steps), 255.0); });
}

glm::vec3 packed_below(const glm::vec3& value) {
    return in_steps(value, [](double steps) { return std::floor(steps); });
}

bool BorderedImages::has_shared_exponents() const {
    const auto packs = [](const glm::vec3& texel) {
        const glm::dvec3 steps = std::ldexp(1.0, -step_of(texel)) * glm::dvec3(texel);
        return steps == glm::floor(steps);
    };
    if (!std::ranges::all_of(m_texels, packs)) {
        return false;
    }
    float greatest = 0.0F;
    float least = std::numeric_limits<float>::max();
    for (const glm::vec3& texel : m_texels) {
        const float value = std::max({texel.x, texel.y, texel.z});
        greatest = std::max(greatest, value);
        least = value > 0.0F ? std::min(least, value) : least;
    }
    return greatest <= least * 0x1p30F;
}

void wrap_around(BorderedImages& panorama) {
    const int width = panorama.width();
    const int height = panorama.height();
    for (int y = 0; y < height; ++y) {
        panorama.at(0, -1, y) = panorama.at(0, width - 1, y);
        panorama.at(0, width, y) = panorama.at(0, 0, y);
    }
    for (int x = -1; x <= width; ++x) {
        panorama.at(0, x, -1) = panorama.at(0, x, 0);
        panorama.at(0, x, height) = panorama.at(0, x, height - 1);
    }
}

} // namespace vkbake
