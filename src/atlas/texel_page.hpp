// One page, texel by texel: which are taken, and where a shape finds room.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "atlas/chart_shape.hpp"
#include "atlas/pack.hpp"

namespace vkbake {

/// Texels within the gutter of a shape count as taken. Rows are bits, and places are tried 64 at a time: a run of a
/// shape is in the way of all those from which it meets a taken texel.
class TexelPage {
public:
    struct Place {
        int x = 0;
        int y = 0;
    };

    /// `hasty`: large shapes are not tried at every row.
    TexelPage(const PageSettings& settings, bool hasty);

    /// The highest place, of those the leftmost, from row `begin` on, the shape's lower end not beyond row `end`.
    [[nodiscard]] std::optional<Place> find(const ChartShape& shape, int begin, int end);

    void take(const ChartShape& shape, const Place& place);

private:
    /// A run of a shape, in the order in which they are tried.
    struct Bar {
        int row;
        int begin;
        int length;
    };

    void add_rows(int count);
    [[nodiscard]] Place pushed_up(Place place, int begin, std::vector<Bar>& bars) const;
    [[nodiscard]] std::optional<int> leftmost(int y, int places, std::vector<Bar>& bars) const;
    [[nodiscard]] std::uint64_t barred(const Bar& bar, int y, std::size_t word) const;
    [[nodiscard]] bool fits_at(int x, int y, std::vector<Bar>& bars) const;
    void set(int y, int begin, int end);
    [[nodiscard]] int longest_free(int y) const;

    static std::vector<Bar> bars_of(const ChartShape& shape, int widest);

    [[nodiscard]] std::uint64_t* row(int y) { return &m_bits[static_cast<std::size_t>(y) * m_words]; }
    [[nodiscard]] const std::uint64_t* row(int y) const { return &m_bits[static_cast<std::size_t>(y) * m_words]; }

    bool m_hasty;
    int m_width;
    int m_height;
    int m_gutter;
    std::size_t m_words; ///< a row, with what may be read beyond its end
    int m_used = 0;      ///< rows up to the last that is taken
    std::vector<std::uint64_t> m_bits;
    std::vector<int> m_longest; ///< by row: its longest run of free texels
};

} // namespace vkbake
