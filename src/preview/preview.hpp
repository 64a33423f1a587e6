// The graphics pass that draws a picture of a baked scene.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include <glm/vec3.hpp>

#include "vkbake/image.hpp"
#include "vkbake/scene.hpp"

namespace vkbake {

namespace gpu {
class Context;
}

/// Four bytes a texel, sRGB-encoded, row 0 at the top.
struct PreviewTexture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> texels;
};

/// The scene's pictures, decoded.
struct PreviewImages {
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    std::vector<PreviewTexture>
        textures;                  ///< one an image of the scene; empty where no base colour or emission needs it
    std::vector<Image> light_maps; ///< linear: E/π, or visibility
    std::vector<std::uint32_t> light_map_of; ///< one a material: index in light_maps, or none
    bool occlusion = false;                  ///< light maps are the materials' occlusion textures
};

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
/// instead. Triangles show both sides. Tone-mapped by Khronos PBR Neutral, sRGB-encoded, alpha 1.
/// An empty `sky` is black. Where `metered`, the light on the opaque surfaces that the picture shows sets the exposure
/// (metered_exposure); where it shows none, the mean of all light maps; 1 if that is black too. Throws Error{usage} for
/// a size that is out of range.
[[nodiscard]] Image draw_preview(gpu::Context& context, const Scene& scene, const PreviewImages& images,
                                 const Camera& camera, const PreviewSky& sky, const PreviewSettings& settings);

} // namespace vkbake
