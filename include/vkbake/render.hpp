// A picture of a baked scene.
#pragma once

#include <optional>
#include <string>

#include "vkbake/device.hpp"
#include "vkbake/image.hpp"
#include "vkbake/scene.hpp"
#include "vkbake/settings.hpp"
#include "vkbake/sky.hpp"

namespace vkbake {

struct RenderSettings {
    int width = 1280;
    int height = 720;
    std::string camera; ///< a camera's name; empty: the scene's first, or a view of the whole scene where it has none
    std::optional<Camera> view; ///< stands above `camera` where set
    bool light_only = false;    ///< the light maps on grey surfaces
    bool checker = false; ///< in place of light, a checker of the light maps' texels, 4 × 4 a square, on grey surfaces
    Switch directional = Switch::on; ///< normal maps, lit by directional light maps where the bake made some
    bool probes = false;             ///< light probes as white balls; the scene needs a probes.json beside it
    double exposure = 0.0;           ///< stops, on top of the metered exposure
    bool show_sky = true;            ///< behind the scene; black otherwise
};

/// Draws a scene that was loaded from what write_bake wrote: base colour × light map + emission. A light map is its EXR
/// where that lies beside the scene, otherwise the image that the scene embeds; a scene without any is lit by its
/// occlusion textures, or by what its bent normals make of the light of `sky`, where their EXR lies beside it. A
/// material with a normal map gets the light of vkbake_directional_light (vkbake_light.h) where the directional maps
/// lie beside the scene; its tangents are the file's, or follow from its texture coordinates. A surface without light
/// map gets the mean of all maps' texels that are not black. BLEND surfaces are painted from far to near; both sides
/// show. The exposure is metered from the picture itself: a white surface in the geometric mean of the light on the
/// opaque surfaces that it shows (black ones aside: below 1 % of the mean) is shown at 0.4, so noon, night and a room's
/// inside come out alike bright; the sky behind does not count. Where the picture shows no such surface, the mean of
/// all maps stands in. RenderSettings::exposure goes on top. Tone mapping is Khronos PBR Neutral, 4 × 4 samples a
/// pixel. Returns display-referred sRGB-encoded values in [0,1], alpha 1. Throws Error{bad_input} where the scene has
/// no light maps or no such camera, Error{usage} for sizes out of 1 … 16384.
[[nodiscard]] Image render(const Scene& baked, const Sky& sky, const RenderSettings& settings, const Device& device);

} // namespace vkbake
