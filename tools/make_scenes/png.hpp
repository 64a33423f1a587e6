// PNG files, written the same way everywhere.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vkbake::scenes {

struct PaletteImage {
    std::uint32_t side = 0;                           ///< texels, even
    std::vector<std::array<std::uint8_t, 3>> palette; ///< sRGB, at most 16
    std::vector<std::uint8_t> texels;                 ///< side², row 0 on top, each below palette.size()
    bool first_is_clear = false;                      ///< the palette's first colour has alpha 0, the others 1
};

/// The image at 4 bits a texel, its deflate stream stored and not compressed: a compressor's choices are not ours to
/// fix.
[[nodiscard]] std::vector<std::byte> encode_png(const PaletteImage& image);

struct ColorImage {
    std::uint32_t side = 0;                          ///< texels
    std::vector<std::array<std::uint8_t, 3>> texels; ///< side², row 0 on top
};

/// At 24 bits a texel, else the same.
[[nodiscard]] std::vector<std::byte> encode_png(const ColorImage& image);

} // namespace vkbake::scenes
