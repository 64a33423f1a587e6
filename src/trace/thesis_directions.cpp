#include "trace/thesis_directions.hpp"

#include <numbers>

#include <glm/geometric.hpp>

#include "base/elementary.hpp"

namespace vkbake {

namespace {

/// Sine and cosine of any angle of the thesis's loops, in radians: brought to |x| ≤ π/4 by quarter turns.
SineCosine sine_cosine_any(double angle) { return sine_cosine_degrees(angle * (180.0 / std::numbers::pi)); }

} // namespace

ThesisDirections::ThesisDirections() : m_samples{} {
    // Whole numbers count the steps: 0.2 added up in floating point could take one step more or fewer.
    for (std::uint32_t i = 0; i < phi_count; ++i) {
        const SineCosine phi = sine_cosine_any(step * i);
        for (std::uint32_t j = 0; j < theta_count; ++j) {
            const SineCosine theta = sine_cosine_any(step * j);
            const glm::dvec3 direction(theta.sine * phi.cosine, theta.sine * phi.sine, theta.cosine);
            const std::uint32_t block = (i / 4) * (theta_count / 4) + j / 4;
            m_samples[block * RayBlock::strata + (i % 4) * 4 + j % 4] = {glm::vec3(direction),
                                                                         theta.cosine * theta.sine};
        }
    }
}

OrthonormalFrame thesis_frame(const glm::vec3& normal) {
    const glm::vec3 up(0.0F, 1.0F, 0.0F);
    const glm::vec3 tangent = glm::cross(normal, up);
    const float length = glm::length(tangent);
    // A float normal errs by about 1e-7 a coordinate: this near to ±up, its direction across up is noise, and a flat
    // floor would be sampled by a frame that spins from texel to texel.
    constexpr float parallel = 1e-6F;
    if (length < parallel) {
        return {{1.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 1.0F}, normal};
    }
    const glm::vec3 unit_tangent = tangent / length;
    return {unit_tangent, glm::normalize(glm::cross(normal, unit_tangent)), normal};
}

} // namespace vkbake
