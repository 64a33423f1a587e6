#include "atlas/texel_page.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace vkbake {

namespace {

constexpr int word_bits = 64;
constexpr int longest_bar = 64; // of a place and the 63 beside it two words say all that such a bar meets

int longest_run(const ChartShape& shape, int y) {
    int longest = 0;
    for (const ChartShape::Run& run : shape.row(y)) {
        longest = std::max(longest, run.end - run.begin);
    }
    return longest;
}

int widest_row(const ChartShape& shape) {
    int widest = 0;
    int longest = longest_run(shape, 0);
    for (int y = 1; y < shape.height; ++y) {
        const int own = longest_run(shape, y);
        widest = own > longest ? y : widest;
        longest = std::max(longest, own);
    }
    return widest;
}

/// For each bit of `low` whether it or one of the `length` − 1 bits above it, on into `high`, is set.
std::uint64_t any_ahead(std::uint64_t low, std::uint64_t high, int length) {
    int covered = 1;
    const auto widen = [&](int by) {
        low |= low >> by | high << (word_bits - by);
        high |= high >> by;
        covered += by;
    };
    while (2 * covered <= length) {
        widen(covered);
    }
    if (covered < length) {
        widen(length - covered);
    }
    return low;
}

} // namespace

TexelPage::TexelPage(const PageSettings& settings, bool hasty)
    : m_hasty(hasty), m_width(settings.width), m_height(settings.height), m_gutter(settings.gutter),
      m_words((static_cast<std::size_t>(settings.width) + word_bits - 1) / word_bits + 2) {}

std::optional<TexelPage::Place> TexelPage::find(const ChartShape& shape, int begin, int end) {
    if (shape.width > m_width) {
        return std::nullopt;
    }
    // Below the last row that is taken it fits, so no row further down is asked for.
    add_rows(std::min(m_height, std::max(begin, m_used) + shape.height + shape.height / 8 + 1));
    const int widest = widest_row(shape);
    const int needed = longest_run(shape, widest);
    std::vector<Bar> bars = bars_of(shape, widest);
    const int places = m_width - shape.width + 1;
    const int last = std::min(end, m_height) - shape.height;
    // It is pushed up in the end, so that only holes that fit it closely are not found.
    const int stride = m_hasty ? std::max(1, shape.height / 8) : 1;
    for (int y = begin; y <= last; y = y < last ? std::min(y + stride, last) : last + 1) {
        if (m_longest[static_cast<std::size_t>(y) + static_cast<std::size_t>(widest)] < needed) {
            continue;
        }
        if (const auto x = leftmost(y, places, bars)) {
            return pushed_up({*x, y}, begin, bars);
        }
    }
    return std::nullopt;
}

void TexelPage::take(const ChartShape& shape, const Place& place) {
    const int end = std::min(m_height, place.y + shape.height + m_gutter);
    add_rows(end);
    m_used = std::max(m_used, end);
    for (int y = std::max(0, place.y - m_gutter); y < end; ++y) {
        const int from = std::max(0, y - place.y - m_gutter);
        const int to = std::min(shape.height, y - place.y + m_gutter + 1);
        for (int own = from; own < to; ++own) {
            for (const ChartShape::Run& run : shape.row(own)) {
                set(y, std::max(0, place.x + run.begin - m_gutter), std::min(m_width, place.x + run.end + m_gutter));
            }
        }
        m_longest[static_cast<std::size_t>(y)] = longest_free(y);
    }
}

void TexelPage::add_rows(int count) {
    if (static_cast<std::size_t>(count) > m_longest.size()) {
        m_longest.resize(static_cast<std::size_t>(count), m_width);
        m_bits.resize(m_words * static_cast<std::size_t>(count), 0);
    }
}

TexelPage::Place TexelPage::pushed_up(Place place, int begin, std::vector<Bar>& bars) const {
    while (place.y > begin && fits_at(place.x, place.y - 1, bars)) {
        --place.y;
    }
    while (place.x > 0 && fits_at(place.x - 1, place.y, bars)) {
        --place.x;
    }
    return place;
}

