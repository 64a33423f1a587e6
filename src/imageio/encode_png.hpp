// Rows of numbers → the bytes of PNG files, by libpng.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "codec/codec.hpp"

namespace vkbake {

struct PngLayout {
    int width = 0;
    int height = 0;
    int channels = 3;  ///< 1: grey, 3: RGB, 4: RGB and alpha
    int bits = 8;      ///< of a value: 8 or 16
    bool srgb = false; ///< values are sRGB-encoded; false: they are linear

    [[nodiscard]] std::size_t row_bytes() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(channels) *
               static_cast<std::size_t>(bits / 8);
    }
};

/// The row_bytes() of a row, values of 16 bits with the high byte first. Called once a row, from the top.
using PngRow = std::function<const std::uint8_t*(int y)>;

/// Throws Error{output}, and what `row` and `poll` throw.
[[nodiscard]] std::vector<std::uint8_t> encode_png(const PngLayout& layout, const Attributes& attributes,
                                                   const PngRow& row, const Poll& poll);

/// Values of a light map, in [0,1], as ImageFormat::png8 and png16 say; alpha only where it is not 1 everywhere. The
/// image's arrays fit its size. Throws Error{output}.
[[nodiscard]] EncodedFile encode_png(const Image& image, int bits, const Attributes& attributes, const Poll& poll);

} // namespace vkbake
