// The 8-bit picture of a light map that glTF viewers show.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "imageio/encode.hpp"
#include "vkbake/image.hpp"
#include "vkbake/settings.hpp"

namespace vkbake {

struct DisplayMap {
    std::string name;              ///< AtlasPage::name
    std::string linear_file;       ///< the light map's own file, relative to the scene's
    std::vector<std::uint8_t> png; ///< irradiance: three channels, sRGB; ao and bent_normal: one channel, linear
    std::vector<std::string> directional_files; ///< of LightMap::directional, likewise
    double intensity = 1.0;                     ///< irradiance: E = intensity × linear value of the PNG
};

/// Irradiance: each channel as sRGB of value ÷ greatest value of the map, so intensity = π × that; a map that is black
/// everywhere counts as one whose greatest value is 1. Ao: the first channel in [0,1]; bent_normal: the length. Texels
/// without a value (A = 0) are black; NaN and negative values count as 0, infinite ones as the greatest finite.
[[nodiscard]] DisplayMap make_display_map(const std::string& name, const Image& image, Mode mode,
                                          const Poll& poll = {});

} // namespace vkbake
