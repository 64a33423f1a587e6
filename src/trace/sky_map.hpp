// A sky's picture made ready for look-ups of one texel a ray.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace vkbake {

/// Radiance on the sphere in an octahedral map (Engelhardt and Dachsbacher 2008): d / (|x| + |y| + |z|) is a point of
/// an octahedron, whose upper half is the middle of a square, x to the right and z down, and whose lower half is folded
/// out into its corners. No angle is needed to find a texel. What reaches a surface from a part of the sky are the
/// texels' means, as its cosine hardly changes over one of them: so a ray takes the texel that it ends in and no more.
class SkyMap {
public:
    /// Fills a row with the means of the radiance over its texels, finite and not negative.
    using FillRow = std::function<void(int row, std::span<glm::dvec3> means)>;

    /// `side`: even, 4096 at the most. `fill_row` is called once for each row, by several threads.
    SkyMap(int side, const FillRow& fill_row, int threads);

    /// Of the point (x, y), where (0, 0) is the square's upper left corner and (side, side) its lower right one: the
    /// point of the octahedron, which is a direction of length 1/√3 … 1.
    [[nodiscard]] static glm::dvec3 octahedron_point(int side, double x, double y);

    [[nodiscard]] int side() const { return m_side; }
    /// Texel (x, y) is three of them from 3 · (y · side + x) on.
    [[nodiscard]] const float* floats() const { return &m_texels[0].x; }

    /// Rounds texels to words of 32 bits: 9 bits a channel, the lowest red, and above them 5 of an exponent that they
    /// share. What rounding takes from a texel the next one in its row gets, so that a part of the sky keeps its light.
    /// After that the floats are gone.
    void pack();
    [[nodiscard]] bool is_packed() const { return !m_words.empty(); }
    /// Puts in the place of each index its word: texel (x, y) is y · side + x, and nowhere() is black. One load after
    /// the other: more of them wait for memory at a time than by gathers.
    void read(std::span<std::uint32_t> indices) const;
    [[nodiscard]] std::uint32_t nowhere() const { return static_cast<std::uint32_t>(m_words.size() - 1); }
    /// A channel's unit is the float whose biased exponent is the word's and this together.
    [[nodiscard]] std::uint32_t least_exponent() const { return m_least_exponent; }

private:
    void pack_row(std::size_t row);

    int m_side;
    std::vector<glm::vec3> m_texels;
    std::uint32_t m_least_exponent = 1;
    std::vector<std::uint32_t> m_words;
};

} // namespace vkbake
