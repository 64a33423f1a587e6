// A decoded picture: what images are read into and written from.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec4.hpp>

namespace vkbake {

/// Linear RGBA floats, row-major, row 0 at the top. Values may exceed 1. `texels.size() == width * height`.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<glm::vec4> texels;
    /// One value a texel, 1 where the texel was baked and 0 elsewhere; empty where the source has no such channel.
    std::vector<float> coverage;

    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

} // namespace vkbake
