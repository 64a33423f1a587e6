#include "preview/exposure.hpp"

#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>

namespace vkbake {

glm::dvec3 mean_light(const std::vector<Image>& light_maps) {
    glm::dvec3 sum(0.0);
    std::size_t count = 0;
    for (const Image& map : light_maps) {
        for (std::size_t i = 0; i < map.texels.size(); ++i) {
            const glm::vec4& texel = map.texels[i];
            const bool covered = map.coverage.empty() ? texel.a > 0.0F : map.coverage[i] > 0.5F;
            if (covered && std::isfinite(texel.r) && std::isfinite(texel.g) && std::isfinite(texel.b)) {
                sum += glm::dvec3(texel);
                ++count;
            }
        }
    }
    return count > 0 ? sum / static_cast<double>(count) : sum;
}

double automatic_exposure(const std::vector<Image>& light_maps) {
    constexpr double shown_white = 0.4;
    const double luminance = glm::dot(mean_light(light_maps), glm::dvec3(0.2126, 0.7152, 0.0722)); // Rec. 709
    return luminance > 0.0 ? shown_white / luminance : 1.0;
}

} // namespace vkbake
