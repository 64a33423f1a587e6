// Exact geometry of triangles in the plane.
#pragma once

#include <array>

#include <glm/vec2.hpp>

namespace vkbake {

/// Three corners with finite coordinates, in any order.
using FlatTriangle = std::array<glm::vec2, 3>;

/// +1 where a → b → c turns from the x axis towards the y axis, −1 where it turns the other way, 0 where the three lie
/// on one line. Exact for all finite floats whose magnitudes are below 2^500 (so for every float). After Shewchuk,
/// "Adaptive precision floating-point arithmetic and fast robust geometric predicates" (1997).
[[nodiscard]] int orientation(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c);

/// The sign of a triangle's area.
[[nodiscard]] inline int orientation(const FlatTriangle& triangle) {
    return orientation(triangle[0], triangle[1], triangle[2]);
}

/// Whether the triangles' intersection has area. Exact. Which way either turns does not matter; one without area
/// overlaps nothing; shared corners and edges are no overlap.
[[nodiscard]] bool triangles_overlap(const FlatTriangle& first, const FlatTriangle& second);

/// Whether all of `points` lie on or beyond the line of one of the triangle's edges, so that no point inside the
/// triangle is inside their convex hull. Exact. `turn` is the triangle's orientation, not 0.
template<typename Points>
[[nodiscard]] bool separated_by_edge(const FlatTriangle& triangle, int turn, const Points& points) {
    for (unsigned edge = 0; edge < 3; ++edge) {
        const glm::vec2& from = triangle[edge];
        const glm::vec2& to = triangle[(edge + 1) % 3];
        bool beyond = true;
        for (const glm::vec2& point : points) {
            beyond = beyond && turn * orientation(from, to, point) <= 0;
        }
        if (beyond) {
            return true;
        }
    }
    return false;
}

} // namespace vkbake
