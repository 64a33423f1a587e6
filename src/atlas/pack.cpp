#include "atlas/pack.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace vkbake {

namespace {

/// The rectangles that are not yet placed. Equal ones (turned or not) are one kind: an atlas of many charts has few
/// sizes.
class Stock {
public:
    struct Choice {
        std::uint32_t rectangle = 0;
        int width = 0; ///< as it will lie
        int height = 0;
        bool turned = false;
    };

    /// Sizes are taken with the gutter added to each side's length. None is wider or higher than `side`.
    Stock(std::span<const TexelSize> rectangles, int side, int gutter)
        : m_by_width(static_cast<std::size_t>(side) + 1) {
        while (m_leaves < m_by_width.size()) {
            m_leaves *= 2;
        }
        m_least_height.assign(2 * m_leaves, nothing);
        std::map<std::pair<int, int>, std::uint32_t> kinds;
        m_left = rectangles.size();
        for (std::uint32_t i = 0; i < rectangles.size(); ++i) {
            const int width = rectangles[i].width + gutter;
            const int height = rectangles[i].height + gutter;
            const std::pair size(std::max(width, height), std::min(width, height));
            const auto [at, is_new] = kinds.try_emplace(size, static_cast<std::uint32_t>(m_kinds.size()));
            if (is_new) {
                m_kinds.emplace_back();
                m_by_width[static_cast<std::size_t>(size.first)].emplace(size.second, at->second);
                m_by_width[static_cast<std::size_t>(size.second)].emplace(size.first, at->second);
            }
            m_kinds[at->second].members.emplace_back(i, width);
        }
        for (std::size_t width = 0; width < m_by_width.size(); ++width) {
            if (!m_by_width[width].empty()) {
                update(width);
            }
        }
    }

    [[nodiscard]] bool empty() const { return m_left == 0; }

    /// Takes out the widest that is at most this wide and high, of those the highest.
    std::optional<Choice> take(int width, int height) {
        const std::size_t widest = find_widest(static_cast<std::size_t>(width), height);
        if (widest == 0) {
            return std::nullopt;
        }
        const auto& heights = m_by_width[widest];
        const auto [chosen_height, kind] = *std::prev(heights.upper_bound({height, nothing_kind}));
        const auto [rectangle, own_width] = m_kinds[kind].members[m_kinds[kind].next++];
        --m_left;
        const int chosen_width = static_cast<int>(widest);
        if (m_kinds[kind].next == m_kinds[kind].members.size()) {
            remove(chosen_width, chosen_height, kind);
            remove(chosen_height, chosen_width, kind);
        }
        return Choice{rectangle, chosen_width, chosen_height, own_width != chosen_width};
    }

private:
    static constexpr int nothing = std::numeric_limits<int>::max();
    static constexpr std::uint32_t nothing_kind = std::numeric_limits<std::uint32_t>::max();

    struct Kind {
        std::vector<std::pair<std::uint32_t, int>> members; ///< rectangle and its width before turning
        std::size_t next = 0;
    };

    void remove(int width, int height, std::uint32_t kind) {
        m_by_width[static_cast<std::size_t>(width)].erase({height, kind});
        update(static_cast<std::size_t>(width));
    }

    void update(std::size_t width) {
        const auto& heights = m_by_width[width];
        std::size_t node = m_leaves + width;
        m_least_height[node] = heights.empty() ? nothing : heights.begin()->first;
        for (node /= 2; node > 0; node /= 2) {
            m_least_height[node] = std::min(m_least_height[2 * node], m_least_height[2 * node + 1]);
        }
    }

    /// The greatest width ≤ `width` for which something at most `height` high is left, or 0.
    [[nodiscard]] std::size_t find_widest(std::size_t width, int height) const {
        std::size_t node = m_leaves + std::min(width, m_by_width.size() - 1);
        // Up, until a subtree at or to the left of the leaf holds something low enough; then down, on the right where
        // possible.
        while (m_least_height[node] > height) {
            while (node % 2 == 0) {
                node /= 2;
            }
            if (node == 1) {
                return 0;
            }
            --node;
        }
        while (node < m_leaves) {
            node = 2 * node + (m_least_height[2 * node + 1] <= height ? 1 : 0);
        }
        return node - m_leaves;
    }

    std::vector<Kind> m_kinds;
    std::vector<std::set<std::pair<int, std::uint32_t>>> m_by_width; ///< by width: height and kind
    std::size_t m_leaves = 1;
    std::vector<int> m_least_height; ///< a binary heap of minima over m_by_width
    std::size_t m_left = 0;
};

/// The upper outline of what lies in a page: a row of steps from left to right, neighbours of unlike height.
class Skyline {
public:
    struct Gap {
        int x = 0;
        int y = 0;
        int width = 0;
        bool taller_on_right = false; ///< the neighbour on the right reaches higher than the one on the left
    };

