// The pictures that a preview draws with.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "vkbake/image.hpp"

namespace vkbake {

/// Four bytes a texel, row 0 at the top.
struct PreviewTexture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> texels;
};

/// The scene's pictures, decoded.
struct PreviewImages {
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    std::vector<PreviewTexture>
        textures; ///< sRGB-encoded; one an image of the scene; empty where no base colour or emission needs it
    std::vector<Image> light_maps;           ///< linear: E/π, or visibility
    std::vector<std::uint32_t> light_map_of; ///< one a material: index in light_maps, or none
    bool occlusion = false;                  ///< light maps are read where the materials' occlusion textures are

    std::vector<PreviewTexture> normal_maps; ///< linear; one an image of the scene, or none at all; empty as above
    std::vector<std::array<Image, 4>> directional_maps;
    std::vector<std::uint32_t> directional_map_of; ///< as light_map_of; what is not there has none

    /// The directional light map that a material's normal map is lit by, or none.
    [[nodiscard]] std::uint32_t relief_of(std::size_t material) const {
        return material < directional_map_of.size() ? directional_map_of[material] : none;
    }
};

} // namespace vkbake
