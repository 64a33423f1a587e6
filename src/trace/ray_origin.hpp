// Where a texel's rays start: its sample point, moved off the surface by as little as rounding demands.
#pragma once

#include <array>

#include <glm/vec3.hpp>

namespace vkbake {

// The two lengths below are in bake-frame units (coordinates lie in [−1, 1]; an ulp there is at most 2⁻²⁴). They are
// powers of two and fixed, so a scene that is scaled by a power of two keeps its bits. In a scene of 16 m, 2⁻²⁰ is 8
// µm.

/// Along the normal. The sample point may lie 4 · 2⁻²⁴ = 2⁻²² below its triangle's plane, rounding the origin takes up
/// to √3 · 2⁻²⁵, and the triangle test is wrong by 8 · 2⁻²⁴ at most, at distances up to 1 (see PreparedRay): together
/// less than 2⁻²⁰·³. So a ray cannot meet the plane that it leaves, and little that stands on it is passed by.
inline constexpr double origin_off_surface = 0x1p-20;

/// Away from the triangle's edges, for sample points nearer to one than this: a point clamped to the edge between a
/// floor and a wall lies in the wall's plane, and raised along the floor's normal it may lie behind it. 16 times the
/// length above: the point stays in front of a neighbour that leans over it at no less than arctan(1/16) = 3.6°.
/// Sharper creases may leak along a strip of this width, 1/8 texel of a map of 4096 across the frame; nothing farther
/// from an edge is moved.
inline constexpr double origin_from_edges = 0x1p-16;

/// `corners`: of the texel's triangle. `normal`: unit, towards the side that the texel sees. Evaluated in double and
/// rounded once. Moved off the edges the point stays in the triangle: where it is too thin to keep the distance, at
/// most to its centroid. A triangle without area has no edges to keep off.
[[nodiscard]] glm::vec3 ray_origin(const std::array<glm::vec3, 3>& corners, const glm::vec3& position,
                                   const glm::vec3& normal);

} // namespace vkbake
