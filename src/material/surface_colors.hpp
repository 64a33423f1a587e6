// Geometry image → what its texels reflect and emit.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "material/color_texture.hpp"
#include "vkbake/geometry_image.hpp"
#include "vkbake/scene.hpp"
#include "vkbake/settings.hpp"
#include "vkbake/surface.hpp"

namespace vkbake {

/// Row-major as the geometry image; 0 where it is empty.
struct SurfaceColors {
    std::vector<glm::vec3> albedo;   ///< of diffuse reflection, 0 … 1 in each channel
    std::vector<glm::vec3> emission; ///< radiance; empty where no material emits
};

// As glTF 2.0 has them (§3.9, Appendix B.3): albedo is base colour (factor · texture · COLOR_0) · (1 − metallic), all
// of which must lie in [0, 1] and are moved there, · (1 − transmission) where surfaces let light through
// (KHR_materials_transmission); emission is emissive factor · texture.

[[nodiscard]] bool reflects(const Material& material); ///< whether its albedo can be above 0
[[nodiscard]] bool emits(const Material& material);

/// Whether a material that a primitive of an instance has (or no material: glTF's, which reflects) does so.
[[nodiscard]] bool reflects(const Scene& scene);
[[nodiscard]] bool emits(const Scene& scene);

/// How the images of a scene are read for it, one an entry of Scene::images: what no material needs is absent. A
/// metallic texture is linear, colours are sRGB; where one image is used as both, as a colour.
enum class ColorUse : unsigned char { none, color, linear };
[[nodiscard]] std::vector<ColorUse> color_uses(const Scene& scene, Alpha alpha);

/// `textures`: one an image of the scene, of those that color_uses() names.
[[nodiscard]] SurfaceColors make_surface_colors(const Scene& scene, const Surface& surface,
                                                const GeometryImage& geometry, std::span<const ColorTexture> textures,
                                                Alpha alpha);

} // namespace vkbake
