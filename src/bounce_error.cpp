#include "bounce_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "base/luminance.hpp"

namespace vkbake {

namespace {

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

/// Of the covered texels.
double percentile_99(const LightMap& map) {
    std::vector<float> errors;
    for (std::size_t texel = 0; texel < map.standard_error.size(); ++texel) {
        if (map.image.coverage[texel] > 0.0F) {
            errors.push_back(map.standard_error[texel]);
        }
    }
    if (errors.empty()) {
        return 0.0;
    }
    const auto place = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() * 99 / 100);
    std::nth_element(errors.begin(), place, errors.end());
    return static_cast<double>(*place);
}

void add_error(const LightMap& gathered, double mean_before, LightMap& map) {
    MapError& error = *map.error;
    const double mean = mean_luminance(map);
    const double before = error.relative_rmse * mean_before;
    const double after = gathered.error->relative_rmse * mean;
    for (std::size_t texel = 0; texel < map.standard_error.size(); ++texel) {
        map.standard_error[texel] = std::hypot(map.standard_error[texel], gathered.standard_error[texel]);
    }
    error.relative_rmse = gathered.error->relative_rmse;
    error.percentile_99 = mean > 0.0 ? percentile_99(map) / mean : 0.0;
    if (error.noise_rmse > 0.0 && mean > 0.0) {
        const double noise = error.noise_rmse * mean_before;
        error.noise_rmse = std::sqrt(noise * noise + std::max(after * after - before * before, 0.0)) / mean;
    }
    error.target_reached = gathered.error->target_reached;
}

} // namespace

std::optional<KnownLight> known_light(const LightMap& map) {
    if (!map.error) {
        return std::nullopt;
    }
    const double mean = mean_luminance(map);
    return KnownLight{mean, std::pow(map.error->relative_rmse * mean, 2.0)};
}

void add_bounce(const LightMap& gathered, LightMap& map) {
    const double mean_before = map.error ? mean_luminance(map) : 0.0;
    for (std::size_t texel = 0; texel < map.image.texels.size(); ++texel) {
        map.image.texels[texel] += glm::vec4(glm::vec3(gathered.image.texels[texel]), 0.0F);
    }
    if (map.error && gathered.error) {
        add_error(gathered, mean_before, map);
    }
    map.statistics.bounce_rays += gathered.statistics.bounce_rays;
    map.statistics.seconds += gathered.statistics.seconds;
}

} // namespace vkbake
