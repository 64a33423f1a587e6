#include "atlas/density.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "base/parallel.hpp"

namespace vkbake {

namespace {

constexpr double full = 0.85;                      // of a page: what an average atlas takes
constexpr int greatest_height = 2 * greatest_side; // while it is looked for

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
    if (!(m_longest * density < std::max(settings.width, settings.height) + 1.0)) {
        return std::nullopt;
    }
    Packing packing{.density = density, .width = settings.width};
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
    for (std::size_t i = 0; i < packing.placements.size(); ++i) {
        const Placement& placement = packing.placements[i];
        packing.page_count = std::max(packing.page_count, placement.page + 1);
        packing.height =
            std::max(packing.height, placement.y + (placement.turns % 2 == 1 ? shapes[i].width : shapes[i].height));
    }
    return packing;
}

std::optional<Packing> ChartPacker::on_pages(double density, const PageSettings& settings) const {
    auto packing = at(density, settings);
    if (packing) {
        packing->height = settings.height;
    }
    return packing;
}

std::optional<Packing> ChartPacker::densest(const PageSettings& settings) const {
    // At the least density every chart has one texel.
    const double least = m_longest > 0.0 ? 0.5 / m_longest : 1.0;
    auto best = on_pages(least, settings);
    if (!best || !(m_longest > 0.0)) {
        return best;
    }
    // How high the charts would stand says how much too dense they are, so the density is soon found: the area that
    // they take grows with its square.
    const double room = static_cast<double>(settings.height) * best->page_count;
    PageSettings pages = settings;
    pages.max_pages = static_cast<int>(best->page_count);
    const bool one_page = pages.max_pages == 1;
    if (one_page) {
        pages.height = std::min(2 * settings.height, greatest_height);
    }
    double low = least;
    double high = 2.0 * std::max(settings.width, settings.height) / m_longest; // the longest chart does not fit
    const double enough = m_charts.size() <= 16 ? 1.0 + 0x1p-12 : m_charts.size() <= 1024 ? 1.006 : 1.012;
    double next = density_for(room * settings.width, settings.gutter, low, high);
    while (high > low * enough) {
        auto packing = at(next, pages);
        const bool fits = packing && packing->height <= settings.height;
        (fits ? low : high) = next;
        const double rows = !packing ? 1.5 * room : one_page ? packing->height : fits ? 0.95 * room : 1.05 * room;
        // Aimed a little beyond, so that the interval closes from both sides.
        const double aim =
            next * std::sqrt(room / rows) * std::sqrt(fits ? std::sqrt(enough) : 1.0 / std::sqrt(enough));
        if (fits) {
            packing->height = settings.height;
            best = std::move(packing);
        }
        next = aim > low && aim < high ? aim : middle_of(low, high);
    }
    return best;
}

double ChartPacker::density_for(double area, int gutter, double low, double high) const {
    for (int step = 0; step < 40; ++step) {
        const double middle = middle_of(low, high);
        (foretold_area(middle, gutter) <= area ? low : high) = middle;
    }
    return low;
}

std::optional<Packing> ChartPacker::least_of_widths(double density, int width, int least, int gutter) const {
    constexpr std::size_t few = 64; // charts: more fill a page of any width alike
    constexpr std::array shares{1.0, 0.8, 0.9, 1.2};
    std::array<std::optional<Packing>, shares.size()> packings;
    const auto pack_at = [&](std::size_t i) {
        const int own = std::clamp(static_cast<int>(shares[i] * width), std::min(least, greatest_side), greatest_side);
        packings[i] = at(density, {own, greatest_height, gutter, 1});
    };
    if (m_charts.size() > few) {
        pack_at(0);
        return std::move(packings[0]);
    }
    parallel_ranges(shares.size(), 1, 0, [&](std::size_t begin, std::size_t) { pack_at(begin); });
    const auto area = [](const std::optional<Packing>& packing) {
        return packing ? static_cast<double>(packing->width) * packing->height
                       : std::numeric_limits<double>::infinity();
    };
    return std::move(*std::min_element(packings.begin(), packings.end(),
                                       [&](const auto& a, const auto& b) { return area(a) < area(b); }));
}

std::optional<Packing> ChartPacker::least_page(double density, int gutter) const {
    const double longest = std::ceil(m_longest * density) + 1.0;
    const double side = std::sqrt(foretold_area(density, gutter));
    if (!(std::max(longest, side) <= greatest_height)) {
        return std::nullopt;
    }
    const int width = std::clamp(static_cast<int>(std::max(longest, side)), 1, greatest_side);
    auto packing = least_of_widths(density, width, static_cast<int>(longest), gutter);
    // A page twice as high as wide, or half as high, was foretold badly: once more, with what is known now.
    if (packing && std::max(packing->height, packing->width) > 2 * std::min(packing->height, packing->width)) {
        const double known = std::sqrt(static_cast<double>(packing->height) * packing->width);
        const int better = std::clamp(static_cast<int>(std::max(longest, std::ceil(known))), 1, greatest_side);
        packing = better == width ? std::move(packing) : at(density, {better, greatest_height, gutter, 1});
    }
    return packing && packing->height <= greatest_side ? std::move(packing) : std::nullopt;
}

std::optional<int> ChartPacker::side_that_fits(std::optional<double> density, const PageSettings& settings) const {
    const double tried = density ? *density : m_longest > 0.0 ? 0.5 / m_longest : 1.0;
    const auto fits = [&](int side) {
        PageSettings pages = settings;
        pages.width = side;
        pages.height = side;
        return at(tried, pages).has_value();
    };
    int too_small = settings.width;
    int enough = settings.width;
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
