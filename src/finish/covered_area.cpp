#include "finish/covered_area.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vkbake {

namespace {

/// A triangle cut by four half-planes has seven corners; rounding, where a side lies along a cut, may make some more.
struct Polygon {
    std::array<glm::dvec2, 16> corners{};
    std::size_t count = 0;

    void add(const glm::dvec2& corner) { corners[count++] = corner; }
};

/// What of it lies where sign · (coordinate − at) ≥ 0 (Sutherland and Hodgman 1974).
Polygon cut(const Polygon& polygon, int axis, double at, double sign) {
    Polygon left;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const glm::dvec2& from = polygon.corners[i];
        const glm::dvec2& to = polygon.corners[(i + 1) % polygon.count];
        const double from_depth = sign * (from[axis] - at);
        const double to_depth = sign * (to[axis] - at);
        if (from_depth >= 0.0) {
            left.add(from);
        }
        if ((from_depth < 0.0) != (to_depth < 0.0)) {
            left.add(from + (from_depth / (from_depth - to_depth)) * (to - from));
        }
    }
    return left;
}

} // namespace

double covered_area(const std::array<glm::dvec2, 3>& triangle) {
    Polygon polygon;
    std::ranges::for_each(triangle, [&](const glm::dvec2& corner) { polygon.add(corner); });
    for (const int axis : {0, 1}) {
        polygon = cut(cut(polygon, axis, 0.0, 1.0), axis, 1.0, -1.0);
    }
    double doubled = 0.0;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const glm::dvec2& a = polygon.corners[i];
        const glm::dvec2& b = polygon.corners[(i + 1) % polygon.count];
        doubled += a.x * b.y - a.y * b.x;
    }
    return 0.5 * std::abs(doubled);
}

} // namespace vkbake
