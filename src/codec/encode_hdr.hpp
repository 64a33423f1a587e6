// Images → the bytes of Radiance files, by OpenImageIO; as Codec says.
#pragma once

#include "codec/codec.hpp"

namespace vkbake {

[[nodiscard]] EncodedFile encode_hdr(const Image& image, const Poll& poll);

} // namespace vkbake
