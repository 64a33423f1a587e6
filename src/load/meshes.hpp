// The model's meshes as triangles.
#pragma once

#include <span>
#include <vector>

#include "load/context.hpp"
#include "load/model.hpp"
#include "vkbake/scene.hpp"

namespace vkbake::gltf {

/// All meshes of the document, in its order. Triangle lists, strips and fans become indexed triangles in the winding of
/// glTF 2.0 §3.7.2.1; points and lines are left out with a note. Tangents are read where the material has a normal map
/// and a directional light map. A set of texture coordinates, tangents or colours that holds values that are not finite
/// is left out with a note. Normals that are 0 or not finite: where they are more than half
/// of a primitive's, it gets none at all (flat ones further on); otherwise those vertices get the mean of their
/// triangles' normals, weighted by area; both with a note. Throws Error{bad_input} where accessors have types that glTF
/// forbids there, differing counts, indices out of range or primitive restart values, or a position is not finite; the
/// message names mesh, primitive and accessor.
[[nodiscard]] std::vector<Mesh> make_meshes(Context& context, const Model& model, std::span<const Material> materials);

} // namespace vkbake::gltf
