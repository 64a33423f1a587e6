// A flat square of surface in one chart, lit as told, with noise of known variance.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "finish/denoise_fields.hpp"

namespace vkbake::test {

class NoisyMap {
public:
    using Light = std::function<double(int x, int y)>;

    /// `sigma`: of a texel's luminance, as it is and as it is told. `noisy` false: told only.
    NoisyMap(int side, double sigma, const Light& light, std::uint32_t seed = 1, bool noisy = true)
        : truth(static_cast<std::size_t>(side) * static_cast<std::size_t>(side)) {
        std::mt19937 random(seed);
        const auto uniform = [&] { return (static_cast<double>(random()) + 0.5) / 4294967296.0; };
        map.image = {.width = side, .height = side, .texels = {}, .coverage = std::vector(truth.size(), 1.0F)};
        geometry.width = geometry.height = side;
        geometry.position = geometry.shading_normal = ZeroedArray<glm::vec3>(truth.size());
        double mean = 0.0;
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const std::size_t texel = map.image.index(x, y);
                const double normal = // Box and Muller's
                    std::sqrt(-2.0 * std::log(uniform())) * std::cos(2.0 * std::numbers::pi * uniform());
                truth[texel] = light(x, y);
                mean += truth[texel] / static_cast<double>(truth.size());
                map.image.texels.emplace_back(glm::vec3(glm::dvec3(truth[texel] + (noisy ? sigma * normal : 0.0))),
                                              1.0F);
                geometry.position[texel] = glm::vec3(glm::dvec3(0.01 * x, 0.0, 0.01 * y));
                geometry.shading_normal[texel] = {0, 1, 0};
                geometry.triangle.push_back(static_cast<std::uint32_t>(texel)); // a chart a texel can be told
            }
        }
        chart.assign(truth.size(), 0);
        variance.assign(truth.size(), static_cast<float>(sigma * sigma));
        map.standard_error.assign(truth.size(), static_cast<float>(sigma));
        map.error = MapError{.relative_rmse = sigma / mean};
    }

    [[nodiscard]] DenoiseGuides guides() const { return {geometry, chart, variance}; }

    /// Root-mean-square error ÷ mean.
    [[nodiscard]] double relative_rmse() const {
        double squares = 0.0;
        double sum = 0.0;
        for (std::size_t texel = 0; texel < truth.size(); ++texel) {
            squares += std::pow(static_cast<double>(map.image.texels[texel].g) - truth[texel], 2.0);
            sum += truth[texel];
        }
        return std::sqrt(squares * static_cast<double>(truth.size())) / sum;
    }
    /// Of a column, over the rows.
    [[nodiscard]] double column_mean(int x) const {
        double sum = 0.0;
        for (int y = 0; y < map.image.height; ++y) {
            sum += static_cast<double>(map.image.texels[map.image.index(x, y)].g);
        }
        return sum / map.image.height;
    }

    LightMap map;
    GeometryImage geometry;
    std::vector<std::uint32_t> chart;
    std::vector<float> variance;
    std::vector<double> truth;
};

} // namespace vkbake::test
