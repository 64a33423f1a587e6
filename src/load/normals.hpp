// Normals that a file got wrong.
#pragma once

#include <string>

#include "load/context.hpp"
#include "vkbake/scene.hpp"

namespace vkbake::gltf {

/// Makes every normal finite and not 0, or leaves none, as make_meshes says. `where` names the primitive in the note.
void repair_normals(Context& context, const std::string& where, Primitive& primitive);

} // namespace vkbake::gltf
