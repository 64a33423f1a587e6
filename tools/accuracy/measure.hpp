// What bakes of one scene took, and how their errors fall.
#pragma once

#include <utility>
#include <vector>

#include "vkbake/vkbake.hpp"

namespace vkbake::accuracy {

/// Samples a texel, over all maps.
[[nodiscard]] double mean_rays(const Bake& bake);

/// Seconds that tracing took.
[[nodiscard]] double trace_seconds(const Bake& bake);

/// The number of rays at which a line through the logarithms of (rays, error) of neighbouring points reaches `error`;
/// beyond the points, along the last one's.
[[nodiscard]] double rays_for(const std::vector<std::pair<double, double>>& points, double error);

/// Slope of the straight line of least squares through the logarithms, and its standard error.
struct Slope {
    double value = 0.0;
    double standard_error = 0.0;
};
[[nodiscard]] Slope fit_slope(const std::vector<std::pair<double, double>>& points);

} // namespace vkbake::accuracy
