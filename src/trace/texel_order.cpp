#include "trace/texel_order.hpp"

#include <algorithm>
#include <string>

#include "vkbake/error.hpp"

namespace vkbake {

std::vector<std::uint32_t> covered_texels_in_tiles(const GeometryImage& geometry, std::size_t triangle_count) {
    const std::size_t count = geometry.texel_count();
    if (geometry.width < 0 || geometry.height < 0 ||
        count != static_cast<std::size_t>(geometry.width) * static_cast<std::size_t>(geometry.height) ||
        geometry.position.size() != count || geometry.shading_normal.size() != count ||
        geometry.geometric_normal.size() != count || count > GeometryImage::empty) {
        throw Error(ErrorKind::bake_failed,
                    "trace: the geometry image's arrays do not fit its size; give width × height values in each");
    }
    std::vector<std::uint32_t> texels;
    texels.reserve(count - static_cast<std::size_t>(
                               std::count(geometry.triangle.begin(), geometry.triangle.end(), GeometryImage::empty)));
    constexpr int tile = 4;
    for (int top = 0; top < geometry.height; top += tile) {
        for (int left = 0; left < geometry.width; left += tile) {
            for (int y = top; y < std::min(top + tile, geometry.height); ++y) {
                for (int x = left; x < std::min(left + tile, geometry.width); ++x) {
                    const std::size_t texel = static_cast<std::size_t>(y) * static_cast<std::size_t>(geometry.width) +
                                              static_cast<std::size_t>(x);
                    const std::uint32_t triangle = geometry.triangle[texel];
                    if (triangle == GeometryImage::empty) {
                        continue;
                    }
                    if (triangle >= triangle_count) {
                        throw Error(ErrorKind::bake_failed,
                                    "trace: the geometry image names triangle " + std::to_string(triangle) + " of " +
                                        std::to_string(triangle_count) + "; draw it from the same surface");
                    }
                    texels.push_back(static_cast<std::uint32_t>(texel));
                }
            }
        }
    }
    return texels;
}

} // namespace vkbake
