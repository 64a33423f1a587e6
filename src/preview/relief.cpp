#include "preview/relief.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace vkbake {

namespace {

glm::vec3 unit_or_zero(const glm::dvec3& vector) {
    const double length = glm::length(vector);
    return length > 0.0 ? glm::vec3(vector / length) : glm::vec3(0.0F);
}

} // namespace

ReliefTransform::ReliefTransform(const Instance& instance, const Camera& camera) {
    const glm::dmat3& m = instance.linear;
    // The inverse transpose but for its size, which a transform that flattens has too.
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    const bool mirrored = glm::dot(cofactors[2], m[2]) < 0.0;
    const glm::dmat3 to_eye = glm::transpose(camera.orientation);
    m_normal = to_eye * cofactors * (mirrored ? -1.0 : 1.0);
    m_tangent = to_eye * m;
    m_handedness = mirrored ? -1.0F : 1.0F;
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
