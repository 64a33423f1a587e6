// What a bake has to say of the scene's lamps.
#pragma once

#include <string>
#include <vector>

#include "vkbake/lightmap.hpp"
#include "vkbake/scene.hpp"

namespace vkbake {

/// Which lamps reached no texel: they are inside of something, out of range, or turned away. And that what was baked
/// will not be lit again. Empty where no lamps were baked.
[[nodiscard]] std::vector<std::string> note_lamps(const Scene& scene, const Bake& bake);

} // namespace vkbake
