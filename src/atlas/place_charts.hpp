// Packed charts → UVs.
#pragma once

#include <span>

#include <glm/vec2.hpp>

#include "atlas/chart.hpp"
#include "atlas/pack.hpp"

namespace vkbake {

/// Writes the UVs of one chart: 3 a triangle of the surface. Turned, what ran to the right runs up. They are multiples
/// of 2⁻²³, which floats in [0,1] hold exactly, and corners that are equal in `flat` are equal in `uvs`. A page has
/// `page`: its texels along each side, at most 16384, so a grid step is 1/512 texel or less.
void place_chart(const Chart& chart, const ChartLayout& layout, const Placement& placement, const glm::ivec2& page,
                 std::span<const glm::vec2> flat, std::span<glm::vec2> uvs);

/// Rounding to the grid may turn a sliver over, or push a corner across an edge that it lay on (a T-junction). This
/// takes such overlaps back, exactly: a triangle that turned over is folded to no area; of two that overlap the smaller
/// one is drawn in by a few grid steps, and folded if it is too thin for that. No triangle leaves its place. `flat`:
/// the same triangles before, without overlap.
void repair_rounding(const Chart& chart, std::span<const glm::vec2> flat, std::span<glm::vec2> uvs);

} // namespace vkbake
