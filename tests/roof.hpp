// A roof of two faces that meet along a line aslant through the texels of its map.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "host_bake.hpp"

namespace vkbake::test {

/// Texels along a side of its map, which it fills: the roof is the unit square there, seen from above.
constexpr int roof_side = 16;

/// Its crease runs from (1/4, 0) to (3/4, 1).
inline double crease_at(double v) { return 0.25 + 0.5 * v; }

/// The second face goes down by as much as it is away from the crease.
inline Primitive roof() {
    Primitive primitive;
    for (const auto& [u, v] : {std::pair(0.0, 0.0), {0.25, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {0.75, 1.0}, {1.0, 1.0}}) {
        const double beyond = std::max(0.0, u - crease_at(v)) / std::sqrt(1.25);
        add_vertex(primitive, glm::vec3(glm::dvec3(u, -beyond, v)));
    }
    primitive.indices = {0, 3, 1, 1, 3, 4, 1, 4, 2, 2, 4, 5};
    return primitive;
}

inline glm::dvec3 first_normal() { return {0.0, 1.0, 0.0}; }
inline glm::dvec3 second_normal() { return glm::normalize(glm::dvec3(1.0, std::sqrt(1.25), -0.5)); }

/// Of texel (x, y), what lies on the first face: where the crease stands between its sides, integrated exactly, as the
/// crease stays between the same borders on either side of where it meets one.
inline double first_share(int x, int y) {
    const auto cut = [&](double v) { return std::clamp(crease_at(v) * roof_side - x, 0.0, 1.0); };
    // The crease meets the columns' borders at v = 2 (border / side − 1/4): for 16 texels in the middle of rows at the
    // most, so halves of rows are integrated by the trapezoidal rule.
    const double top = static_cast<double>(y) / roof_side;
    const double half = 0.5 / roof_side;
    return (cut(top) + 2.0 * cut(top + half) + cut(top + 2.0 * half)) / 4.0;
}

/// The sky's radiance is 1 + sky_slope · ω, under which an open surface of normal n gets E/π = 1 + ⅔ sky_slope · n.
constexpr glm::dvec3 sky_slope{0.8, 0.3, -0.2};
inline double under_sloping_sky(const glm::dvec3& normal) { return 1.0 + 2.0 / 3.0 * glm::dot(normal, sky_slope); }

} // namespace vkbake::test
