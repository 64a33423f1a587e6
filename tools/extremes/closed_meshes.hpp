// Meshes without a hole, the more cruel the better.
#pragma once

#include <string>
#include <vector>

#include "unit/bvh/ray_scenes.hpp"

namespace vkbake::extremes {

struct ClosedMesh {
    test::Triangles triangles;
    glm::vec3 middle{0.0F}; ///< rays start here or
    float inner = 0.0F;     ///< within this of it, along each axis: inside the mesh
};

/// Spheres of 128 and of two million triangles, a cone of needles (1 : 10⁷), a cube with exact coordinates, and
/// spheres after random affine maps.
[[nodiscard]] std::vector<ClosedMesh> closed_meshes();

} // namespace vkbake::extremes
