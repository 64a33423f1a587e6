// What a document says beside its data: nodes, meshes, materials, cameras.
#pragma once

#include "base/json.hpp"
#include "load/context.hpp"

namespace vkbake::gltf {

/// Throws Error{bad_input} where a value that the scene is made of has the wrong type or range, or an index names
/// nothing. tinygltf takes much of that for absent, or for a default.
void check_structure(Context& context, const Json& document);

} // namespace vkbake::gltf
