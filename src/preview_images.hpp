// What a baked scene refers to, decoded for its preview.
#pragma once

#include "preview/images.hpp"
#include "vkbake/render.hpp"
#include "vkbake/scene.hpp"
#include "vkbake/sky.hpp"

namespace vkbake {

/// What a picture of `scene` by `settings` needs and no more. Bent normals become what they make of the light of `sky`.
/// Throws Error{bad_input} where the scene has no light map, or an image cannot be read.
[[nodiscard]] PreviewImages decode_images(const Scene& scene, const Sky& sky, const RenderSettings& settings);

} // namespace vkbake
