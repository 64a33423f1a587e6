#include "trace/known_light.hpp"

#include <cmath>
#include <cstddef>

#include <glm/vec3.hpp>

#include "base/luminance.hpp"

namespace vkbake {

double mean_luminance(const LightMap& map) {
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t texel = 0; texel < map.image.texels.size(); ++texel) {
        if (map.image.coverage[texel] > 0.0F) {
            sum += luminance(glm::dvec3(glm::vec3(map.image.texels[texel])));
            count += 1.0;
        }
    }
    return count > 0.0 ? sum / count : 0.0;
}

std::optional<KnownLight> known_light(const LightMap& map) {
    if (!map.error) {
        return std::nullopt;
    }
    const double mean = mean_luminance(map);
    return KnownLight{mean, std::pow(map.error->relative_rmse * mean, 2.0)};
}

} // namespace vkbake
