#include "trace/sky_image.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace vkbake {

namespace {

constexpr int least_step = -126; // of normal floats

/// The exponent of the step that packed channels count in.
int step_of(const glm::vec3& value) {
    int exponent = 0;
    (void)std::frexp(std::max({value.x, value.y, value.z}), &exponent);
    return std::max(exponent - 8, least_step);
}

/// Absent where it would not be the value.
std::optional<std::uint32_t> packed(const glm::vec3& value) {
    const int step = step_of(value);
    auto word = static_cast<std::uint32_t>(step + 127) << 24U;
    for (int channel = 0; channel < 3; ++channel) {
        const double steps = std::ldexp(static_cast<double>(value[channel]), -step);
        if (!(steps >= 0.0 && steps <= 255.0) || steps != std::floor(steps)) {
            return std::nullopt;
        }
        word |= static_cast<std::uint32_t>(steps) << (8U * static_cast<unsigned>(channel));
    }
    return word;
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

void BorderedImages::pack() {
    std::vector<std::uint32_t> words(static_cast<std::size_t>(m_count) * words_an_image(), 0);
    for (int image = 0; image < m_count; ++image) {
        const std::size_t first = static_cast<std::size_t>(image) * words_an_image();
        for (int y = -1; y <= m_height; ++y) {
            const auto row = static_cast<std::size_t>(y) + 1;
            for (int x = -1; x <= m_width; ++x) {
                const auto column = static_cast<std::size_t>(x) + 1;
                const std::optional<std::uint32_t> word = packed(at(image, x, y));
                if (!word) {
                    return;
                }
                words[first + row / 4 * words_a_band() + column / 4 * 16 + row % 4 * 4 + column % 4] = *word;
            }
        }
    }
    m_words = std::move(words);
    m_texels = {};
}

} // namespace vkbake
