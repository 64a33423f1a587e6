// Which directions a texel looks in, and what each counts.
//
// A sampler is: `count()`, the samples a texel takes; `scale()`, by which the weighted sum is multiplied; and
// `at(key, normal)`, one texel's directions, whose `sample(index)` needs no other sample.
#pragma once

#include <array>
#include <cstdint>

#include "base/sampling.hpp"
#include "base/sampling_sobol.hpp"
#include "trace/thesis_directions.hpp"

namespace vkbake {

struct HemisphereSample {
    glm::vec3 direction{0.0F}; ///< unit
    double weight = 1.0;
};

/// Cosine-weighted directions at the points of Sobol's sequence, scrambled for each texel by its key. E/π is estimated
/// by the plain mean of L, for any number of samples; a hemisphere of radiance 1 gives 1 exactly.
class CosineSampler {
public:
    explicit CosineSampler(std::uint32_t count) : m_count(count) {}

    class Texel {
    public:
        Texel(std::uint64_t key, const glm::vec3& normal) : m_points(key), m_frame(orthonormal_frame(normal)) {}
        [[nodiscard]] HemisphereSample sample(std::uint32_t index) const {
            return {m_frame.to_world(cosine_hemisphere(m_points.point(index))), 1.0};
        }

    private:
        ScrambledSobol m_points;
        OrthonormalFrame m_frame;
    };

    [[nodiscard]] std::uint32_t count() const { return m_count; }
    [[nodiscard]] double scale() const { return 1.0 / m_count; }
    [[nodiscard]] static Texel at(std::uint64_t key, const glm::vec3& normal) { return {key, normal}; }

private:
    std::uint32_t m_count;
};

/// The sampling loop of the thesis (§2.6.1, §2.6.2, §3.3.3): φ = 0, 0.2 … 6.2 outside, θ = 0, 0.2 … 1.4 inside, the
/// same 256 directions for every texel, weight cos θ sin θ, E/π ≈ π/256 · Σ L cos θ sin θ. Its left sum in θ and its
/// normalisation by π/256 where the steps cover 0.2 · 0.2 make a hemisphere of radiance 1 come out as 0.97353. The
/// eight directions of one φ start with the normal itself (θ = 0), whose weight is 0.
class ThesisSampler {
public:
    static constexpr std::uint32_t phi_count = 32;
    static constexpr std::uint32_t theta_count = 8;
    static constexpr std::uint32_t sample_count = phi_count * theta_count;
    static constexpr double step = 0.2; ///< radians, of both angles

    ThesisSampler();

    class Texel {
    public:
        Texel(const ThesisSampler& sampler, const glm::vec3& normal);
        [[nodiscard]] HemisphereSample sample(std::uint32_t index) const {
            const HemisphereSample& local = m_sampler->m_samples[index];
            return {m_frame.to_world(local.direction), local.weight};
        }

    private:
        const ThesisSampler* m_sampler; ///< never null; outlives the texel
        OrthonormalFrame m_frame;
    };

    [[nodiscard]] static constexpr std::uint32_t count() { return sample_count; }
    [[nodiscard]] static double scale() { return std::numbers::pi / count(); }
    [[nodiscard]] Texel at(std::uint64_t /*key*/, const glm::vec3& normal) const { return {*this, normal}; }

private:
    std::array<HemisphereSample, sample_count> m_samples; ///< about +Z
};

} // namespace vkbake
