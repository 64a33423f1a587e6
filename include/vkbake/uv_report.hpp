// What the light-map UVs of a bake are worth, and how they look.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "vkbake/atlas.hpp"
#include "vkbake/image.hpp"
#include "vkbake/scene.hpp"
#include "vkbake/settings.hpp"

namespace vkbake {

struct UvFiguresOfObject {
    std::string name; ///< the object's; empty where the figures are all objects'
    std::size_t triangles = 0;
    std::size_t charts = 0;      ///< pieces that hang together in space and in the map
    double texels = 0.0;         ///< texels² that the triangles cover
    double stretch = 1.0;        ///< L2 (Sander et al. 2001), 1: none
    std::size_t overlapping = 0; ///< triangles that overlap another of the same object
    std::size_t mirrored = 0;    ///< triangles that turn against the greater part of their chart
    double density_min = 0.0;    ///< texels a metre of any triangle with area, √(texels² / m²)
    double density_median = 0.0; ///< by area
    double density_max = 0.0;
};

struct UvReport {
    Atlas atlas;
    std::vector<UvFiguresOfObject> objects; ///< those that have triangles
    UvFiguresOfObject all;
    double share = 0.0; ///< of the pages' area: what triangles cover, overlaps counted twice
};

/// The UVs that a bake with these settings would use. Throws what make_atlas throws.
[[nodiscard]] UvReport inspect_uvs(const Scene& scene, const Settings& settings);

/// A page of the atlas, a pixel a texel: each chart in a colour of its own over a checker of 8 texels' squares, its
/// outline dark. sRGB-encoded values in [0,1], alpha 1.
[[nodiscard]] Image draw_uvs(const Atlas& atlas, std::uint32_t page);

} // namespace vkbake
