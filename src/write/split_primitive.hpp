// One instance's primitive as its light maps need it: cut by page, vertices doubled where the atlas has a seam.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "vkbake/atlas.hpp"
#include "vkbake/scene.hpp"
#include "vkbake/surface.hpp"

namespace vkbake {

/// The triangles of a primitive that lie on one page, in the primitive's order and in the primitive's own winding
/// (glTF's readers turn it themselves where a node mirrors).
struct PrimitivePiece {
    std::uint32_t page = 0;
    std::vector<std::uint32_t> vertices; ///< one a new vertex: the primitive's vertex that it copies
    std::vector<glm::vec2> uvs;          ///< one a new vertex: light-map UV
    std::vector<std::uint32_t> indices;  ///< three a triangle, into the new vertices
};

/// The pieces by page, ascending, none empty. `part` is the part of `surface` that the primitive gave.
[[nodiscard]] std::vector<PrimitivePiece> split_primitive(const Primitive& primitive, const Surface& surface,
                                                          const SurfacePart& part, const Atlas& atlas);

} // namespace vkbake
