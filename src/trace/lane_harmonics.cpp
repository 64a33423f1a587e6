#include "trace/lane_harmonics.hpp"

namespace vkbake {

std::array<float, probe_coefficients> harmonics(const glm::vec3& direction) {
    const float x = direction.x;
    const float y = direction.y;
    const float z = direction.z;
    constexpr float band_0 = 0.282094792F;  // √(1 / 4π)
    constexpr float band_1 = 0.488602512F;  // √(3 / 4π)
    constexpr float band_2 = 1.09254843F;   // √(15 / 4π)
    constexpr float along_z = 0.315391565F; // √(5 / 16π)
    return {band_0,
            band_1 * y,
            band_1 * z,
            band_1 * x,
            band_2 * x * y,
            band_2 * y * z,
            along_z * (3.0F * z * z - 1.0F),
            band_2 * x * z,
            0.5F * band_2 * (x * x - y * y)};
}

void LaneHarmonics::add(const RayBlock& block, const RadianceRows& radiance) {
    std::array<RayBlock::LaneRow, probe_coefficients> basis{};
    for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
        if (block.active[stratum] == 0) {
            continue;
        }
        const auto& [x, y, z] = block.direction[stratum];
        for (std::size_t lane = 0; lane < RayBlock::lanes; ++lane) {
            const auto values = harmonics({x[lane], y[lane], z[lane]});
            for (std::size_t coefficient = 0; coefficient < m_count; ++coefficient) {
                basis[coefficient][lane] = values[coefficient];
            }
        }
        for (std::size_t coefficient = 0; coefficient < m_count; ++coefficient) {
            for (std::size_t channel = 0; channel < 3; ++channel) {
                auto& sums = m_sums[coefficient][channel];
                for (std::size_t lane = 0; lane < RayBlock::lanes; ++lane) {
                    sums[lane] += static_cast<double>(basis[coefficient][lane]) *
                                  static_cast<double>(radiance[stratum][channel][lane]);
                }
            }
        }
    }
}

void LaneHarmonics::add(std::size_t lane, const glm::vec3& direction, const glm::dvec3& light) {
    const auto values = harmonics(direction);
    for (std::size_t coefficient = 0; coefficient < m_count; ++coefficient) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            m_sums[coefficient][channel][lane] +=
                static_cast<double>(values[coefficient]) * light[static_cast<glm::length_t>(channel)];
        }
    }
}

} // namespace vkbake
