// From points of the unit square to directions about a normal. Pure functions.
#pragma once

#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace vkbake {

/// Three unit vectors at right angles, right-handed: tangent × bitangent = normal.
struct OrthonormalFrame {
    glm::vec3 tangent{1.0F, 0.0F, 0.0F};
    glm::vec3 bitangent{0.0F, 1.0F, 0.0F};
    glm::vec3 normal{0.0F, 0.0F, 1.0F};
};

/// A frame about any unit normal that turns as little as it can from one normal to the next: where neighbours' frames
/// agree, so do their rays. The frame of Duff et al. 2017, "Building an Orthonormal Basis, Revisited", changes by half
/// a turn across the plane that its two halves share; that plane holds every upright wall, and a flat floor whose
/// normals are off by a rounding. So the first half is carried on (Frisvad 2012), about an axis chosen such that its
/// one bad place, the opposite of the axis, is a direction in which few surfaces face; only within 1.8° of it, where
/// it loses precision, the second half takes over. In double, and of a normal made unit in double, for it divides by a
/// difference that is small near there.
[[nodiscard]] inline OrthonormalFrame orthonormal_frame(const glm::vec3& normal) {
    // Three unit vectors at right angles in whole numbers: (2, 6, 3) / 7, the axis, lies 31° off +Y and along no other.
    const glm::dvec3 unit = glm::normalize(glm::dvec3(normal));
    const glm::dvec3 u = glm::dvec3(6.0, -3.0, 2.0) / 7.0;
    const glm::dvec3 v = glm::dvec3(3.0, 2.0, -6.0) / 7.0;
    const glm::dvec3 axis = glm::dvec3(2.0, 6.0, 3.0) / 7.0; // u × v
    const double x = glm::dot(unit, u);
    const double y = glm::dot(unit, v);
    const double z = glm::dot(unit, axis);
    const double sign = z > -0.9995 ? 1.0 : -1.0;
    const double a = -1.0 / (sign + z);
    const double b = x * y * a;
    const auto back = [&](double p, double q, double r) { return glm::vec3(p * u + q * v + r * axis); };
    return {back(1.0 + sign * x * x * a, sign * b, -sign * x), back(b, sign + y * y * a, -y), normal};
}

/// A point of the unit square in 24 bits a coordinate: it stands for ((2x + 1) / 2²⁵, (2y + 1) / 2²⁵), a cell's centre,
/// so it never lies on the square's border or on its middle lines.
struct SquarePoint {
    std::uint32_t x = 0; ///< < 2²⁴
    std::uint32_t y = 0; ///< < 2²⁴
};

} // namespace vkbake
