// Moving pieces about in the plane.
#pragma once

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace vkbake {

/// Turns by the unit vector `turn` (as a complex number), then moves.
struct RigidMotion {
    glm::dvec2 turn{1.0, 0.0};
    glm::dvec2 move{0.0};

    [[nodiscard]] glm::dvec2 operator()(const glm::dvec2& p) const {
        return glm::dvec2(turn.x * p.x - turn.y * p.y, turn.x * p.y + turn.y * p.x) + move;
    }

    /// Takes the middle and direction of a → b to those of c → d.
    static RigidMotion between(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
        const glm::dvec2 from = b - a;
        const glm::dvec2 to = d - c;
        const glm::dvec2 way(glm::dot(from, to), from.x * to.y - from.y * to.x);
        RigidMotion motion{way / glm::length(way), glm::dvec2(0.0)};
        motion.move = 0.5 * (c + d) - motion(0.5 * (a + b));
        return motion;
    }
};

struct PlaneBox {
    glm::dvec2 lower{1e300};
    glm::dvec2 upper{-1e300};

    void add(const glm::dvec2& p) {
        lower = {std::min(lower.x, p.x), std::min(lower.y, p.y)};
        upper = {std::max(upper.x, p.x), std::max(upper.y, p.y)};
    }
    [[nodiscard]] double longest() const { return std::max(upper.x - lower.x, upper.y - lower.y); }
    [[nodiscard]] double area() const { return (upper.x - lower.x) * (upper.y - lower.y); }
};

} // namespace vkbake
