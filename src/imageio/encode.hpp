// Images → the bytes of image files. The same image gives the same bytes: no file carries a time.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "vkbake/image.hpp"

namespace vkbake {

enum class ImageFormat : std::uint8_t {
    exr,   ///< channels R, G, B, A and, where the image has it, coverage; 32-bit floats, bit by bit; tiles of 64², zip
    hdr,   ///< Radiance RGBE: RGB rounded to 8 bits of the largest channel; no alpha, no coverage
    png16, ///< linear values in [0,1] × 65535, rounded
    png8,  ///< values in [0,1] × 255, rounded, not encoded any further
};

/// Names and values that go into the file's metadata, in this order (EXR sorts them; HDR keeps none).
using Attributes = std::vector<std::pair<std::string, std::string>>;

struct EncodedFile {
    std::vector<std::uint8_t> bytes;
    /// Channels (of red, green, blue) that the format cannot hold and that were changed: NaN is written as 0, what is
    /// below the format's range as its least value and what is above as its largest. Rounding does not count. EXR holds
    /// all.
    std::uint64_t changed_values = 0;
};

/// Called between bands of rows and blocks of bytes, so many times a second; what it throws ends the work. May be
/// empty.
using Poll = std::function<void()>;

/// PNG files have alpha only where it is not 1 everywhere. Throws Error{output} where the image's arrays do not fit its
/// size.
[[nodiscard]] EncodedFile encode_image(const Image& image, ImageFormat format, const Attributes& attributes = {},
                                       const Poll& poll = {});

/// A PNG of three channels from sRGB-encoded bytes: 3 · width · height. Throws Error{output}.
[[nodiscard]] std::vector<std::uint8_t> encode_srgb_png(int width, int height, std::span<const std::uint8_t> texels,
                                                        const Attributes& attributes = {}, const Poll& poll = {});

/// As encode_srgb_png, from linear values: 1 channel.
[[nodiscard]] std::vector<std::uint8_t> encode_grey_png(int width, int height, std::span<const std::uint8_t> texels,
                                                        const Attributes& attributes = {}, const Poll& poll = {});

} // namespace vkbake
