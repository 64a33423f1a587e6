#include "atlas/chart.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace vkbake {

Chart bounded_chart(std::vector<std::uint32_t> triangles, std::span<const glm::vec2> flat) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Chart chart{std::move(triangles), glm::dvec2(infinity), glm::dvec2(-infinity), 1.0};
    for (const std::uint32_t triangle : chart.triangles) {
        for (std::size_t c = 0; c < 3; ++c) {
            for (int axis = 0; axis < 2; ++axis) {
                const double value = flat[3 * std::size_t{triangle} + c][axis];
                chart.lower[axis] = std::min(chart.lower[axis], value);
                chart.upper[axis] = std::max(chart.upper[axis], value);
            }
        }
    }
    return chart;
}

} // namespace vkbake
