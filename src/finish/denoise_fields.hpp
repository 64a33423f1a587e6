// What the denoiser reads of a map, and what becomes of its result.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "denoise.h"
#include "vkbake/geometry_image.hpp"
#include "vkbake/lightmap.hpp"

namespace vkbake {

/// Beside the light itself.
struct DenoiseGuides {
    const GeometryImage& geometry;        ///< of the map's page
    std::span<const std::uint32_t> chart; ///< of each triangle: Atlas::chart
    std::span<const float> variance;      ///< of each texel's luminance, as its samples show it; 0 where not baked
};

/// Row-major. Light is scaled by a power of two such that the map's mean luminance is about 1; variances go with it.
struct DenoiseFields {
    int width = 0;
    int height = 0;
    int exponent = 0;              ///< light was multiplied by 2^exponent
    float good = 0.0F;             ///< variance below which a texel is left alone
    std::vector<glm::vec4> color;  ///< RGB; A's bits: the chart's number + 1, or 0 where a texel takes no part
    std::vector<glm::vec4> place;  ///< position in the bake frame; variance
    std::vector<glm::vec4> facing; ///< shading normal; luminance
};

/// A texel takes no part where it is not covered, not finite, or above 2^30 means.
[[nodiscard]] DenoiseFields make_denoise_fields(const LightMap& map, const DenoiseGuides& guides);

/// What the filter makes of a texel, scaled as DenoiseFields.
struct DenoisedTexel {
    glm::vec3 color{0.0F};
    float variance = 0.0F;      ///< of its luminance's noise
    float risk = DENOISE_ALONE; ///< estimate of its squared error; or DENOISE_ALONE: it is to stay as it was
};
using DenoisedTexels = std::vector<DenoisedTexel>;

/// Takes over what the filter changed, and what is known of its errors. Returns how many texels it changed.
std::uint64_t take_denoised(const DenoiseFields& fields, std::span<const DenoisedTexel> denoised,
                            const DenoiseGuides& guides, LightMap& map);

} // namespace vkbake
