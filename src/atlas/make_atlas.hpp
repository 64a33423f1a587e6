// Surface → light-map UVs.
#pragma once

#include "vkbake/atlas.hpp"
#include "vkbake/scene.hpp"
#include "vkbake/settings.hpp"
#include "vkbake/surface.hpp"

namespace vkbake {

/// Keeps TEXCOORD_1 or makes charts, as settings.uv says; packs by settings.layout, size, density, gutter and max_pages.
/// Throws Error{bad_input} where UVs that must be kept will not do (the mesh and two triangles are named), Error{usage}
/// where the charts do not fit max_pages (a size that fits is named).
[[nodiscard]] Atlas make_atlas(const Scene& scene, const Surface& surface, const Settings& settings);

} // namespace vkbake
