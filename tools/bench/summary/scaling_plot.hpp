// The time a ray takes against the number of triangles.
#pragma once

#include <string>
#include <vector>

#include "bench/summary/results.hpp"

namespace vkbake::bench {

/// An SVG picture: nanoseconds a ray on one thread, rays made on the way, of our blocks and of Embree robust, and
/// c · log n through our first point. Both axes from the results; `results` holds at least two.
[[nodiscard]] std::string scaling_plot(std::vector<Result> results);

} // namespace vkbake::bench
