// Lamps whose light is in the light maps must not light the scene again.
#pragma once

#include <span>

#include "base/json.hpp"
#include "vkbake/lamp.hpp"

namespace vkbake {

/// Moves each lamp's definition from KHR_lights_punctual to `extras.vkbake.bakedLight` of its node, where a renderer
/// finds it that has more to light than what was baked. Lights that no node names any more go, and the extension with
/// the last of them.
void put_lamps_aside(Json& document, std::span<const Lamp> lamps);

/// The reverse, for all nodes: their light is not in the maps.
void bring_lamps_back(Json& document);

} // namespace vkbake
