// Textures that decide what gets through a surface: a byte a texel, looked up as their samplers say.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "base/texture_transform.hpp"
#include "vkbake/scene.hpp"

namespace vkbake {

/// One channel of a picture, row-major, row 0 at the top.
struct ByteTexture {
    int width = 0; ///< 0: not needed, not there
    int height = 0;
    std::vector<std::uint8_t> texels;
};

/// Longer sides are halved until they are no longer than this. Leaves and lattices are cut out texel by texel, so what
/// pictures commonly have stays whole.
inline constexpr int most_opacity_texels = 4096;

/// `rgba`: four bytes a texel. Halves by the mean of 2 × 2 bytes, rounded (a last odd row or column is left out).
[[nodiscard]] ByteTexture make_byte_texture(int width, int height, std::span<const std::uint8_t> rgba,
                                            std::size_t channel);

/// What each byte stands for, 0 … 255, ascending.
using ByteValues = std::array<float, 256>;
[[nodiscard]] ByteValues linear_values();
[[nodiscard]] ByteValues srgb_values();

/// A picture's least and greatest byte in some rectangle.
struct ByteRange {
    std::uint8_t least = 255;
    std::uint8_t greatest = 0;
};

/// A TextureUse made ready for many look-ups: the same bits on every machine.
class TextureSampler {
public:
    explicit TextureSampler(const TextureUse& use);

    /// KHR_texture_transform: where in the picture, (0, 0) its upper left corner, (1, 1) its lower right.
    [[nodiscard]] glm::dvec2 place(const glm::dvec2& uv) const { return m_transform(uv); }
    /// At a place: the texel that it lies in, or what is interpolated between the four around it, as the sampler says
    /// of magnification; 0 … 1. Linear values are never outside what these have (differences of bytes are exact, and
    /// rounding is monotone). A place that is not finite, or 2³⁰ or more away: the first texel.
    [[nodiscard]] float value(const ByteTexture& texture, const ByteValues& values, const glm::dvec2& place) const;

    /// The texels that look-ups in a rectangle of places may touch, along one axis: of [first, last] by turns; the
    /// whole picture if it is larger.
    struct Span {
        int first = 0;
        int last = 0;
    };
    /// One span or two; `axis`: 0 or 1.
    [[nodiscard]] std::array<Span, 2> touched(int axis, double low, double high, int size) const;

private:
    TextureTransform m_transform;
    std::array<Wrap, 2> m_wrap{};
    Filter m_filter = Filter::linear;
};

/// Least and greatest bytes of a texture's parts, from coarse to fine: the range over any rectangle costs a few cells.
class TextureRanges {
public:
    explicit TextureRanges(const ByteTexture& texture);

    /// Of at least the texels that look-ups between two places may touch. Places that are not finite: of all.
    [[nodiscard]] ByteRange within(const TextureSampler& sampler, const glm::dvec2& low, const glm::dvec2& high) const;

private:
    struct Level {
        int width = 0;
        int height = 0;
        std::vector<ByteRange> cells;
    };
    void gather(const TextureSampler::Span& columns, const TextureSampler::Span& rows, ByteRange& range) const;

    int m_width;
    int m_height;
    std::vector<Level> m_levels; ///< cells of 2 × 2 texels, of 4 × 4 and so on
};

} // namespace vkbake
