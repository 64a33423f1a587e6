#include "trace/byte_texture.hpp"

#include <algorithm>
#include <cmath>

#include "base/srgb.hpp"

namespace vkbake {

namespace {

std::size_t texel_at(const ByteTexture& texture, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(texture.width) + static_cast<std::size_t>(x);
}

ByteTexture halved(const ByteTexture& texture) {
    ByteTexture half{std::max(texture.width / 2, 1), std::max(texture.height / 2, 1), {}};
    half.texels.reserve(static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
    for (int y = 0; y < half.height; ++y) {
        for (int x = 0; x < half.width; ++x) {
            const int right = std::min(2 * x + 1, texture.width - 1);
            const int below = std::min(2 * y + 1, texture.height - 1);
            const unsigned sum =
                texture.texels[texel_at(texture, 2 * x, 2 * y)] + texture.texels[texel_at(texture, right, 2 * y)] +
                texture.texels[texel_at(texture, 2 * x, below)] + texture.texels[texel_at(texture, right, below)];
            half.texels.push_back(static_cast<std::uint8_t>((sum + 2) / 4));
        }
    }
    return half;
}

/// Places beyond this have no fraction left that a texture coordinate in float could have had.
constexpr double farthest_place = 0x1p30;

/// Of |value| up to 2³⁰. std::floor is a call on machines whose least instruction set has none.
int floor_of(double value) {
    const auto towards_zero = static_cast<int>(value);
    return towards_zero - (towards_zero > value ? 1 : 0);
}

/// Into the range in which wrapping is a matter of one picture beside the next: [0, 1), mirrored [0, 2), clamped [0,
/// 1].
double folded(double place, Wrap wrap) {
    switch (wrap) {
    case Wrap::clamp:
        return std::clamp(place, 0.0, 1.0);
    case Wrap::mirror:
        return place - 2.0 * floor_of(0.5 * place);
    case Wrap::repeat:
        break;
    }
    return place - floor_of(place);
}

/// A texel's number, of one picture or of those beside it, as one of this picture.
int wrapped(int texel, Wrap wrap, int size) {
    if (wrap == Wrap::clamp) {
        return std::clamp(texel, 0, size - 1);
    }
    const int period = wrap == Wrap::mirror ? 2 * size : size;
    int inside = texel;
    if (texel < 0 || texel >= period) { // a division is worth a branch
        inside = ((texel % period) + period) % period;
    }
    return inside < size ? inside : period - 1 - inside;
}

struct Taps {
    int first = 0;
    int second = 0;
    float share = 0.0F; ///< of the second
};

Taps taps(double place, Wrap wrap, Filter filter, int size) {
    if (!(std::abs(place) < farthest_place)) {
        return {};
    }
    const double texels = folded(place, wrap) * size;
    if (filter == Filter::nearest) {
        const int texel = wrapped(floor_of(texels), wrap, size);
        return {texel, texel, 0.0F};
    }
    const int first = floor_of(texels - 0.5);
    return {wrapped(first, wrap, size), wrapped(first + 1, wrap, size), static_cast<float>(texels - 0.5 - first)};
}

float blend(float from, float to, float share) { return from + (to - from) * share; }

} // namespace

ByteTexture make_byte_texture(int width, int height, std::span<const std::uint8_t> rgba, std::size_t channel) {
    ByteTexture texture{width, height, {}};
    texture.texels.reserve(rgba.size() / 4);
    for (std::size_t at = channel; at < rgba.size(); at += 4) {
        texture.texels.push_back(rgba[at]);
    }
    while (std::max(texture.width, texture.height) > most_opacity_texels) {
        texture = halved(texture);
    }
    return texture;
}

ByteValues linear_values() {
    ByteValues values{};
    for (std::size_t byte = 0; byte < values.size(); ++byte) {
        values[byte] = static_cast<float>(byte);
    }
    return values;
}

ByteValues srgb_values() {
    ByteValues values{};
    for (std::size_t byte = 0; byte < values.size(); ++byte) {
        values[byte] = static_cast<float>(255.0 * srgb_to_linear(static_cast<double>(byte) / 255.0));
    }
    return values;
}

TextureSampler::TextureSampler(const TextureUse& use)
    : m_transform(use), m_wrap{use.wrap_u, use.wrap_v}, m_filter(use.filter) {}

float TextureSampler::value(const ByteTexture& texture, const ByteValues& values, const glm::dvec2& place) const {
    const Taps columns = taps(place.x, m_wrap[0], m_filter, texture.width);
    const Taps rows = taps(place.y, m_wrap[1], m_filter, texture.height);
    const auto at = [&](int x, int y) { return values[texture.texels[texel_at(texture, x, y)]]; };
    const float upper = blend(at(columns.first, rows.first), at(columns.second, rows.first), columns.share);
    const float lower = blend(at(columns.first, rows.second), at(columns.second, rows.second), columns.share);
    return blend(upper, lower, rows.share) / 255.0F;
}

std::array<TextureSampler::Span, 2> TextureSampler::touched(int axis, double low, double high, int size) const {
    const Wrap wrap = m_wrap.at(static_cast<std::size_t>(axis));
    const Span whole{0, size - 1};
    if (wrap == Wrap::clamp) {
        low = std::clamp(low, 0.0, 1.0);
        high = std::clamp(high, 0.0, 1.0);
    }
    // A texel more on either side than a look-up between texel centres touches: for the rounding of places.
    const double begin = std::floor(low * size - 1.5);
    const double end = std::floor(high * size + 1.5);
    if (!(end - begin < size - 1.0) || std::abs(begin) > farthest_place || std::abs(end) > farthest_place) { // NaN too
        return {whole, whole};
    }
    const int first = wrapped(static_cast<int>(begin), wrap, size);
    const int last = wrapped(static_cast<int>(end), wrap, size);
    if (wrap == Wrap::mirror) {
        // Within one turn the texels between the ends are touched; around a border, all from the nearer one on.
        const double turns = std::floor(begin / size);
        if (turns == std::floor(end / size)) {
            return {Span{std::min(first, last), std::max(first, last)},
                    Span{std::min(first, last), std::max(first, last)}};
        }
        return {whole, whole};
    }
    if (first <= last) {
        return {Span{first, last}, Span{first, last}};
    }
    return {Span{first, size - 1}, Span{0, last}};
}

TextureRanges::TextureRanges(const ByteTexture& texture) : m_width(texture.width), m_height(texture.height) {
    const auto half = [](int size) { return (size + 1) / 2; };
    const auto add_level = [&](int width, int height, const auto& range_at) {
        Level level{half(width), half(height), {}};
        level.cells.resize(static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height));
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                ByteRange& cell = level.cells[static_cast<std::size_t>(y / 2) * static_cast<std::size_t>(level.width) +
                                              static_cast<std::size_t>(x / 2)];
                const ByteRange part = range_at(x, y);
                cell = {std::min(cell.least, part.least), std::max(cell.greatest, part.greatest)};
            }
        }
        m_levels.push_back(std::move(level));
    };
    add_level(m_width, m_height, [&](int x, int y) {
        const std::uint8_t byte = texture.texels[texel_at(texture, x, y)];
        return ByteRange{byte, byte};
    });
    while (m_levels.back().width > 1 || m_levels.back().height > 1) {
        const Level below = m_levels.back();
        add_level(below.width, below.height, [&](int x, int y) {
            return below.cells[static_cast<std::size_t>(y) * static_cast<std::size_t>(below.width) +
                               static_cast<std::size_t>(x)];
        });
    }
}

