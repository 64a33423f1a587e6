#include "atlas/pack.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace vkbake {

namespace {

struct Place {
    int x = 0;
    int y = 0;
};

/// One page: which texels are taken, those within the gutter of a shape included.
class Page {
public:
    /// `hasty`: large shapes are not tried at every row.
    Page(const PageSettings& settings, bool hasty)
        : m_hasty(hasty), m_width(settings.width), m_height(settings.height), m_gutter(settings.gutter),
          m_words((static_cast<std::size_t>(settings.width) + 63) / 64) {}

    /// The highest place, of those the leftmost, from row `begin` on, its box's lower end not beyond row `end`.
    [[nodiscard]] std::optional<Place> find(const ChartShape& shape, int begin, int end) {
        if (shape.width > m_width) {
            return std::nullopt;
        }
        // Below the last row that is taken it fits, so no row further down is asked for.
        add_rows(std::min(m_height, std::max(begin, m_used) + shape.height + shape.height / 8 + 1));
        const int widest = widest_row(shape);
        const int needed = longest_run(shape, widest);
        std::vector<int> order = order_of_rows(shape, widest);
        const int last = std::min(end, m_height) - shape.height;
        // It is pushed up in the end, so that only holes that fit it closely are not found.
        const int stride = m_hasty ? std::max(1, shape.height / 8) : 1;
        for (int y = begin; y <= last; y = y < last ? std::min(y + stride, last) : last + 1) {
            if (m_longest[static_cast<std::size_t>(y) + static_cast<std::size_t>(widest)] < needed) {
                continue;
            }
            for (int x = 0; x + shape.width <= m_width;) {
                const int next = next_try(shape, x, y, order);
                if (next == x) {
                    return pushed_up(shape, {x, y}, begin, order);
                }
                x = next;
            }
        }
        return std::nullopt;
    }

    void take(const ChartShape& shape, const Place& place) {
        const int end = std::min(m_height, place.y + shape.height + m_gutter);
        add_rows(end);
        m_used = std::max(m_used, end);
        for (int y = std::max(0, place.y - m_gutter); y < end; ++y) {
            const int from = std::max(0, y - place.y - m_gutter);
            const int to = std::min(shape.height, y - place.y + m_gutter + 1);
            for (int row = from; row < to; ++row) {
                for (const ChartShape::Run& run : shape.row(row)) {
                    set(y, std::max(0, place.x + run.begin - m_gutter),
                        std::min(m_width, place.x + run.end + m_gutter));
                }
            }
            m_longest[static_cast<std::size_t>(y)] = longest_free(y);
        }
    }

private:
    void add_rows(int count) {
        if (static_cast<std::size_t>(count) > m_longest.size()) {
            m_longest.resize(static_cast<std::size_t>(count), m_width);
            m_bits.resize(m_words * static_cast<std::size_t>(count), 0);
        }
    }

    static int longest_run(const ChartShape& shape, int y) {
        int longest = 0;
        for (const ChartShape::Run& run : shape.row(y)) {
            longest = std::max(longest, run.end - run.begin);
        }
        return longest;
    }

    static int widest_row(const ChartShape& shape) {
        int widest = 0;
        for (int y = 1; y < shape.height; ++y) {
            widest = longest_run(shape, y) > longest_run(shape, widest) ? y : widest;
        }
        return widest;
    }

    Place pushed_up(const ChartShape& shape, Place place, int begin, std::vector<int>& order) const {
        while (place.y > begin && next_try(shape, place.x, place.y - 1, order) == place.x) {
            --place.y;
        }
        while (place.x > 0 && next_try(shape, place.x - 1, place.y, order) == place.x - 1) {
            --place.x;
        }
        return place;
    }

    /// Rows in the order in which they are tried: neighbours refuse alike, so first some that are far apart.
    static std::vector<int> order_of_rows(const ChartShape& shape, int widest) {
        std::vector<int> order;
        for (int stride = 16; stride >= 1; stride /= 2) {
            for (int row = stride == 16 ? 0 : stride; row < shape.height; row += stride == 16 ? 16 : 2 * stride) {
                order.push_back(row);
            }
        }
        std::swap(order.front(), *std::ranges::find(order, widest));
        return order;
    }

    /// `x` itself where the shape fits there, else the least x that may do: beyond what is in the way.
    [[nodiscard]] int next_try(const ChartShape& shape, int x, int y, std::vector<int>& order) const {
        for (std::size_t k = 0; k < order.size(); ++k) {
            const int row = order[k];
            for (const ChartShape::Run& run : shape.row(row)) {
                const int last = last_taken(y + row, x + run.begin, x + run.end);
                if (last >= 0) {
                    std::swap(order[k], order[std::min<std::size_t>(k, 1)]); // likely to refuse again
                    return last + 1 - run.begin;
                }
            }
        }
        return x;
    }

    /// The last taken texel in [begin, end) of a row, or −1.
    [[nodiscard]] int last_taken(int y, int begin, int end) const {
        const std::uint64_t* const row = &m_bits[static_cast<std::size_t>(y) * m_words];
        const auto first = static_cast<std::size_t>(begin);
        const auto last = static_cast<std::size_t>(end - 1);
        std::uint64_t mask = ~std::uint64_t{0} >> (63 - last % 64);
        for (std::size_t word = last / 64;; --word) {
            std::uint64_t bits = row[word] & mask;
            bits &= word == first / 64 ? ~std::uint64_t{0} << (first % 64) : ~std::uint64_t{0};
            if (bits != 0) {
                return static_cast<int>(word * 64 + 63) - std::countl_zero(bits);
            }
            if (word == first / 64) {
                return -1;
            }
            mask = ~std::uint64_t{0};
        }
    }