    explicit Skyline(int side) : m_side(side) { add(0, 0, side); }

    /// The lowest step, of those the leftmost.
    [[nodiscard]] Gap lowest() const {
        const auto [y, x] = *m_lowest.begin();
        const auto at = m_steps.find(x);
        return {x, y, at->second.width, right_of(at) > left_of(at)};
    }

    /// Raises [x, x + width) of the lowest step to `y`.
    void raise(const Gap& gap, int x, int width, int y) {
        m_steps.erase(gap.x);
        m_lowest.erase({gap.y, gap.x});
        if (x > gap.x) {
            add(gap.x, gap.y, x - gap.x);
        }
        if (x + width < gap.x + gap.width) {
            add(x + width, gap.y, gap.x + gap.width - x - width);
        }
        add(x, y, width);
    }

    /// Fills the lowest step up to its lower neighbour. False where it has none: it is the whole row.
    bool fill(const Gap& gap) {
        const auto at = m_steps.find(gap.x);
        const int y = std::min(left_of(at), right_of(at));
        if (y == wall) {
            return false;
        }
        raise(gap, gap.x, gap.width, y);
        return true;
    }

private:
    struct Step {
        int y = 0;
        int width = 0;
    };
    using Steps = std::map<int, Step>;
    static constexpr int wall = std::numeric_limits<int>::max();

    [[nodiscard]] int left_of(Steps::const_iterator at) const {
        return at == m_steps.begin() ? wall : std::prev(at)->second.y;
    }
    [[nodiscard]] int right_of(Steps::const_iterator at) const {
        return at->first + at->second.width == m_side ? wall : std::next(at)->second.y;
    }

    /// Joins what it meets at the same height.
    void add(int x, int y, int width) {
        const auto after = m_steps.lower_bound(x);
        if (after != m_steps.end() && after->second.y == y && after->first == x + width) {
            width += after->second.width;
            erase(after);
        }
        const auto behind = m_steps.lower_bound(x);
        if (behind != m_steps.begin()) {
            const auto before = std::prev(behind);
            if (before->second.y == y && before->first + before->second.width == x) {
                x = before->first;
                width += before->second.width;
                erase(before);
            }
        }
        m_steps.emplace(x, Step{y, width});
        m_lowest.emplace(y, x);
    }

    void erase(Steps::const_iterator at) {
        m_lowest.erase({at->second.y, at->first});
        m_steps.erase(at);
    }

    int m_side;
    Steps m_steps;                          ///< by x
    std::set<std::pair<int, int>> m_lowest; ///< y and x of each
};

/// Fills one page. Returns how many it took.
std::size_t fill_page(Stock& stock, int side, std::uint32_t page, std::vector<Placement>& placements) {
    Skyline skyline(side);
    std::size_t taken = 0;
    while (!stock.empty()) {
        const Skyline::Gap gap = skyline.lowest();
        if (const auto choice = stock.take(gap.width, side - gap.y)) {
            const int x = gap.taller_on_right ? gap.x + gap.width - choice->width : gap.x;
            placements[choice->rectangle] = {page, x, gap.y, choice->turned};
            skyline.raise(gap, x, choice->width, gap.y + choice->height);
            ++taken;
        } else if (!skyline.fill(gap)) {
            break;
        }
    }
    return taken;
}

} // namespace

std::optional<std::vector<Placement>> pack(std::span<const TexelSize> rectangles, const PageSettings& settings) {
    // A gutter beyond the right and lower border lets each rectangle carry its own on two sides.
    const int side = settings.side + settings.gutter;
    const double page_area = static_cast<double>(side) * side;
    double area = 0.0;
    for (const TexelSize& rectangle : rectangles) {
        if (std::max(rectangle.width, rectangle.height) > settings.side) {
            return std::nullopt;
        }
        area += static_cast<double>(rectangle.width + settings.gutter) * (rectangle.height + settings.gutter);
    }
    if (area > page_area * settings.max_pages) {
        return std::nullopt;
    }
    std::vector<Placement> placements(rectangles.size());
    Stock stock(rectangles, side, settings.gutter);
    for (int page = 0; !stock.empty(); ++page) {
        if (page == settings.max_pages || fill_page(stock, side, static_cast<std::uint32_t>(page), placements) == 0) {
            return std::nullopt;
        }
    }
    return placements;
}

} // namespace vkbake
