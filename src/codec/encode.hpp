// Images → the bytes of files, by OpenImageIO; as Codec says.
#pragma once

#include "codec/codec.hpp"

namespace vkbake {

[[nodiscard]] EncodedFile encode_file(const Image& image, ImageFormat format, const Attributes& attributes,
                                      const Poll& poll);

[[nodiscard]] std::vector<std::uint8_t> encode_png_bytes(int width, int height, int channels,
                                                         std::span<const std::uint8_t> texels, std::string_view space,
                                                         const Attributes& attributes, const Poll& poll);

} // namespace vkbake
