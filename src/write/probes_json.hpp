// probes.json: a bake's light probes.
#pragma once

#include <string>

#include "vkbake/lightmap.hpp"

namespace vkbake {

/// The file's text, a line a probe. Positions in metres, coefficients as LightProbe has them.
[[nodiscard]] std::string probes_text(const Bake& bake);

} // namespace vkbake
