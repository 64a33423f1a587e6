// Light at points in the air.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include <glm/vec3.hpp>

namespace vkbake {

/// Where a probe is wanted: a node with `extras.vkbake.probe`.
struct ProbePlace {
    std::string name;              ///< the node's, or "node N"; not unique
    glm::dvec3 position{0.0};      ///< metres
    std::uint32_t source_node = 0; ///< index in the source document's nodes
};

/// The middles of count.x · count.y · count.z equal cells of the scene's box; x runs fastest, then y.
struct ProbeGrid {
    std::array<std::uint32_t, 3> counts{};
    std::size_t first_probe = 0; ///< index in Bake::probes
    glm::dvec3 first{0.0};       ///< metres, where the first probe is
    glm::dvec3 step{0.0};        ///< metres from one to the next along each axis
};

/// The light that arrives at a point from all around.
struct LightProbe {
    std::string name; ///< ProbePlace::name; empty in a grid
    glm::dvec3 position{0.0};
    /// RGB: ∫ L Y over the sphere, of the real orthonormal spherical harmonics of world directions in the order
    /// (0,0) (1,−1) (1,0) (1,1) (2,−2) (2,−1) (2,0) (2,1) (2,2). share/vkbake/glsl/vkbake_light.h evaluates them.
    std::array<glm::vec3, 9> coefficients{};
    double back_sides = 0.0; ///< share of its rays that ended on a back which is not to be seen: 1 inside a closed body
};

} // namespace vkbake
