// Images → the bytes of image files. The same image gives the same bytes: no file carries a time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "codec/codec.hpp"
#include "vkbake/image.hpp"

namespace vkbake {

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