void TextureRanges::gather(const TextureSampler::Span& columns, const TextureSampler::Span& rows,
                           ByteRange& range) const {
    constexpr int most_cells = 4; // an axis
    std::size_t level = 0;
    while (level + 1 < m_levels.size() &&
           std::max(columns.last - columns.first, rows.last - rows.first) >> (level + 1) >= most_cells) {
        ++level;
    }
    const Level& of = m_levels[level];
    const auto shift = static_cast<int>(level) + 1;
    for (int y = rows.first >> shift; y <= rows.last >> shift; ++y) {
        for (int x = columns.first >> shift; x <= columns.last >> shift; ++x) {
            const ByteRange& cell = of.cells[static_cast<std::size_t>(y) * static_cast<std::size_t>(of.width) +
                                             static_cast<std::size_t>(x)];
            range = {std::min(range.least, cell.least), std::max(range.greatest, cell.greatest)};
        }
    }
}

ByteRange TextureRanges::within(const TextureSampler& sampler, const glm::dvec2& low, const glm::dvec2& high) const {
    ByteRange range;
    for (const TextureSampler::Span& columns : sampler.touched(0, low.x, high.x, m_width)) {
        for (const TextureSampler::Span& rows : sampler.touched(1, low.y, high.y, m_height)) {
            gather(columns, rows, range);
        }
    }
    return range;
}

} // namespace vkbake
