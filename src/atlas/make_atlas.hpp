// Surface → light-map UVs.
#pragma once

#include "vkbake/atlas.hpp"
#include "vkbake/scene.hpp"
#include "vkbake/settings.hpp"
#include "vkbake/surface.hpp"

namespace vkbake {

/// Keeps TEXCOORD_1 or makes charts, as settings.uv says; packs by settings.layout, size, density, gutter and
/// max_pages. A surface without triangles gives an atlas without pages. `scene` is not looked at where all UVs are
/// made.
///
/// Layout `atlas`: kept UVs that do not overlap over the whole scene stay as they are, on one page. Otherwise what each
/// object's kept UVs cover is one rectangle among the charts, scaled to the common density (surface area to UV area).
///
/// Layout `object`: a page for each object; kept UVs stay as they are; charts have a density of their own for each
/// page.
///
/// Charts that are placed (an object's kept UVs count as one): between the texel squares that any two of them touch, at
/// least `gutter` texels are empty along u or v; no two triangles overlap, exactly; seen from the front nothing is
/// mirrored that kept UVs did not mirror.
///
/// The result depends on geometry and names alone, not on the order of triangles or vertices in the file (triangles
/// that are equal may change places).
///
/// Throws Error{bad_input} where UVs that must be kept will not do (the mesh and two triangles are named), Error{usage}
/// for a setting out of range and where the charts do not fit max_pages (a size that fits is named).
[[nodiscard]] Atlas make_atlas(const Scene& scene, const Surface& surface, const Settings& settings);

} // namespace vkbake
