#include "imageio/encode.hpp"

#include <string>

#include "imageio/encode_exr.hpp"
#include "imageio/encode_png.hpp"
#include "imageio/load_codec.hpp"
#include "vkbake/error.hpp"

namespace vkbake {
namespace {

[[noreturn]] void refuse_arrays(int width, int height) {
    throw Error(ErrorKind::output, "image of " + std::to_string(width) + " × " + std::to_string(height) +
                                       " texels: its arrays have other sizes; fill one value a texel and channel");
}

void check(const Image& image) {
    const bool sized = image.width > 0 && image.height > 0;
    const std::size_t count = sized ? image.index(0, image.height) : 0;
    if (!sized || image.texels.size() != count || (!image.coverage.empty() && image.coverage.size() != count)) {
        refuse_arrays(image.width, image.height);
    }
}

std::vector<std::uint8_t> encode_bytes(const PngLayout& layout, std::span<const std::uint8_t> texels,
                                       const Attributes& attributes, const Poll& poll) {
    if (layout.width <= 0 || layout.height <= 0 ||
        texels.size() != layout.row_bytes() * static_cast<std::size_t>(layout.height)) {
        refuse_arrays(layout.width, layout.height);
    }
    return encode_png(
        layout, attributes, [&](int y) { return &texels[layout.row_bytes() * static_cast<std::size_t>(y)]; }, poll);
}

} // namespace

EncodedFile encode_image(const Image& image, ImageFormat format, const Attributes& attributes, const Poll& poll) {
    check(image);
    switch (format) {
    case ImageFormat::exr:
        return {encode_exr(image, attributes, poll), 0};
    case ImageFormat::hdr:
        return codec().encode_hdr(image, poll);
    case ImageFormat::png16:
        return encode_png(image, 16, attributes, poll);
    case ImageFormat::png8:
        return encode_png(image, 8, attributes, poll);
    }
    throw Error(ErrorKind::output, "image: its format is none of the known ones; choose EXR, HDR or PNG");
}

std::vector<std::uint8_t> encode_srgb_png(int width, int height, std::span<const std::uint8_t> texels,
                                          const Attributes& attributes, const Poll& poll) {
    return encode_bytes({width, height, 3, 8, true}, texels, attributes, poll);
}

std::vector<std::uint8_t> encode_grey_png(int width, int height, std::span<const std::uint8_t> texels,
                                          const Attributes& attributes, const Poll& poll) {
    return encode_bytes({width, height, 1, 8, false}, texels, attributes, poll);
}

} // namespace vkbake
