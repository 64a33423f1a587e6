// A picture of a baked scene.
#pragma once

#include <optional>
#include <string>

#include "vkbake/device.hpp"
#include "vkbake/image.hpp"
#include "vkbake/scene.hpp"
#include "vkbake/sky.hpp"

namespace vkbake {

struct RenderSettings {
    int width = 1280;
    int height = 720;
    std::string camera; ///< a camera's name; empty: the scene's first, or a view of the whole scene where it has none
    std::optional<Camera> view; ///< stands above `camera` where set
    bool light_only = false;    ///< the light maps on grey surfaces
    double exposure = 0.0;      ///< stops
    bool show_sky = true;       ///< behind the scene; black otherwise
};

/// Draws a scene that was loaded from what write_bake wrote. Returns display-referred sRGB-encoded values in [0,1],
/// alpha 1. Throws Error{bad_input} where the scene has no light maps or no such camera.
[[nodiscard]] Image render(const Scene& baked, const Sky& sky, const RenderSettings& settings, const Device& device);

} // namespace vkbake
