// Pictures made ready for bilinear look-ups.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

namespace vkbake {

/// One or more pictures of one size, RGB floats, each with a ring of one texel around it, so that a look-up never asks
/// where a border leads. Whoever makes them fills the rings: by wrapping, by clamping, from the neighbouring face of a
/// cube.
class BorderedImages {
public:
    BorderedImages(int count, int width, int height)
        : m_width(width), m_height(height), m_texels(static_cast<std::size_t>(count) * texels_an_image()) {}

    [[nodiscard]] int width() const { return m_width; }
    [[nodiscard]] int height() const { return m_height; }

    /// −1 ≤ x ≤ width, −1 ≤ y ≤ height.
    [[nodiscard]] glm::vec3& at(int image, int x, int y) { return m_texels[place_of(image, x, y)]; }
    [[nodiscard]] const glm::vec3& at(int image, int x, int y) const { return m_texels[place_of(image, x, y)]; }

    // As floats: channel c of texel (x, y) is image · floats_an_image() + (y + 1) · floats_a_row() + (x + 1) · 3 + c.
    [[nodiscard]] const float* floats() const { return &m_texels[0].x; }
    [[nodiscard]] std::size_t float_count() const { return 3 * m_texels.size(); }
    [[nodiscard]] std::size_t floats_a_row() const { return 3 * texels_a_row(); }
    [[nodiscard]] std::size_t floats_an_image() const { return 3 * texels_an_image(); }

    /// Whether all texels are what Radiance's files hold (Ward 1991): 8 bits a channel and one exponent for all three,
    /// and no two that are not black are more than 30 octaves apart.
    [[nodiscard]] bool has_shared_exponents() const;

private:
    [[nodiscard]] std::size_t place_of(int image, int x, int y) const {
        return static_cast<std::size_t>(image) * texels_an_image() +
               (static_cast<std::size_t>(y) + 1) * texels_a_row() + static_cast<std::size_t>(x) + 1;
    }
    [[nodiscard]] std::size_t texels_a_row() const { return static_cast<std::size_t>(m_width) + 2; }
    [[nodiscard]] std::size_t texels_an_image() const {
        return texels_a_row() * (static_cast<std::size_t>(m_height) + 2);
    }

    int m_width;
    int m_height;
    std::vector<glm::vec3> m_texels;
};

/// Fills the ring of an equirectangular picture: around the horizon it wraps, at the poles it is held.
void wrap_around(BorderedImages& panorama);

// Such values near another, finite and not negative: whole steps of 1/256 … 1/128 of its greatest channel, of 2⁻¹²⁶ at
// least. The nearest, but none of more than 255 steps; and the greatest that is in no channel above it.
[[nodiscard]] glm::vec3 packed_near(const glm::vec3& value);
[[nodiscard]] glm::vec3 packed_below(const glm::vec3& value);

} // namespace vkbake
