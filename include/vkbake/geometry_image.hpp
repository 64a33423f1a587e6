// Per texel of one page: which point of which triangle it stands for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <glm/vec3.hpp>

#include "vkbake/zeroed_array.hpp"

namespace vkbake {

/// Row-major, row 0 is v = 0. Where `triangle` is `empty` the other values are 0, and take no memory where whole pages
/// of them are.
struct GeometryImage {
    static constexpr std::uint32_t empty = std::numeric_limits<std::uint32_t>::max();

    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> triangle; ///< index in Surface, or `empty`
    ZeroedArray<glm::vec3> position; ///< bake frame: the texel's sample point (the centre, or the nearest point that
                                     ///< the triangle has in the square)
    ZeroedArray<glm::vec3> shading_normal;   ///< unit, on the geometric normal's side
    ZeroedArray<glm::vec3> geometric_normal; ///< unit

    [[nodiscard]] std::size_t texel_count() const { return triangle.size(); }
};

} // namespace vkbake
