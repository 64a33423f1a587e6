// Where a texture is looked at.
#pragma once

#include <numbers>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

#include "base/elementary.hpp"
#include "vkbake/scene.hpp"

namespace vkbake {

/// KHR_texture_transform: offset + rotate(rotation) · (scale · uv), the same bits on every machine.
class TextureTransform {
public:
    explicit TextureTransform(const TextureUse& use) : m_offset(use.offset) {
        const SineCosine turn = sine_cosine_degrees(static_cast<double>(use.rotation) * (180.0 / std::numbers::pi));
        const glm::dvec2 scale(use.scale);
        // Counter-clockwise as one looks at the picture: v points down.
        m_matrix[0] = scale.x * glm::dvec2(turn.cosine, -turn.sine);
        m_matrix[1] = scale.y * glm::dvec2(turn.sine, turn.cosine);
    }

    [[nodiscard]] glm::dvec2 operator()(const glm::dvec2& uv) const { return m_offset + m_matrix * uv; }

private:
    glm::dmat2 m_matrix{1.0};
    glm::dvec2 m_offset{0.0};
};

} // namespace vkbake
