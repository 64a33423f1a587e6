// From points of the unit square to directions about a normal. Pure functions.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/elementary.hpp"

namespace vkbake {

/// Three unit vectors at right angles, right-handed: tangent × bitangent = normal.
struct OrthonormalFrame {
    glm::vec3 tangent{1.0F, 0.0F, 0.0F};
    glm::vec3 bitangent{0.0F, 1.0F, 0.0F};
    glm::vec3 normal{0.0F, 0.0F, 1.0F};

    [[nodiscard]] glm::vec3 to_world(const glm::vec3& local) const {
        return tangent * local.x + bitangent * local.y + normal * local.z;
    }
};

/// A frame about any unit normal, without a direction where it loses precision (Duff et al. 2017, "Building an
/// Orthonormal Basis, Revisited").
[[nodiscard]] inline OrthonormalFrame orthonormal_frame(const glm::vec3& normal) {
    const float sign = std::copysign(1.0F, normal.z);
    const float a = -1.0F / (sign + normal.z);
    const float b = normal.x * normal.y * a;
    return {{1.0F + sign * normal.x * normal.x * a, sign * b, -sign * normal.x},
            {b, sign + normal.y * normal.y * a, -normal.y},
            normal};
}

/// A point of the unit square in 24 bits a coordinate: it stands for ((2x + 1) / 2²⁵, (2y + 1) / 2²⁵), a cell's centre,
/// so it never lies on the square's border or on its middle lines.
struct SquarePoint {
    std::uint32_t x = 0; ///< < 2²⁴
    std::uint32_t y = 0; ///< < 2²⁴
};

/// [−1, 1]², exactly.
[[nodiscard]] inline glm::dvec2 centred(const SquarePoint& point) {
    constexpr double step = 1.0 / (1U << 24U);
    return {(2.0 * point.x + 1.0) * step - 1.0, (2.0 * point.y + 1.0) * step - 1.0};
}

/// Cosine-weighted direction about +Z, density cos θ / π (per solid angle): the concentric map of Shirley and Chiu 1997
/// lifted to the hemisphere (Malley). Always above the horizon: z ≥ 2⁻¹², the disc's radius being at most 1 − 2⁻²⁴.
[[nodiscard]] inline glm::vec3 cosine_hemisphere(const SquarePoint& point) {
    const glm::dvec2 square = centred(point);
    const bool wide = std::abs(square.x) > std::abs(square.y);
    const double radius = wide ? square.x : square.y;
    const double ratio = wide ? square.y / square.x : square.x / square.y;
    const SineCosine turn = sine_cosine(ratio * (std::numbers::pi / 4.0));
    const double along = radius * turn.cosine;
    const double across = radius * turn.sine;
    const double height = std::sqrt((1.0 - radius) * (1.0 + radius));
    return {static_cast<float>(wide ? along : across), static_cast<float>(wide ? across : along),
            static_cast<float>(height)};
}

} // namespace vkbake
