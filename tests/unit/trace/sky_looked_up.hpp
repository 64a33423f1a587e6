// Skies that tests look up.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numbers>
#include <vector>

#include <glm/vec3.hpp>

#include "base/random.hpp"
#include "trace/sky_sum.hpp"
#include "vkbake/image.hpp"

namespace vkbake::test {

inline Image picture(int width, int height, const std::function<glm::vec3(int, int)>& value) {
    Image image{width, height, {}, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            image.texels.emplace_back(value(x, y), 1.0F);
        }
    }
    return image;
}

/// One after the other, in all lanes and strata.
inline std::vector<glm::vec3> radiances(const SkyLookup& sky, const std::vector<glm::vec3>& directions) {
    std::vector<glm::vec3> found;
    for (std::size_t i = 0; i < directions.size(); ++i) { // each in a stratum and lane of its own, with weight 1
        const std::size_t lane = i % RayBlock::lanes;
        const std::size_t stratum = i / RayBlock::lanes % RayBlock::strata;
        RayBlock block;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            block.direction[stratum][axis][lane] = directions[i][static_cast<int>(axis)];
        }
        BlockedRays open{};
        open[stratum] = static_cast<RayBlock::LaneBits>(1U << lane);
        std::array<double, RayBlock::strata> weights{};
        weights[stratum] = 1.0;
        LaneSums sums;
        add_sky(sky, block, open, weights, sums);
        found.emplace_back(total(sky, sums, lane));
    }
    return found;
}

inline double pseudo_random(std::uint64_t key) { return static_cast<double>(mix64(key) >> 11U) * 0x1p-53; }

inline glm::vec3 pseudo_random_direction(std::uint64_t key) {
    const double z = 2.0 * pseudo_random(2 * key) - 1.0;
    const double phi = 2.0 * std::numbers::pi * pseudo_random(2 * key + 1);
    const double radius = std::sqrt(1.0 - z * z);
    return {radius * std::cos(phi), radius * std::sin(phi), z};
}

} // namespace vkbake::test
