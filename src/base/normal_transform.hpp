// How a linear map turns normals.
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace vkbake {

/// A direction's unit vector as floats, or 0 where it has none.
[[nodiscard]] inline glm::vec3 unit_or_zero(const glm::dvec3& direction) {
    const double largest = std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
    if (!(largest > 0.0) || !std::isfinite(largest)) {
        return glm::vec3(0.0F);
    }
    // A power of two first: squares of very short or long vectors would leave the range of doubles.
    const glm::dvec3 scaled = direction * std::ldexp(1.0, -std::ilogb(largest));
    // Adding 0 turns a negative zero into zero: bits are compared.
    return glm::vec3(scaled / std::sqrt(glm::dot(scaled, scaled))) + glm::vec3(0.0F);
}

struct NormalTransform {
    glm::dmat3 matrix{1.0}; ///< turns normals, but for their length, as `linear` turns the surface
    bool mirrored = false;

    explicit NormalTransform(const glm::dmat3& linear) {
        mirrored = glm::dot(glm::cross(linear[0], linear[1]), linear[2]) < 0.0;
        // The inverse transpose is the cofactor matrix over the determinant; of that only the sign matters here, and
        // without the division a transform that flattens keeps its normal.
        matrix = glm::dmat3(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                            glm::cross(linear[0], linear[1])) *
                 (mirrored ? -1.0 : 1.0);
    }
};

} // namespace vkbake
