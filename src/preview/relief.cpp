#include "preview/relief.hpp"

#include <glm/matrix.hpp>

#include "base/normal_transform.hpp"

namespace vkbake {

ReliefTransform::ReliefTransform(const Instance& instance, const Camera& camera) {
    const NormalTransform normals(instance.linear);
    const glm::dmat3 to_eye = glm::transpose(camera.orientation);
    m_normal = to_eye * normals.matrix;
    m_tangent = to_eye * instance.linear;
    m_handedness = normals.mirrored ? -1.0F : 1.0F;
}

PreviewRelief ReliefTransform::of(const Primitive& primitive, std::size_t vertex, const glm::dvec3& flat,
                                  const glm::vec2& uv) const {
    const bool has_normal = vertex < primitive.normals.size();
    PreviewRelief relief{.normal = unit_or_zero(m_normal * (has_normal ? glm::dvec3(primitive.normals[vertex]) : flat)),
                         .uv = uv,
                         .tangent = glm::vec4(0.0F)};
    if (vertex < primitive.tangents.size()) {
        const glm::vec4& tangent = primitive.tangents[vertex];
        const glm::vec3 along = unit_or_zero(m_tangent * glm::dvec3(glm::vec3(tangent)));
        relief.tangent = glm::vec4(along, m_handedness * (tangent.w < 0.0F ? -1.0F : 1.0F));
    }
    return relief;
}

} // namespace vkbake
