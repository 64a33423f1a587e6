// A picture made ready for bilinear look-ups.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

namespace vkbake {

/// RGB floats with a ring of one texel around them, so that a look-up never asks where a border leads. Whoever makes
/// one fills the ring: by wrapping, by clamping, from the neighbouring face of a cube.
class BorderedImage {
public:
    BorderedImage(int width, int height)
        : m_width(width), m_height(height),
          m_texels((static_cast<std::size_t>(width) + 2) * (static_cast<std::size_t>(height) + 2)) {}

    [[nodiscard]] int width() const { return m_width; }
    [[nodiscard]] int height() const { return m_height; }

    /// −1 ≤ x ≤ width, −1 ≤ y ≤ height.
    [[nodiscard]] glm::vec3& at(int x, int y) { return m_texels[index(x, y)]; }
    [[nodiscard]] const glm::vec3& at(int x, int y) const { return m_texels[index(x, y)]; }

    /// Bilinear between texel centres. u, v in [0, 1]; (0, 0) is the upper left corner. What lies outside is brought
    /// back. A texel whose weight is 0 is not looked at, so that a value that is no number stays in its place.
    [[nodiscard]] glm::vec3 sample(double u, double v) const;

private:
    [[nodiscard]] std::size_t index(int x, int y) const {
        return (static_cast<std::size_t>(y) + 1) * (static_cast<std::size_t>(m_width) + 2) +
               static_cast<std::size_t>(x) + 1;
    }

    int m_width;
    int m_height;
    std::vector<glm::vec3> m_texels;
};

namespace sky_image {

/// The cell [low, low + 1] between texel centres that holds a coordinate, and where in it the coordinate lies.
struct Cell {
    int low = 0;
    float share = 0.0F; ///< 0 … 1
};

[[nodiscard]] inline Cell cell(double coordinate, int size) {
    const double centred = coordinate * size - 0.5;
    const double least = -0.5;
    const double greatest = size - 0.5;
    const double inside = centred > least ? (centred < greatest ? centred : greatest) : least;
    // Truncation towards zero of a value that is at least 0 is floor, without a library call.
    const int low = static_cast<int>(inside + 1.0) - 1;
    return {low, static_cast<float>(inside - low)};
}

} // namespace sky_image

inline glm::vec3 BorderedImage::sample(double u, double v) const {
    const sky_image::Cell x = sky_image::cell(u, m_width);
    const sky_image::Cell y = sky_image::cell(v, m_height);
    const glm::vec3* const upper = &m_texels[index(x.low, y.low)];
    const glm::vec3* const lower = upper + m_width + 2;
    const auto blend = [](const glm::vec3& first, const glm::vec3& second, float share) {
        if (share == 0.0F) {
            return first;
        }
        // In this form an image of one value gives that value to the bit.
        return share == 1.0F ? second : first + (second - first) * share;
    };
    return blend(blend(upper[0], upper[1], x.share), blend(lower[0], lower[1], x.share), y.share);
}

} // namespace vkbake
