// The frame in which floats are used where they are densest.
#pragma once

#include <glm/vec3.hpp>

#include "vkbake/scene.hpp"
#include "vkbake/surface.hpp"

namespace vkbake {

/// M · v, each component summed from left to right: the order that BakeFrame's promise is about.
[[nodiscard]] glm::dvec3 transform_vertex(const glm::dmat3& linear, const glm::vec3& vertex);

/// The frame of everything that the scene's instances show. Without a vertex: the identity.
/// Throws Error{bad_input} where a vertex or transform is not finite, or leaves the range of doubles.
[[nodiscard]] BakeFrame make_bake_frame(const Scene& scene);

} // namespace vkbake
