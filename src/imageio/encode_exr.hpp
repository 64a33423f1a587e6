// Images → the bytes of EXR files, by OpenEXR.
#pragma once

#include <cstdint>
#include <vector>

#include "codec/codec.hpp"

namespace vkbake {

/// As ImageFormat::exr says; the image's arrays fit its size. Tiles are compressed by OpenEXR's threads, of which the
/// process has one for each core from then on where it had none. Throws Error{output}.
[[nodiscard]] std::vector<std::uint8_t> encode_exr(const Image& image, const Attributes& attributes, const Poll& poll);

} // namespace vkbake
