// The hemisphere of directions of the thesis.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <glm/vec3.hpp>

#include "base/sampling.hpp"
#include "bvh/ray_block.hpp"

namespace vkbake {

/// The sampling loop of the thesis (§2.6.1, §2.6.2, §3.3.3): φ = 0, 0.2 … 6.2, θ = 0, 0.2 … 1.4, the same 256
/// directions for every texel, weight cos θ sin θ, E/π ≈ π/256 · Σ L cos θ sin θ. Its left sum in θ and its
/// normalisation by π/256 where the steps cover 0.2 · 0.2 make a hemisphere of radiance 1 come out as 0.97353. The
/// eight directions of one φ start with the normal itself (θ = 0), whose weight is 0.
class ThesisDirections {
public:
    static constexpr std::uint32_t phi_count = 32;
    static constexpr std::uint32_t theta_count = 8;
    static constexpr std::uint32_t count = phi_count * theta_count;
    static constexpr double step = 0.2; ///< radians, of both angles

    struct Sample {
        glm::vec3 direction{0.0F}; ///< unit, about +Z
        double weight = 0.0;
    };

    ThesisDirections();

    [[nodiscard]] static constexpr std::size_t block_count() { return count / RayBlock::strata; }
    [[nodiscard]] static constexpr std::uint32_t rays() { return count; }
    /// Each block of 16 holds 4 neighbouring φ, of each 4 neighbouring θ.
    [[nodiscard]] const Sample& sample(std::size_t block, std::size_t stratum) const {
        return m_samples[block * RayBlock::strata + stratum];
    }

private:
    std::array<Sample, count> m_samples; ///< in the blocks' order
};

/// The tangent frame of the thesis (§3.3.3): tangent = n × up, bitangent = n × tangent, both normalised, up being +Y;
/// where n and up are parallel, (1, 0, 0) and (0, 0, 1). Left- or right-handed as the cross products give it.
[[nodiscard]] OrthonormalFrame thesis_frame(const glm::vec3& normal);

} // namespace vkbake
