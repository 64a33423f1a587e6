#include "atlas/pack.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <map>
#include <numeric>
#include <tuple>

#include "atlas/texel_page.hpp"

namespace vkbake {

namespace {

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

    std::optional<TexelPage::Place> find(std::uint32_t page, const ChartShape& shape, bool upside_down, int end) {
        const double filled = shape.texel_count() / (static_cast<double>(shape.width) * shape.height);
        int& begin =
            m_begins[page][{step_of(shape.width), step_of(shape.height), static_cast<int>(4.0 * filled), upside_down}];
        const auto place = m_pages[page].find(shape, begin, end);
        begin = place ? place->y : std::max(begin, end - shape.height + 1);
        return place;
    }

    PageSettings m_settings;
    bool m_hasty;
    std::vector<TexelPage> m_pages;
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
