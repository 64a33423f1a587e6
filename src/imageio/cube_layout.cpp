#include "imageio/cube_layout.hpp"

#include <algorithm>

namespace vkbake {
namespace {

constexpr std::array<CubeLayout, 4> layouts{{
    {"strip", 6, 1, {{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}}}},
    {"strip", 1, 6, {{{0, 0}, {0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}}}},
    {"cross", 4, 3, {{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}}}},
    {"cross", 3, 4, {{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {1, 3, true}}}},
}};

} // namespace

std::optional<CubeLayout> find_cube_layout(int width, int height) {
    for (const CubeLayout& layout : layouts) {
        if (width > 0 && width % layout.columns == 0 && height % layout.rows == 0 &&
            width / layout.columns == height / layout.rows) {
            return layout;
        }
    }
    return std::nullopt;
}

std::array<Image, 6> cut_faces(const Image& picture, const CubeLayout& layout) {
    const int side = picture.width / layout.columns;
    std::array<Image, 6> faces;
    for (std::size_t face = 0; face < faces.size(); ++face) {
        const CubeLayout::Place& place = layout.faces.at(face);
        Image& image = faces.at(face);
        image = {side, side, {}, {}};
        image.texels.reserve(image.index(0, side));
        for (int y = 0; y < side; ++y) {
            const auto first = picture.texels.begin() +
                               static_cast<std::ptrdiff_t>(picture.index(place.column * side, place.row * side + y));
            image.texels.insert(image.texels.end(), first, first + side);
        }
        if (place.turned) {
            std::reverse(image.texels.begin(), image.texels.end());
        }
    }
    return faces;
}

} // namespace vkbake
