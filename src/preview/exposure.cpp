#include "preview/exposure.hpp"

#include <cmath>
#include <cstddef>

#include "base/luminance.hpp"

namespace vkbake {

namespace {

constexpr double black_share = 0.01; ///< of the mean: what is darker counts as black

/// Of the covered, finite texels whose luminance is at least `least`.
glm::dvec3 mean_above(const std::vector<Image>& light_maps, double least) {
    glm::dvec3 sum(0.0);
    std::size_t count = 0;
    for (const Image& map : light_maps) {
        for (std::size_t i = 0; i < map.texels.size(); ++i) {
            const glm::vec4& texel = map.texels[i];
            const bool covered = map.coverage.empty() ? texel.a > 0.0F : map.coverage[i] > 0.5F;
            const bool finite = std::isfinite(texel.r) && std::isfinite(texel.g) && std::isfinite(texel.b);
            if (covered && finite && luminance(glm::dvec3(texel)) >= least) {
                sum += glm::dvec3(texel);
                ++count;
            }
        }
    }
    return count > 0 ? sum / static_cast<double>(count) : sum;
}

} // namespace

glm::dvec3 mean_light(const std::vector<Image>& light_maps) {
    return mean_above(light_maps, black_share * luminance(mean_above(light_maps, 0.0)));
}

std::optional<double> metered_exposure(std::span<const glm::vec4> light) {
    constexpr double shown_white = 0.4;
    std::vector<double> seen;
    double sum = 0.0;
    for (const glm::vec4& pixel : light) {
        const double value = luminance(glm::dvec3(pixel));
        if (pixel.a > 0.0F && std::isfinite(value) && value > 0.0) {
            seen.push_back(value);
            sum += value;
        }
    }
    double logarithms = 0.0;
    std::size_t count = 0;
    for (const double value : seen) {
        if (value >= black_share * sum / static_cast<double>(seen.size())) {
            logarithms += std::log(value);
            ++count;
        }
    }
    if (count == 0) {
        return std::nullopt;
    }
    return shown_white / std::exp(logarithms / static_cast<double>(count));
}

} // namespace vkbake
