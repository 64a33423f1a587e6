// What bounces add to the error that a map tells.
#pragma once

#include <optional>

#include "trace/known_light.hpp"
#include "vkbake/lightmap.hpp"

namespace vkbake {

/// Adds the light of a bounce, and its noise, to a map of which `before` was known: standard errors add up by their
/// squares, since it was gathered by rays of its own. That the light it was gathered from had noise shows in those
/// rays, as each ended elsewhere.
void add_bounce(const LightMap& gathered, const std::optional<KnownLight>& before, LightMap& map);

} // namespace vkbake
