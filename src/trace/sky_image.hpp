// Pictures made ready for bilinear look-ups.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace vkbake {

/// One or more pictures of one size, RGB floats, each with a ring of one texel around it, so that a look-up never asks
/// where a border leads. Whoever makes them fills the rings: by wrapping, by clamping, from the neighbouring face of a
/// cube.
///
/// Look-ups of random directions wait for memory, and most of the time is that. So texels that 32 bits hold exactly,
/// as those of Radiance files (Ward 1991), are packed: 8 bits a channel, the lowest red, then those of a float's
/// exponent that all three share; squares of 4 × 4 lie together, which is a cache line.
class BorderedImages {
public:
    BorderedImages(int count, int width, int height)
        : m_width(width), m_height(height), m_count(count),
          m_texels(static_cast<std::size_t>(count) * texels_an_image()) {}

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

    /// Packs the texels where that loses nothing; what is looked up keeps its bits. After that at() and the floats are
    /// gone.
    void pack();
    [[nodiscard]] bool is_packed() const { return !m_words.empty(); }

    // As words: texel (x, y) is image · words_an_image() + (Y / 4) · words_a_band() + (X / 4) · 16 + (Y % 4) · 4 +
    // X % 4, X = x + 1, Y = y + 1.
    [[nodiscard]] const std::uint32_t* words() const { return m_words.data(); }
    [[nodiscard]] std::size_t words_a_band() const { return (texels_a_row() + 3) / 4 * 16; }
    [[nodiscard]] std::size_t words_an_image() const {
        return (static_cast<std::size_t>(m_height) + 5) / 4 * words_a_band();
    }

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
    int m_count;
    std::vector<glm::vec3> m_texels;
    std::vector<std::uint32_t> m_words;
};

// What packs of a value, finite and not negative: whole steps of 1/256 … 1/128 of its greatest channel, of 2⁻¹²⁶ at
// least. The nearest, but none of more than 255 steps; and the greatest that is in no channel above it.
[[nodiscard]] glm::vec3 packed_near(const glm::vec3& value);
[[nodiscard]] glm::vec3 packed_below(const glm::vec3& value);

} // namespace vkbake
