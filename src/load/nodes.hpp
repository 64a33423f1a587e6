// The default scene's nodes: where its meshes, cameras and lamps stand.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "load/context.hpp"
#include "load/model.hpp"
#include "vkbake/scene.hpp"

namespace vkbake::gltf {

struct PlacedNodes {
    std::vector<Instance> instances; ///< in the order that Scene asks for
    std::vector<Camera> cameras;
    std::vector<Lamp> lamps;        ///< in the same order
    std::vector<ProbePlace> probes; ///< likewise
};

/// The document's default scene; with a note the first one where none is said to be the default, or all root nodes
/// where there is no scene. Rotations need not have unit length. `extras.vkbake.density` of a node, or of
/// its mesh, becomes Instance::density; a node with `extras.vkbake.probe` (true, or an object that is not empty) is a
/// place of a light probe. A skinned mesh stands where its node stands, with a note. Throws Error{bad_input} where
/// nodes form a cycle or have several parents, a scene lists a node that is no root or is listed twice, or a transform
/// is not finite. `lamps`: read_lamps'.
[[nodiscard]] PlacedNodes place_nodes(Context& context, const Model& model, const std::map<std::uint32_t, Lamp>& lamps);

} // namespace vkbake::gltf
