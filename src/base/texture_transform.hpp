// Where a texture is looked at.
#pragma once

#include <cmath>

#include <glm/vec2.hpp>

#include "vkbake/scene.hpp"

namespace vkbake {

/// KHR_texture_transform: offset + rotate(rotation) · (scale · uv).
[[nodiscard]] inline glm::vec2 transformed(const TextureUse& use, const glm::vec2& uv) {
    const glm::vec2 scaled = use.scale * uv;
    const float sine = std::sin(use.rotation);
    const float cosine = std::cos(use.rotation);
    // Counter-clockwise as one looks at the image: v points down.
    return use.offset + glm::vec2(cosine * scaled.x + sine * scaled.y, cosine * scaled.y - sine * scaled.x);
}

} // namespace vkbake
