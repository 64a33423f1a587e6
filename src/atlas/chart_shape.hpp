// Which texels a chart touches.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "atlas/chart.hpp"

namespace vkbake {

/// A set of texels, row by row.
struct ChartShape {
    struct Run {
        int begin = 0;
        int end = 0; ///< half open, > begin
    };
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> first; ///< 1 a row, and the end: where its runs start
    std::vector<Run> runs;            ///< ascending and apart within a row

    [[nodiscard]] std::span<const Run> row(int y) const {
        const auto at = static_cast<std::size_t>(y);
        return std::span(runs).subspan(first[at], first[at + 1] - first[at]);
    }
    [[nodiscard]] double texel_count() const;
};

/// Every texel whose closed square a triangle of the chart meets, and some that one would meet that is moved by 1/128
/// texel.
[[nodiscard]] ChartShape shape_of(const Chart& chart, std::span<const glm::vec2> flat, const ChartLayout& layout);

/// Turned by 90° as place_chart turns: what was at (x, y) is at (y, width − 1 − x).
[[nodiscard]] ChartShape turned(const ChartShape& shape);

/// A full rectangle.
[[nodiscard]] ChartShape rectangle(const TexelSize& size);

} // namespace vkbake
