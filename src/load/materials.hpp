// The model's materials, and the images that they may need.
#pragma once

#include <vector>

#include "load/context.hpp"
#include "load/model.hpp"
#include "vkbake/scene.hpp"

namespace vkbake::gltf {

/// All materials of the document, in its order. A texture whose image only an unsupported extension names is left out
/// with a note. `MOZ_lightmap`, with the names of the linear files in the material's extras.vkbake.lightMap and
/// .directional, becomes `light_map`.
[[nodiscard]] std::vector<Material> make_materials(Context& context, const Model& model);

/// All images of the document, in its order, encoded as they are.
[[nodiscard]] std::vector<EncodedImage> make_images(const Model& model);

} // namespace vkbake::gltf
