// Cuts a surface into charts by planar projection.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "atlas/chart.hpp"
#include "vkbake/surface.hpp"

namespace vkbake {

/// Polypacks (Plemenos et al. in the thesis, §2.5.1): triangles that hang together by edges (corners of equal
/// bake-frame position are one) and face the same half-axis form a chart, projected along that axis. Seen from the
/// front, u runs to the right and v down: nothing is mirrored. Up in the image is +Y, −Z for what faces +Y, +Z for what
/// faces −Y. Where a projection would overlap itself the chart is cut: it grows triangle by triangle, breadth first
/// from the least in canonical order, and leaves out what overlaps it. Exact, in flat coordinates. The half-axis is
/// that of the geometric normal's greatest component; components within 10⁻⁴ of it count as equal, and then Y goes
/// before X before Z, so that a surface at 45° does not crumble by rounding. A triangle without area is folded onto one
/// corner of a neighbour, and belongs to its chart. `triangles`: those of one object, in canonical order. Writes `flat`
/// for them. Charts come in the order of their first triangles.
[[nodiscard]] std::vector<Chart> make_polypacks(const Surface& surface, std::span<const std::uint32_t> triangles,
                                                std::span<glm::vec2> flat);

} // namespace vkbake
