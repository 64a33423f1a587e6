// Textures that a scene holds as PNG or JPEG, decoded from memory.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "vkbake/image.hpp"
#include "vkbake/scene.hpp"

namespace vkbake {

/// Four bytes a texel: red, green, blue, alpha (255 where the image has none), as encoded: sRGB colours stay sRGB.
/// Row-major, row 0 at the top.
struct Rgba8Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> texels; ///< 4 · width · height
};

struct ImageSize {
    int width = 0;
    int height = 0;
};

/// From the image's header; absent where decode_rgba8 would refuse it for what that says.
[[nodiscard]] std::optional<ImageSize> size_of(const EncodedImage& image);

/// Grey images get three equal channels; 16-bit ones are rounded to 8. Throws Error{bad_input} that names the image
/// where it is damaged, of another format than PNG or JPEG (EXR and HDR pass too), wider or higher than 16384 or above
/// 2 GiB decoded.
[[nodiscard]] Rgba8Image decode_rgba8(const EncodedImage& image);

/// The same as linear floats: integer colours (8 and 16 bits, as glTF wants) are taken for sRGB and linearised; alpha
/// stays.
[[nodiscard]] Image decode_image(const EncodedImage& image);

} // namespace vkbake
