// Cuts a surface into few charts that keep its measure.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "atlas/chart.hpp"
#include "vkbake/surface.hpp"

namespace vkbake {

struct GrowthLimits {
    double stretch = 1.01;    ///< L2 stretch of a chart, > 1
    double free_length = 0.0; ///< bake-frame units: up to this size a chart may have any shape
    double free_area = 0.0;   ///< their square: up to this area faces may be joined across a crease
};

/// Charts of the triangles that hang together by edges (corners of equal bake-frame position are one): flat pieces and
/// smooth ones, joined as far as the stretch allows; across a crease only what is small. Exactly no two
/// triangles of a chart overlap in `flat`, none is mirrored (fronts turn clockwise in (u, v), v down), and each
/// chart lies so that most of its outline is parallel to the axes. Triangles without area are folded onto a corner of a
/// neighbour. `triangles`: those of one object, in canonical order. Writes `flat` for them. Charts come in the order of
/// their first triangles. The result does not depend on threads.
[[nodiscard]] std::vector<Chart> make_grown_charts(const Surface& surface, std::span<const std::uint32_t> triangles,
                                                   const GrowthLimits& limits, std::span<glm::vec2> flat);

} // namespace vkbake
