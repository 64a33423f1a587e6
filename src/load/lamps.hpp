// KHR_lights_punctual, and what extras.vkbake adds to it.
#pragma once

#include <cstdint>
#include <map>

#include <glm/mat3x3.hpp>

#include "base/json.hpp"
#include "load/context.hpp"
#include "vkbake/lamp.hpp"

namespace vkbake::gltf {

/// The document's lamps by the node that holds each, not placed yet. A node holds the light that its extension names
/// or, in a scene that was baked, the one in its `extras.vkbake.bakedLight`. `angularDiameter` (degrees) and `radius`
/// (metres) are taken from `extras.vkbake` of the light, or of the node, whose word is the last. Throws
/// Error{bad_input} for values that the extension does not allow; an inner cone may equal the outer one.
[[nodiscard]] std::map<std::uint32_t, Lamp> read_lamps(const Context& context, const Json& document);

/// Puts a lamp where its node stands: it shines along the node's −Z; no scale changes its light. False where the node
/// is scaled to nothing along Z, so that nobody knows whither.
[[nodiscard]] bool place_lamp(Lamp& lamp, const glm::dmat3& linear, const glm::dvec3& translation);

} // namespace vkbake::gltf
