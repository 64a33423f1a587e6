// Which light a bake models, and why.
#pragma once

#include <string>
#include <vector>

#include "vkbake/scene.hpp"
#include "vkbake/settings.hpp"
#include "vkbake/sky.hpp"

namespace vkbake {

struct PlanEntry {
    std::string phenomenon;
    bool modelled = false;
    std::string reason; ///< one line
};

/// One entry each for the sky's light, its sun, lamps, bounces, emission, where light comes from, probes, albedo
/// textures, alpha. What is not modelled costs a bake nothing. Pure; nothing is decoded, so shares are what the
/// materials' factors allow, before textures.
[[nodiscard]] std::vector<PlanEntry> make_plan(const Scene& scene, const Settings& settings, const Sky& sky = {});

} // namespace vkbake
