// Light probes as things to be seen.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "preview/preview.hpp"
#include "vkbake/light_probe.hpp"
#include "vkbake/scene.hpp"

namespace vkbake {

/// What write_bake wrote as probes.json. Throws Error{bad_input} where it cannot be read.
[[nodiscard]] std::vector<LightProbe> read_probes(const std::filesystem::path& file);

/// Adds a white ball for each probe, as wide as 3 % of the scene, with a light map of what the probe gives each normal.
void add_probe_balls(std::span<const LightProbe> probes, Scene& scene, PreviewImages& images);

} // namespace vkbake
