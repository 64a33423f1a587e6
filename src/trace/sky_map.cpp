#include "trace/sky_map.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "base/parallel.hpp"

namespace vkbake {

namespace {

constexpr int channel_bits = 9;
constexpr int greatest_exponent = 31;
constexpr int float_bias = 127;

float greatest_channel(const glm::vec3& texel) { return std::max({texel.x, texel.y, texel.z}); }

/// Biased, of the unit that a texel counts in: the least in which its greatest channel has no more than 9 bits.
int unit_exponent(float greatest) {
    int octave = 0;
    (void)std::frexp(greatest, &octave);
    return octave - channel_bits + float_bias;
}

} // namespace

SkyMap::SkyMap(int side, const FillRow& fill_row, int threads)
    : m_side(side), m_texels(static_cast<std::size_t>(side) * static_cast<std::size_t>(side)) {
    parallel_ranges(static_cast<std::size_t>(side), 8, threads, [&](std::size_t begin, std::size_t end) {
        std::vector<glm::dvec3> means(static_cast<std::size_t>(m_side));
        for (std::size_t row = begin; row < end; ++row) {
            fill_row(static_cast<int>(row), means);
            std::ranges::transform(means, &m_texels[row * means.size()],
                                   [](const glm::dvec3& mean) { return glm::vec3(mean); });
        }
    });
}

void SkyMap::pack() {
    const glm::vec3& brightest = *std::ranges::max_element(m_texels, {}, greatest_channel);
    m_least_exponent =
        static_cast<std::uint32_t>(std::max(unit_exponent(greatest_channel(brightest)) - greatest_exponent, 1));
    m_words.resize(m_texels.size() + 1);
    for (std::size_t row = 0; row < static_cast<std::size_t>(m_side); ++row) {
        pack_row(row);
    }
    m_texels = {};
}

void SkyMap::pack_row(std::size_t row) {
    const auto side = static_cast<std::size_t>(m_side);
    const auto least = static_cast<int>(m_least_exponent);
    const auto most_units = static_cast<double>((1 << channel_bits) - 1);
    glm::dvec3 left(0.0); // by rounding, of the texels before
    for (std::size_t texel = row * side; texel < (row + 1) * side; ++texel) {
        const glm::dvec3 value(m_texels[texel]);
        const int exponent = std::clamp(unit_exponent(greatest_channel(m_texels[texel])) - least, 0, greatest_exponent);
        const double unit = std::ldexp(1.0, exponent + least - float_bias);
        // No more than a unit of it: a texel far brighter than the next ones must not blacken them.
        const glm::dvec3 wanted = value / unit + glm::clamp(left / unit, -1.0, 1.0);
        const glm::dvec3 units = glm::clamp(glm::floor(wanted + 0.5), 0.0, most_units);
        left = (wanted - units) * unit;
        m_words[texel] = static_cast<std::uint32_t>(units.x) | static_cast<std::uint32_t>(units.y) << 9U |
                         static_cast<std::uint32_t>(units.z) << 18U | static_cast<std::uint32_t>(exponent) << 27U;
    }
}

glm::dvec3 SkyMap::octahedron_point(int side, double x, double y) {
    const double u = 2.0 * x / side - 1.0;
    const double v = 2.0 * y / side - 1.0;
    const double height = 1.0 - std::abs(u) - std::abs(v);
    return height >= 0.0 ? glm::dvec3(u, height, v)
                         : glm::dvec3(std::copysign(1.0 - std::abs(v), u), height, std::copysign(1.0 - std::abs(u), v));
}

void SkyMap::read(std::span<std::uint32_t> indices) const {
    for (std::uint32_t& index : indices) {
        index = m_words[index];
    }
}

} // namespace vkbake
