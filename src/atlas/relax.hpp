// Lays a piece of surface out so that it keeps its shape as well as it can.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "atlas/chart_mesh.hpp"

namespace vkbake {

/// Moves `places` towards the least Σ area · ‖J − R‖² over the triangles, J the map's derivative and R the rotation
/// next to it: up to so many rounds of Liu, Zhang, Xu, Gotsman and Gortler, "A local/global approach to mesh
/// parameterization" (2008), whose global step is one sparse system, factorised once; fewer where triangles
/// no longer turn. `points`: 3 a triangle, which of
/// the places its corners are; all hang together. Returns false, and leaves `places` as they were, where the system
/// cannot be solved.
[[nodiscard]] bool relax(const ChartMesh& mesh, std::span<const std::uint32_t> triangles,
                         std::span<const std::uint32_t> points, std::vector<glm::dvec2>& places, int rounds);

} // namespace vkbake
