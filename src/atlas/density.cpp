#include "atlas/density.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vkbake {

namespace {

glm::dvec2 extent_of(const Chart& chart) { return (chart.upper - chart.lower) * chart.scale; }

/// The longest side of any chart's box, in bake-frame units.
double longest_side(std::span<const Chart> charts) {
    double longest = 0.0;
    for (const Chart& chart : charts) {
        const glm::dvec2 extent = extent_of(chart);
        longest = std::max({longest, extent.x, extent.y});
    }
    return longest;
}

/// A density at which every chart has one texel.
double least_density(double longest) { return longest > 0.0 ? 0.5 / longest : 1.0; }

} // namespace

TexelSize texels_of(const Chart& chart, double density) {
    // More than any page has: enough to be refused, and sums of it stay far from overflow.
    constexpr double too_long = 2.0 * greatest_side;
    const auto texels = [&](double extent) {
        return static_cast<int>(std::clamp(std::ceil(extent * density + 0.5), 1.0, too_long));
    };
    const glm::dvec2 extent = extent_of(chart);
    return {texels(extent.x), texels(extent.y)};
}

std::optional<Packing> pack_at(std::span<const Chart> charts, double density, const PageSettings& settings) {
    std::vector<TexelSize> rectangles(charts.size());
    std::transform(charts.begin(), charts.end(), rectangles.begin(),
                   [density](const Chart& chart) { return texels_of(chart, density); });
    auto placements = pack(rectangles, settings);
    if (!placements) {
        return std::nullopt;
    }
    Packing packing{density, std::move(*placements), 0};
    for (const Placement& placement : packing.placements) {
        packing.page_count = std::max(packing.page_count, placement.page + 1);
    }
    return packing;
}

std::optional<Packing> pack_densest(std::span<const Chart> charts, const PageSettings& settings) {
    const double longest = longest_side(charts);
    double low = least_density(longest);
    auto best = pack_at(charts, low, settings);
    if (!best || !(longest > 0.0)) {
        return best;
    }
    PageSettings pages = settings;
    pages.max_pages = static_cast<int>(best->page_count);
    // The longest chart does not fit above this. Halving the interval of the logarithm is deterministic: the root is
    // correctly rounded.
    double high = 2.0 * settings.side / longest;
    while (high > low * (1.0 + 0x1p-12)) {
        const double middle = std::sqrt(low) * std::sqrt(high);
        if (auto packing = pack_at(charts, middle, pages)) {
            best = std::move(packing);
            low = middle;
        } else {
            high = middle;
        }
    }
    return best;
}

std::optional<int> side_that_fits(std::span<const Chart> charts, std::optional<double> density,
                                  const PageSettings& settings) {
    const double tried = density ? *density : least_density(longest_side(charts));
    const auto fits = [&](int side) {
        PageSettings pages = settings;
        pages.side = side;
        return pack_at(charts, tried, pages).has_value();
    };
    int too_small = settings.side;
    int enough = settings.side;
    do {
        if (enough == greatest_side) {
            return std::nullopt;
        }
        too_small = enough;
        enough = std::min(2 * enough, greatest_side);
    } while (!fits(enough));
    while (enough - too_small > 1) {
        const int middle = too_small + (enough - too_small) / 2;
        (fits(middle) ? enough : too_small) = middle;
    }
    return enough;
}

} // namespace vkbake
