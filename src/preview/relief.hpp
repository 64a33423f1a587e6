// What a normal map needs to know of a vertex.
#pragma once

#include <cstddef>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "vkbake/scene.hpp"

namespace vkbake {

/// Eye space.
struct PreviewRelief {
    glm::vec3 normal;  ///< unit length; what was baked
    glm::vec2 uv;      ///< of the normal map, transformed
    glm::vec4 tangent; ///< along u; w: ±1, so that up in the map is w · normal × tangent, or 0: u and v tell
};

/// Takes an instance's normals and tangents to eye space. What mirrors turns w, and not the normal, which stays on the
/// surface's outer side.
class ReliefTransform {
public:
    ReliefTransform(const Instance& instance, const Camera& camera);

    /// Of a vertex of `primitive`. `flat`: the normal, in the mesh's space and of any length, where it has none.
    [[nodiscard]] PreviewRelief of(const Primitive& primitive, std::size_t vertex, const glm::dvec3& flat,
                                   const glm::vec2& uv) const;

private:
    glm::dmat3 m_normal{1.0};
    glm::dmat3 m_tangent{1.0};
    float m_handedness;
};

} // namespace vkbake
