// The compute pass that fills the gutter.
#pragma once

#include <cstdint>

#include "vkbake/image.hpp"

namespace vkbake {

namespace gpu {
class Context;
}

struct DilateSettings {
    int rounds = 8;
    int tile = 2048; ///< side of a tile without its border, texels; the result does not depend on it
};

/// In each round an empty texel (A = 0) takes the average of those of its eight neighbours that were filled before the
/// round, summed in row order, and A = 1. The thesis asks for two filled neighbours; one is enough here, so that
/// corners fill too. A filled texel's bits never change, NaN payloads and denormals included; coverage is not touched.
/// Returns how many were filled.
std::uint64_t dilate(gpu::Context& context, Image& image, const DilateSettings& settings);

} // namespace vkbake
