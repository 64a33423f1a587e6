#include "material/color_texture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/srgb.hpp"
#include "base/texture_transform.hpp"

namespace vkbake {

namespace {

std::array<float, 256> linear_values(Encoding encoding) {
    std::array<float, 256> values{};
    for (std::size_t byte = 0; byte < values.size(); ++byte) {
        const double value = static_cast<double>(byte) / 255.0;
        values[byte] = static_cast<float>(encoding == Encoding::srgb ? srgb_to_linear(value) : value);
    }
    return values;
}

/// The range of texels that one texel of half the size stands for.
struct Span {
    int begin;
    int end;
};

Span halved(int texel, int size, int half) { return {2 * texel, texel + 1 == half ? size : 2 * texel + 2}; }

ColorTexture half_of(const ColorTexture& texture) {
    ColorTexture half{std::max(texture.width / 2, 1), std::max(texture.height / 2, 1), {}};
    half.texels.reserve(static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
    for (int y = 0; y < half.height; ++y) {
        const Span rows = halved(y, texture.height, half.height);
        for (int x = 0; x < half.width; ++x) {
            const Span columns = halved(x, texture.width, half.width);
            glm::vec3 sum(0.0F);
            for (int row = rows.begin; row < rows.end; ++row) {
                for (int column = columns.begin; column < columns.end; ++column) {
                    sum += texture.texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(texture.width) +
                                          static_cast<std::size_t>(column)];
                }
            }
            half.texels.push_back(sum / static_cast<float>((rows.end - rows.begin) * (columns.end - columns.begin)));
        }
    }
    return half;
}

int wrapped(float coordinate, Wrap wrap, int size) {
    if (!std::isfinite(coordinate)) {
        return 0;
    }
    float inside = coordinate;
    if (wrap == Wrap::repeat) {
        inside = coordinate - std::floor(coordinate);
    } else if (wrap == Wrap::mirror) {
        const float turn = coordinate - 2.0F * std::floor(0.5F * coordinate);
        inside = turn > 1.0F ? 2.0F - turn : turn;
    }
    const float texel = std::floor(std::clamp(inside, 0.0F, 1.0F) * static_cast<float>(size));
    return std::min(static_cast<int>(texel), size - 1);
}

} // namespace

ColorTexture make_color_texture(int width, int height, std::span<const std::uint8_t> rgba, Encoding encoding) {
    const std::array<float, 256> values = linear_values(encoding);
    ColorTexture texture{width, height, {}};
    texture.texels.reserve(rgba.size() / 4);
    for (std::size_t texel = 0; texel + 3 < rgba.size(); texel += 4) {
        texture.texels.emplace_back(values[rgba[texel]], values[rgba[texel + 1]], values[rgba[texel + 2]]);
    }
    while (std::max(texture.width, texture.height) > most_color_texels) {
        texture = half_of(texture);
    }
    return texture;
}

glm::vec3 color_at(const ColorTexture& texture, const TextureUse& use, const glm::vec2& uv) {
    const glm::vec2 at(TextureTransform(use)(uv));
    const int x = wrapped(at.x, use.wrap_u, texture.width);
    const int y = wrapped(at.y, use.wrap_v, texture.height);
    return texture
        .texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(texture.width) + static_cast<std::size_t>(x)];
}

} // namespace vkbake
