// Cube maps that come as one picture: strips and crosses.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "vkbake/image.hpp"

namespace vkbake {

/// Where each face of a cube map lies in a grid of squares.
struct CubeLayout {
    struct Place {
        int column = 0;
        int row = 0;
        bool turned = false; ///< by 180°
    };
    std::string_view name;
    int columns = 0;
    int rows = 0;
    std::array<Place, 6> faces; ///< in Vulkan's order: +X −X +Y −Y +Z −Z
};

/// By aspect alone, which must be exact:
///
///     6:1  +X −X +Y −Y +Z −Z from left to right        1:6  the same from top to bottom
///
///     4:3      +Y                3:4      +Y
///          −X  +Z  +X  −Z             −X  +Z  +X
///              −Y                         −Y
///                                         −Z   turned by 180°
///
/// Each face but that one stands as Vulkan orients it, so that neighbours in a cross meet at their common edge.
[[nodiscard]] std::optional<CubeLayout> find_cube_layout(int width, int height);

/// The faces of a picture whose size fits the layout. What lies outside the faces is not looked at.
[[nodiscard]] std::array<Image, 6> cut_faces(const Image& picture, const CubeLayout& layout);

} // namespace vkbake
