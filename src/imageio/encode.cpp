#include "imageio/encode.hpp"

#include "imageio/load_codec.hpp"

namespace vkbake {

EncodedFile encode_image(const Image& image, ImageFormat format, const Attributes& attributes, const Poll& poll) {
    return codec().encode(image, format, attributes, poll);
}

std::vector<std::uint8_t> encode_srgb_png(int width, int height, std::span<const std::uint8_t> texels,
                                          const Attributes& attributes, const Poll& poll) {
    return codec().encode_png(width, height, 3, texels, "sRGB", attributes, poll);
}

std::vector<std::uint8_t> encode_grey_png(int width, int height, std::span<const std::uint8_t> texels,
                                          const Attributes& attributes, const Poll& poll) {
    return codec().encode_png(width, height, 1, texels, "Linear", attributes, poll);
}

} // namespace vkbake
