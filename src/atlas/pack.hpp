// Shapes into pages.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "atlas/chart_shape.hpp"

namespace vkbake {

struct Placement {
    std::uint32_t page = 0;
    int x = 0; ///< the left column and the upper row of the shape's box as it lies in the page
    int y = 0;
    int turns = 0; ///< quarter turns, 0 … 3: what ran to the right runs up after the first
};

struct PageSettings {
    int width = 0;  ///< texels
    int height = 0; ///< the most that a page may have; rows that nothing reaches cost nothing
    int gutter = 0; ///< texels that stay empty between any two shapes, along x or along y; none at the page's border
    int max_pages = 1;
};

/// A place for each shape, or nothing where the pages do not hold them. Shapes go by decreasing number of texels, each
/// to the first page that has room, there as high up as it can, then as far to the left, turned if that brings it
/// higher; small ones so fill what large ones leave open between their outlines. A later shape of the same size looks
/// no higher than where the one before was put. Depends on the shapes and their order alone; equal sizes are placed in
/// the order given.
[[nodiscard]] std::optional<std::vector<Placement>> pack(std::span<const ChartShape> shapes,
                                                         const PageSettings& settings);

} // namespace vkbake
