#include "bounce_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "base/percentile.hpp"
#include "trace/known_light.hpp"

namespace vkbake {

namespace {

void add_error(const LightMap& gathered, const KnownLight& known, LightMap& map) {
    MapError& error = *map.error;
    const double mean = mean_luminance(map);
    const double after = gathered.error->relative_rmse * mean;
    for (std::size_t texel = 0; texel < map.standard_error.size(); ++texel) {
        map.standard_error[texel] = std::hypot(map.standard_error[texel], gathered.standard_error[texel]);
    }
    error.relative_rmse = gathered.error->relative_rmse;
    error.percentile_99 = mean > 0.0 ? covered_percentile_99(map.standard_error, map.image.coverage) / mean : 0.0;
    if (error.noise_rmse > 0.0 && mean > 0.0) {
        const double noise = error.noise_rmse * known.mean;
        error.noise_rmse = std::sqrt(noise * noise + std::max(after * after - known.variance, 0.0)) / mean;
    }
    error.target_reached = gathered.error->target_reached;
}

} // namespace

void add_bounce(const LightMap& gathered, LightMap& map) {
    const std::optional<KnownLight> before = known_light(map);
    for (std::size_t texel = 0; texel < map.image.texels.size(); ++texel) {
        map.image.texels[texel] += glm::vec4(glm::vec3(gathered.image.texels[texel]), 0.0F);
    }
    if (before && gathered.error) {
        add_error(gathered, *before, map);
    }
    map.statistics.bounce_rays += gathered.statistics.bounce_rays;
    map.statistics.seconds += gathered.statistics.seconds;
}

} // namespace vkbake