/// Neighbouring rows refuse alike, so first some that are far apart.
std::vector<TexelPage::Bar> TexelPage::bars_of(const ChartShape& shape, int widest) {
    std::vector<int> order;
    for (int stride = 16; stride >= 1; stride /= 2) {
        for (int row = stride == 16 ? 0 : stride; row < shape.height; row += stride == 16 ? 16 : 2 * stride) {
            order.push_back(row);
        }
    }
    std::swap(order.front(), *std::ranges::find(order, widest));
    std::vector<Bar> bars;
    bars.reserve(shape.runs.size());
    for (const int row : order) {
        for (const ChartShape::Run& run : shape.row(row)) {
            for (int begin = run.begin; begin < run.end; begin += longest_bar) {
                bars.push_back({row, begin, std::min(longest_bar, run.end - begin)});
            }
        }
    }
    return bars;
}

/// The least x below `places` at which the shape fits in rows from y on.
std::optional<int> TexelPage::leftmost(int y, int places, std::vector<Bar>& bars) const {
    for (int x = 0; x < places; x += word_bits) {
        const int own = std::min(word_bits, places - x);
        std::uint64_t refused = own == word_bits ? 0 : ~std::uint64_t{0} << own;
        for (std::size_t k = 0; k < bars.size() && ~refused != 0; ++k) {
            refused |= barred(bars[k], y, static_cast<std::size_t>(x) / word_bits);
            if (~refused == 0) {
                std::swap(bars[k], bars[k / 2]); // likely to refuse again
            }
        }
        if (~refused != 0) {
            return x + std::countr_one(refused);
        }
    }
    return std::nullopt;
}

/// Of the 64 places that begin with the word's, those from which the bar meets a taken texel.
std::uint64_t TexelPage::barred(const Bar& bar, int y, std::size_t word) const {
    const auto ahead = static_cast<std::size_t>(bar.begin);
    const std::uint64_t* const bits = row(y + bar.row) + word + ahead / word_bits;
    const unsigned shift = ahead % word_bits;
    // Twice, as a shift by 64 is none.
    const std::uint64_t low = bits[0] >> shift | bits[1] << 1 << (word_bits - 1 - shift);
    const std::uint64_t high = bits[1] >> shift | bits[2] << 1 << (word_bits - 1 - shift);
    return any_ahead(low, high, bar.length);
}

bool TexelPage::fits_at(int x, int y, std::vector<Bar>& bars) const {
    const auto at = static_cast<unsigned>(x % word_bits);
    for (std::size_t k = 0; k < bars.size(); ++k) {
        if ((barred(bars[k], y, static_cast<std::size_t>(x) / word_bits) >> at & 1U) != 0) {
            std::swap(bars[k], bars[k / 2]);
            return false;
        }
    }
    return true;
}

void TexelPage::set(int y, int begin, int end) {
    std::uint64_t* const bits = row(y);
    for (auto x = static_cast<std::size_t>(begin); x < static_cast<std::size_t>(end);) {
        const std::size_t in_word = std::min<std::size_t>(word_bits - x % word_bits, static_cast<std::size_t>(end) - x);
        bits[x / word_bits] |= (~std::uint64_t{0} >> (word_bits - in_word)) << (x % word_bits);
        x += in_word;
    }
}

int TexelPage::longest_free(int y) const {
    const std::uint64_t* const words = row(y);
    int longest = 0;
    int begin = 0;
    for (std::size_t word = 0; word < m_words; ++word) {
        std::uint64_t bits = words[word];
        while (bits != 0) {
            const int at = static_cast<int>(word * word_bits) + std::countr_zero(bits);
            longest = std::max(longest, at - begin);
            // Skip the taken run within this word.
            const int ones = std::countr_one(bits >> (static_cast<unsigned>(at) % word_bits));
            begin = at + ones;
            bits = static_cast<unsigned>(begin) % word_bits == 0
                       ? 0
                       : bits & (~std::uint64_t{0} << (static_cast<unsigned>(begin) % word_bits));
        }
    }
    return std::max(longest, m_width - begin);
}

} // namespace vkbake
