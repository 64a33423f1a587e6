// The graphics pass that draws a picture of a baked scene.
#pragma once

#include <functional>

#include <glm/vec3.hpp>

#include "preview/images.hpp"
#include "vkbake/image.hpp"
#include "vkbake/scene.hpp"

namespace vkbake {

namespace gpu {
class Context;
}

struct PreviewSettings {
    int width = 1280; ///< pixels; 1 … 16384
    int height = 720;
    bool light_only = false;
    double exposure = 1.0; ///< a factor on radiance
    bool metered = false;  ///< the exposure is on top of the one that the light in this picture asks for
    int samples = 4;       ///< along each side of a pixel
    int tile =
        2048; ///< largest side of what is drawn at once, samples; at least `samples`. Does not change the picture
};

/// Radiance from infinitely far in a world direction (unit length). Called from several threads.
using PreviewSky = std::function<glm::vec3(const glm::vec3& direction)>;

/// Outgoing radiance is base colour × light map + emission; a surface without light map gets the mean of all light maps
/// instead. Where a directional light map is known, the light is what it gives the normal map's normal
/// (vkbake_light.h), and the exposure is metered without it. Triangles show both sides. Tone-mapped by Khronos PBR
/// Neutral, sRGB-encoded, alpha 1. An empty `sky` is black. Where `metered`, the light on the opaque surfaces that the
/// picture shows sets the exposure (metered_exposure); where it shows none, the mean of all light maps; 1 if that is
/// black too. Throws Error{usage} for a size that is out of range.
[[nodiscard]] Image draw_preview(gpu::Context& context, const Scene& scene, const PreviewImages& images,
                                 const Camera& camera, const PreviewSky& sky, const PreviewSettings& settings);

} // namespace vkbake
