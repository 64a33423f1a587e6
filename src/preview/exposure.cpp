#include "preview/exposure.hpp"

#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>

namespace vkbake {

namespace {

double luminance(const glm::dvec3& color) { return glm::dot(color, glm::dvec3(0.2126, 0.7152, 0.0722)); } // Rec. 709

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
    constexpr double black = 0.01;
    return mean_above(light_maps, black * luminance(mean_above(light_maps, 0.0)));
}

double automatic_exposure(const std::vector<Image>& light_maps) {
    constexpr double shown_white = 0.4;
    const double light = luminance(mean_light(light_maps));
    return light > 0.0 ? shown_white / light : 1.0;
}

} // namespace vkbake
