#include "atlas/density.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"

namespace vkbake {

namespace {

constexpr double full = 0.85; // of a page: what an average atlas takes

/// Halves the interval of the logarithm (deterministic: the root is correctly rounded) between what fits and what does
/// not.
double middle_of(double a, double b) { return std::sqrt(a) * std::sqrt(b); }

} // namespace

ChartPacker::ChartPacker(std::span<const Chart> charts, std::span<const glm::vec2> flat)
    : m_charts(charts), m_flat(flat) {
    for (const Chart& chart : charts) {
        const glm::dvec2 extent = (chart.upper - chart.lower) * chart.scale;
        m_longest = std::max({m_longest, extent.x, extent.y});
        m_perimeter += 2.0 * (extent.x + extent.y);
        for (const std::uint32_t triangle : chart.triangles) {
            const glm::vec2* const t = &flat[3 * std::size_t{triangle}];
            const glm::dvec2 e = glm::dvec2(t[1]) - glm::dvec2(t[0]);
            const glm::dvec2 f = glm::dvec2(t[2]) - glm::dvec2(t[0]);
            m_area += 0.5 * std::abs(e.x * f.y - e.y * f.x) * chart.scale * chart.scale;
        }
    }
}

double ChartPacker::foretold_area(double density, int gutter) const {
    const double strip = 0.5 * (gutter + 1.0);
    return (m_area * density * density + m_perimeter * density * strip +
            4.0 * strip * strip * static_cast<double>(m_charts.size())) /
           full;
}

std::optional<Packing> ChartPacker::at(double density, const PageSettings& settings) const {
    if (!(m_longest * density < settings.side + 1.0)) {
        return std::nullopt;
    }
    Packing packing{.density = density, .side = settings.side};
    packing.layouts.resize(m_charts.size());
    std::vector<ChartShape> shapes(m_charts.size());
    parallel_ranges(m_charts.size(), 64, 0, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            packing.layouts[i] = lay_out(m_charts[i], m_flat, density);
            shapes[i] = shape_of(m_charts[i], m_flat, packing.layouts[i]);
        }
    });
    auto placements = pack(shapes, settings);
    if (!placements) {
        return std::nullopt;
    }
    packing.placements = std::move(*placements);
    for (const Placement& placement : packing.placements) {
        packing.page_count = std::max(packing.page_count, placement.page + 1);
    }
    return packing;
}

std::optional<Packing> ChartPacker::densest(const PageSettings& settings) const {
    // At the least density every chart has one texel.
    const double least = m_longest > 0.0 ? 0.5 / m_longest : 1.0;
    auto best = at(least, settings);
    if (!best || !(m_longest > 0.0)) {
        return best;
    }
    PageSettings pages = settings;
    pages.max_pages = static_cast<int>(best->page_count);
    double low = least;
    double high = 2.0 * settings.side / m_longest; // the longest chart does not fit
    const auto try_at = [&](double density) {
        if (auto packing = at(density, pages)) {
            best = std::move(packing);
            low = density;
            return true;
        }
        high = density;
        return false;
    };
    // The density at which the area foretold is the pages': the positive root.
    const double room = static_cast<double>(settings.side) * settings.side * pages.max_pages;
    double guess_low = low;
    double guess_high = high;
    for (int step = 0; step < 40; ++step) {
        const double middle = middle_of(guess_low, guess_high);
        (foretold_area(middle, settings.gutter) <= room ? guess_low : guess_high) = middle;
    }
    constexpr double stride = 1.08;
    if (guess_low > low && guess_low < high) {
        double next = guess_low;
        if (try_at(next)) {
            while ((next *= stride) < high && try_at(next)) {
            }
        } else {
            while ((next /= stride) > low && !try_at(next)) {
            }
        }
    }
    const double enough = m_charts.size() <= 64 ? 1.0 + 0x1p-12 : m_charts.size() <= 1024 ? 1.006 : 1.012;
    while (high > low * enough) {
        (void)try_at(middle_of(low, high));
    }
    return best;
}

std::optional<Packing> ChartPacker::least_page(double density, int gutter) const {
    std::optional<Packing> best;
    const int least = static_cast<int>(std::clamp(std::floor(m_longest * density), 1.0, double{greatest_side}));
    int low = least - 1; // does not fit
    int high = greatest_side + 1;
    const auto try_at = [&](int side) {
        if (auto packing = at(density, {side, gutter, 1})) {
            best = std::move(packing);
            high = side;
            return true;
        }
        low = side;
        return false;
    };
    int next = static_cast<int>(
        std::clamp(std::sqrt(foretold_area(density, gutter)), static_cast<double>(least), double{greatest_side}));
    const auto stride = [](int side) { return side / 16 + 1; };
    if (try_at(next)) {
        while ((next -= stride(next)) > low && try_at(next)) {
        }
    } else {
        while ((next = std::min(next + stride(next), greatest_side)) < high && !try_at(next) && next < greatest_side) {
        }
    }
    const int enough = m_charts.size() <= 64 ? 0 : high / 192;
    while (best && high - low > 1 + enough) {
        (void)try_at(low + (high - low) / 2);
    }
    return best;
}

std::optional<int> ChartPacker::side_that_fits(std::optional<double> density, const PageSettings& settings) const {
    const double tried = density ? *density : m_longest > 0.0 ? 0.5 / m_longest : 1.0;
    const auto fits = [&](int side) {
        PageSettings pages = settings;
        pages.side = side;
        return at(tried, pages).has_value();
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
    while (enough - too_small > 1 + enough / 64) {
        const int middle = too_small + (enough - too_small) / 2;
        (fits(middle) ? enough : too_small) = middle;
    }
    return enough;
}

} // namespace vkbake
