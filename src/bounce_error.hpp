// What bounces add to the error that a map tells.
#pragma once

#include "vkbake/lightmap.hpp"

namespace vkbake {

/// Adds the light of a bounce, and its noise: standard errors add up by their squares, since it was gathered by rays of
/// its own. That the light it was gathered from had noise shows in those rays, as each ended elsewhere.
void add_bounce(const LightMap& gathered, LightMap& map);

} // namespace vkbake
