#include "trace/sampler.hpp"

#include <glm/geometric.hpp>

namespace vkbake {

namespace {

/// Sine and cosine of any angle of the thesis's loops, in radians: brought to |x| ≤ π/4 by quarter turns.
SineCosine sine_cosine_any(double angle) { return sine_cosine_degrees(angle * (180.0 / std::numbers::pi)); }

} // namespace

ThesisSampler::ThesisSampler() : m_samples{} {
    // Whole numbers count the steps: 0.2 added up in floating point could take one step more or fewer.
    for (std::uint32_t i = 0; i < phi_count; ++i) {
        const SineCosine phi = sine_cosine_any(step * i);
        for (std::uint32_t j = 0; j < theta_count; ++j) {
            const SineCosine theta = sine_cosine_any(step * j);
            const glm::dvec3 direction(theta.sine * phi.cosine, theta.sine * phi.sine, theta.cosine);
            m_samples[i * theta_count + j] = {glm::vec3(direction), theta.cosine * theta.sine};
        }
    }
}

ThesisSampler::Texel::Texel(const ThesisSampler& sampler, const glm::vec3& normal)
    : m_sampler(&sampler), m_frame(thesis_frame(normal)) {}

} // namespace vkbake
