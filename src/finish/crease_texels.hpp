// Texels that lie on both sides of a crease inside a chart, and how much of them lies where.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "vkbake/atlas.hpp"
#include "vkbake/geometry_image.hpp"
#include "vkbake/surface.hpp"

namespace vkbake {

/// Light was found for one point of the texel, which lies on one side of the crease. `shares` say from which of the 3 ×
/// 3 texels around it, row by row, its light is to be mixed: each side's share is what of the chart's area in the
/// texel's square lies on it, and is taken from the texel itself or, for the other sides, from the texels beside it
/// whose own points lie there (from those at its corners where none at its sides do). A side that no texel around it
/// has is left out. In parts of `whole`, whole numbers that add up: so even light keeps its bits.
struct CreaseTexel {
    static constexpr std::uint32_t whole = 1U << 15U;

    std::uint32_t texel = 0;
    std::array<std::uint16_t, 9> shares{};
};

/// In row order; those that have a share of another's light. Sides: see shading_sides. `geometry`: of that page. The
/// result does not depend on the order of triangles. Where no two texels of a chart differ in their normals, this is
/// all that is looked at.
[[nodiscard]] std::vector<CreaseTexel> find_crease_texels(const Surface& surface, const Atlas& atlas,
                                                          const GeometryImage& geometry, std::uint32_t page);

} // namespace vkbake
