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
    int width = 0;        ///< of the pages, texels
    int height = 0;
    std::vector<ChartLayout> layouts;
    std::vector<Placement> placements;
    std::uint32_t page_count = 0;
};

/// Finds densities for charts, or pages. `flat` must outlive it, and so must `charts`, which are not empty.
class ChartPacker {
public:
    ChartPacker(std::span<const Chart> charts, std::span<const glm::vec2> flat);

    /// On pages of this size. Nothing where they do not hold the charts.
    [[nodiscard]] std::optional<Packing> on_pages(double density, const PageSettings& settings) const;

    /// About the greatest density at which the charts fit as few pages as they fit at all, which is one unless there
    /// are more charts than a page has room for. It is looked for until what fits and what does not are close: within
    /// 0.03 %, of more than 16 charts 0.6 %, of more than 1024 1.2 %. Nothing where even a texel for each chart is too
    /// much.
    [[nodiscard]] std::optional<Packing> densest(const PageSettings& settings) const;

    /// On one page that is about square and just high enough. Nothing where it would have more than greatest_side
    /// texels along a side.
    [[nodiscard]] std::optional<Packing> least_page(double density, int gutter) const;

    /// A side of square pages above settings.width that holds the charts, of those tried about the least: at this
    /// density, or at any if it is absent. Nothing where none up to greatest_side does.
    [[nodiscard]] std::optional<int> side_that_fits(std::optional<double> density, const PageSettings& settings) const;

private:
    /// Packed as high as it comes, up to settings.height.
    [[nodiscard]] std::optional<Packing> at(double density, const PageSettings& settings) const;

    /// On one page about so wide, at least `least`, and as high as is needed: few charts are tried on several widths.
    [[nodiscard]] std::optional<Packing> least_of_widths(double density, int width, int least, int gutter) const;

    [[nodiscard]] double foretold_area(double density, int gutter) const;

    /// The density in between at which that area is foretold.
    [[nodiscard]] double density_for(double area, int gutter, double low, double high) const;

    std::span<const Chart> m_charts;
    std::span<const glm::vec2> m_flat;
    double m_longest = 0.0;   ///< side of any chart's box, bake-frame units
    double m_area = 0.0;      ///< of all charts, in bake-frame units
    double m_perimeter = 0.0; ///< of their boxes
};

} // namespace vkbake
