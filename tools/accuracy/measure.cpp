#include "accuracy/measure.hpp"

#include <cmath>
#include <cstddef>

namespace vkbake::accuracy {

double mean_rays(const Bake& bake) {
    double samples = 0.0;
    double texels = 0.0;
    for (const LightMap& map : bake.light_maps) {
        samples += static_cast<double>(map.statistics.rays + map.statistics.skipped_directions);
        texels += static_cast<double>(map.statistics.covered_texels);
    }
    return samples / texels;
}

double trace_seconds(const Bake& bake) {
    double seconds = 0.0;
    for (const LightMap& map : bake.light_maps) {
        seconds += map.statistics.seconds;
    }
    return seconds;
}

double rays_for(const std::vector<std::pair<double, double>>& points, double error) {
    std::size_t next = 1;
    while (next + 1 < points.size() && points[next].second > error) {
        ++next;
    }
    const auto& [rays_a, error_a] = points[next - 1];
    const auto& [rays_b, error_b] = points[next];
    const double slope = std::log(error_b / error_a) / std::log(rays_b / rays_a);
    return rays_a * std::exp(std::log(error / error_a) / slope);
}

Slope fit_slope(const std::vector<std::pair<double, double>>& points) {
    const auto count = static_cast<double>(points.size());
    double mean_x = 0.0;
    double mean_y = 0.0;
    for (const auto& [rays, error] : points) {
        mean_x += std::log(rays) / count;
        mean_y += std::log(error) / count;
    }
    double xx = 0.0;
    double xy = 0.0;
    for (const auto& [rays, error] : points) {
        xx += (std::log(rays) - mean_x) * (std::log(rays) - mean_x);
        xy += (std::log(rays) - mean_x) * (std::log(error) - mean_y);
    }
    Slope slope{xy / xx, 0.0};
    double left = 0.0;
    for (const auto& [rays, error] : points) {
        const double off = std::log(error) - mean_y - slope.value * (std::log(rays) - mean_x);
        left += off * off;
    }
    slope.standard_error = std::sqrt(left / (count - 2.0) / xx);
    return slope;
}

} // namespace vkbake::accuracy
