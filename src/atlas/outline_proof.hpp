// A quick proof that triangles do not overlap.
#pragma once

#include <cstdint>
#include <span>

#include <glm/vec2.hpp>

namespace vkbake {

/// True proves that no two of these triangles (numbers; three entries of `corners` each) overlap; false says nothing.
/// In about linear time, where a tree of triangles asks each for its neighbours: triangles that all turn one way, hang
/// together by common sides, and go around each corner no more than once are a surface that is laid out in the plane
/// without folds; such a surface overlaps itself only where its outline crosses or touches itself. (By Hopf's theorem
/// the outline's loops turn as often as the surface's Euler characteristic says; simple loops apart from each other
/// can do so only as one around all the others, which are holes.) Exact; triangles without area are left out.
[[nodiscard]] bool outline_proves_no_overlap(std::span<const glm::vec2> corners,
                                             std::span<const std::uint32_t> triangles);

} // namespace vkbake