    void set(int y, int begin, int end) {
        std::uint64_t* const row = &m_bits[static_cast<std::size_t>(y) * m_words];
        for (auto x = static_cast<std::size_t>(begin); x < static_cast<std::size_t>(end);) {
            const std::size_t in_word = std::min<std::size_t>(64 - x % 64, static_cast<std::size_t>(end) - x);
            row[x / 64] |= (~std::uint64_t{0} >> (64 - in_word)) << (x % 64);
            x += in_word;
        }
    }

    [[nodiscard]] int longest_free(int y) const {
        const std::uint64_t* const row = &m_bits[static_cast<std::size_t>(y) * m_words];
        int longest = 0;
        int begin = 0;
        for (std::size_t word = 0; word < m_words; ++word) {
            std::uint64_t bits = row[word];
            while (bits != 0) {
                const int at = static_cast<int>(word * 64) + std::countr_zero(bits);
                longest = std::max(longest, at - begin);
                // Skip the taken run within this word.
                const int ones = std::countr_one(bits >> (static_cast<unsigned>(at) % 64));
                begin = at + ones;
                bits = static_cast<unsigned>(begin) % 64 == 0
                           ? 0
                           : bits & (~std::uint64_t{0} << (static_cast<unsigned>(begin) % 64));
            }
        }
        return std::max(longest, m_width - begin);
    }

    bool m_hasty;
    int m_width;
    int m_height;
    int m_gutter;
    std::size_t m_words;
    int m_used = 0; ///< rows up to the last that is taken
    std::vector<std::uint64_t> m_bits;
    std::vector<int> m_longest; ///< by row: its longest run of free texels
};

class Packer {
public:
    Packer(const PageSettings& settings, bool hasty) : m_settings(settings), m_hasty(hasty) {}

    [[nodiscard]] std::optional<Placement> place(const ChartShape& shape) {
        const std::vector<ChartShape> ways = turns_of(shape);
        for (std::uint32_t page = 0;; ++page) {
            if (page == m_pages.size()) {
                if (static_cast<int>(page) == m_settings.max_pages) {
                    return std::nullopt;
                }
                m_pages.emplace_back(m_settings, m_hasty);
                m_begins.emplace_back();
            }
            std::optional<Placement> best;
            int end = m_settings.height; // only a place that brings its lower end higher is better
            for (std::size_t turns = 0; turns < ways.size(); ++turns) {
                if (const auto place = find(page, ways[turns], turns >= 2, end)) {
                    best = Placement{page, place->x, place->y, static_cast<int>(turns)};
                    end = place->y + ways[turns].height - 1;
                }
            }
            if (best) {
                m_pages[page].take(ways[static_cast<std::size_t>(best->turns)], {best->x, best->y});
                return best;
            }
        }
    }

private:
    /// Width and height, four steps an octave; how much of the box is filled, in quarters; whether upside down.
    using Kind = std::tuple<int, int, int, bool>;

    static int step_of(int length) {
        const auto octave = static_cast<int>(std::bit_width(static_cast<unsigned>(length)));
        return octave <= 3 ? length : 4 * octave + (length >> (octave - 3)) % 4;
    }

    static std::vector<ChartShape> turns_of(const ChartShape& shape) {
        constexpr double large = 1024.0; // texels: smaller ones find room either way
        const double texels = shape.texel_count();
        std::vector<ChartShape> ways{shape};
        if (shape.width != shape.height || texels < static_cast<double>(shape.width) * shape.height) {
            ways.push_back(turned(shape));
            if (texels >= large && texels < static_cast<double>(shape.width) * shape.height) {
                ways.push_back(turned(ways[1]));
                ways.push_back(turned(ways[2]));
            }
        }
        return ways;
    }

    std::optional<Place> find(std::uint32_t page, const ChartShape& shape, bool upside_down, int end) {
        const double filled = shape.texel_count() / (static_cast<double>(shape.width) * shape.height);
        int& begin =
            m_begins[page][{step_of(shape.width), step_of(shape.height), static_cast<int>(4.0 * filled), upside_down}];
        const auto place = m_pages[page].find(shape, begin, end);
        begin = place ? place->y : std::max(begin, end - shape.height + 1);
        return place;
    }

    PageSettings m_settings;
    bool m_hasty;
    std::vector<Page> m_pages;
    std::vector<std::map<Kind, int>> m_begins; ///< by page: the row from which a kind is looked for
};

} // namespace

std::optional<std::vector<Placement>> pack(std::span<const ChartShape> shapes, const PageSettings& settings) {
    double texels = 0.0;
    std::vector<double> counts;
    for (const ChartShape& shape : shapes) {
        if (std::max(shape.width, shape.height) > std::max(settings.width, settings.height) ||
            std::min(shape.width, shape.height) > std::min(settings.width, settings.height)) {
            return std::nullopt;
        }
        counts.push_back(shape.texel_count());
        texels += counts.back();
    }
    if (texels > static_cast<double>(settings.width) * settings.height * settings.max_pages) {
        return std::nullopt;
    }
    std::vector<std::size_t> order(shapes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return counts[a] > counts[b]; });
    std::vector<Placement> placements(shapes.size());
    constexpr std::size_t few = 64; // charts: their places decide how full the page is, and are soon found
    Packer packer(settings, shapes.size() > few);
    for (const std::size_t index : order) {
        const auto placement = packer.place(shapes[index]);
        if (!placement) {
            return std::nullopt;
        }
        placements[index] = *placement;
    }
    return placements;
}

} // namespace vkbake
