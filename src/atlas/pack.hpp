// Rectangles into square pages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace vkbake {

struct TexelSize {
    int width = 0;  ///< texels, ≥ 1
    int height = 0; ///< texels, ≥ 1
};

struct Placement {
    std::uint32_t page = 0;
    int x = 0; ///< the left column and the upper row of the rectangle as it lies in the page
    int y = 0;
    bool turned = false; ///< by 90°: width and height have changed places
};

struct PageSettings {
    int side = 0;   ///< texels
    int gutter = 0; ///< texels that stay empty between any two rectangles; none at the page's border
    int max_pages = 1;
};

/// A place for each rectangle, or nothing where the pages do not hold them. A page is opened when no rectangle that is
/// left fits the one before. Depends on the sizes and their order alone; equal sizes are placed in the order given. The
/// best-fit heuristic of Burke, Kendall and Whitwell, "A new placement heuristic for the orthogonal stock-cutting
/// problem" (2004): the lowest gap takes the widest rectangle that fits it, beside its taller neighbour. O(n log n).
[[nodiscard]] std::optional<std::vector<Placement>> pack(std::span<const TexelSize> rectangles,
                                                         const PageSettings& settings);

} // namespace vkbake
