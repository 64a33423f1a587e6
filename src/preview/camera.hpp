// Where a picture is taken from.
#pragma once

#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "vkbake/scene.hpp"

namespace vkbake {

/// The world positions of all vertices that a triangle uses, metres.
[[nodiscard]] std::vector<glm::dvec3> world_positions(const Scene& scene);

/// A view of all points from the front, the right and above (azimuth 35° from +Z towards +X, elevation 28°), 45° high,
/// from just so far that all of them lie in the picture with a margin of 4 % of its half size: always outside of their
/// box's side. `aspect` is width ÷ height. At least one point.
[[nodiscard]] Camera view_of_all(const std::vector<glm::dvec3>& points, double aspect);

/// The scene's camera of that name; its first where `name` is empty; view_of_all where it has none.
/// Throws Error{bad_input} that lists the scene's cameras where none has that name, or where there is nothing to see.
[[nodiscard]] Camera choose_camera(const Scene& scene, const std::string& name, double aspect);

/// World to eye space (right, up, backward), in double: position → orientationᵀ · (position − camera.position).
[[nodiscard]] glm::dvec3 to_eye(const Camera& camera, const glm::dvec3& position);

/// Eye space to Vulkan's clip space: y down, depth 1 at `near` falling to 0 at infinity (perspective) or at `far`
/// (orthographic): reversed, so that a float depth keeps its precision far away.
[[nodiscard]] glm::dmat4 projection(const Camera& camera, double aspect, double near, double far);

/// The world direction, unit length, that a point of the picture looks in; (0,0) is its upper left corner, (1,1) the
/// lower right.
[[nodiscard]] glm::dvec3 direction_through(const Camera& camera, double aspect, const glm::dvec2& point);

} // namespace vkbake
