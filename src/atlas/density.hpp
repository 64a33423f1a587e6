// How many texels a unit of surface gets.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "atlas/chart.hpp"
#include "atlas/pack.hpp"

namespace vkbake {

constexpr int greatest_side = 16384; ///< texels a page may have along a side

/// Charts that have found their places.
struct Packing {
    double density = 0.0; ///< texels a bake-frame unit
    std::vector<Placement> placements;
    std::uint32_t page_count = 0;
};

/// The texels that a chart occupies, before turning. Its box lies in the middle of them, at least ¼ texel away from the
/// outermost lines, so that every texel square that it touches, rounding included, is one of them. A box that is at
/// most half a texel long has one texel, and its middle on the texel's centre.
[[nodiscard]] TexelSize texels_of(const Chart& chart, double density);

/// Nothing where the pages do not hold the charts.
[[nodiscard]] std::optional<Packing> pack_at(std::span<const Chart> charts, double density,
                                             const PageSettings& settings);

/// The greatest density (to 1 in 4096, and as far as the packer's answer grows with the density) at which the charts
/// fit as few pages as they fit at all, which is one unless there are more charts than a page has room for. Nothing
/// where even a texel for each chart is too much. `charts` is not empty.
[[nodiscard]] std::optional<Packing> pack_densest(std::span<const Chart> charts, const PageSettings& settings);

/// The least side above settings.side that holds the charts, of those tried: at this density, or at any if it is
/// absent. Nothing where none up to greatest_side does. What is returned does fit.
[[nodiscard]] std::optional<int> side_that_fits(std::span<const Chart> charts, std::optional<double> density,
                                                const PageSettings& settings);

} // namespace vkbake
