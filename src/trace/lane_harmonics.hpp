// Light that arrives at points, as spherical harmonics of where it comes from.
#pragma once

#include <array>
#include <cstddef>

#include <glm/vec3.hpp>

#include "bvh/ray_block.hpp"

namespace vkbake {

/// Of each ray of a block what arrives along it, [stratum][channel][lane]; 0 where nothing does, or is asked.
using RadianceRows = std::array<std::array<RayBlock::LaneRow, 3>, RayBlock::strata>;

inline constexpr std::size_t directional_coefficients = 4; ///< l ≤ 1
inline constexpr std::size_t probe_coefficients = 9;       ///< l ≤ 2

/// The basis, real and orthonormal, in the order of shaders/glsl/shared/vkbake_light.h. `direction`: unit.
[[nodiscard]] std::array<float, probe_coefficients> harmonics(const glm::vec3& direction);

/// Of each lane Σ L · Y over its rays. In double, in the order of the strata.
class LaneHarmonics {
public:
    /// So many of the basis, from the first on.
    explicit LaneHarmonics(std::size_t count) : m_count(count) {}

    void clear() { m_sums = {}; }
    /// All rays of a block; directions are unit, those of rays that nothing comes along finite.
    void add(const RayBlock& block, const RadianceRows& radiance);
    void add(std::size_t lane, const glm::vec3& direction, const glm::dvec3& light);

    [[nodiscard]] std::size_t count() const { return m_count; }
    [[nodiscard]] glm::dvec3 sum(std::size_t coefficient, std::size_t lane) const {
        const auto& rows = m_sums[coefficient];
        return {rows[0][lane], rows[1][lane], rows[2][lane]};
    }

private:
    std::size_t m_count;
    alignas(64) std::array<std::array<std::array<double, RayBlock::lanes>, 3>, probe_coefficients> m_sums{};
};

/// Whether light counts from below a point's surface too.
enum class Horizon : unsigned char {
    surface, ///< not from below the shading or the geometric normal's plane
    none     ///< a point in the air: from everywhere
};

} // namespace vkbake
