// Textures made ready to tell what surfaces reflect and emit.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "vkbake/scene.hpp"

namespace vkbake {

/// Linear colours, row-major, row 0 at the top.
struct ColorTexture {
    int width = 0; ///< 0: not needed, not there
    int height = 0;
    std::vector<glm::vec3> texels;
};

enum class Encoding : std::uint8_t { linear, srgb };

/// Longer sides are halved until they are no longer than this: light that comes back from a surface is a mean over far
/// more of it than a texel of its picture, and a picture of 8192² would be 800 MB.
inline constexpr int most_color_texels = 512;

/// `rgba`: four bytes a texel. Halves by the mean of 2 × 2 linear colours, so that the mean over the picture stays (a
/// last odd row or column counts with the one before it).
[[nodiscard]] ColorTexture make_color_texture(int width, int height, std::span<const std::uint8_t> rgba,
                                              Encoding encoding);

/// The texel at uv, which TextureUse's transform has not been applied to yet. Uvs that are not finite: the first texel.
[[nodiscard]] glm::vec3 color_at(const ColorTexture& texture, const TextureUse& use, const glm::vec2& uv);

} // namespace vkbake
