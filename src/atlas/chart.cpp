#include "atlas/chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "atlas/predicates.hpp"

namespace vkbake {

namespace {

constexpr double too_long =
    32768.0; // texels: more than any page has; enough to be refused, and sums stay far from overflow

struct AxisLayout {
    int texels = 1;
    double scale = 0.0;
    double offset = 0.0;
};

AxisLayout centred_axis(double lower, double upper, double scale) {
    const double extent = std::min((upper - lower) * scale, too_long);
    const double texels = std::max(1.0, std::ceil(extent + 0.5));
    return {static_cast<int>(texels), scale, 0.5 * (texels - extent) - lower * scale};
}

/// `point` of the chart comes to lie on a texel's centre, the first that leaves the box within the texels.
AxisLayout axis_through(double point, double lower, double upper, double scale) {
    constexpr double margin = 1.0 / 64.0; // rounding, generously
    const double before = std::min((point - lower) * scale, too_long);
    const double after = std::min((upper - point) * scale, too_long);
    const double centre = std::max(0.0, std::ceil(before - 0.5 + margin)) + 0.5;
    const double texels = std::floor(centre + after + margin) + 1.0;
    return {static_cast<int>(std::min(texels, too_long)), scale, centre - point * scale};
}

AxisLayout lay_axis(Chart::Fit fit, double anchor, double lower, double upper, double scale) {
    const double extent = std::min((upper - lower) * scale, too_long);
    if (fit == Chart::Fit::centred || extent <= 0.5) {
        return centred_axis(lower, upper, scale);
    }
    switch (fit) {
    case Chart::Fit::both: {
        const double whole = std::max(1.0, std::round(extent));
        const double own = whole / (upper - lower);
        return {static_cast<int>(whole) + 1, own, 0.5 - lower * own};
    }
    case Chart::Fit::lower:
        return axis_through(lower, lower, upper, scale);
    case Chart::Fit::upper:
        return axis_through(upper, lower, upper, scale);
    default:
        return axis_through(anchor, lower, upper, scale);
    }
}

/// Whether some triangle of the chart holds the centre of a texel, its sides included.
bool holds_centre(const Chart& chart, std::span<const glm::vec2> flat, const ChartLayout& layout) {
    for (const std::uint32_t triangle : chart.triangles) {
        std::array<glm::dvec2, 3> t{};
        glm::dvec2 low(too_long);
        glm::dvec2 high(-too_long);
        for (std::size_t c = 0; c < 3; ++c) {
            t[c] = glm::dvec2(flat[3 * std::size_t{triangle} + c]) * layout.scale + layout.offset;
            low = {std::min(low.x, t[c].x), std::min(low.y, t[c].y)};
            high = {std::max(high.x, t[c].x), std::max(high.y, t[c].y)};
        }
        for (double y = std::ceil(low.y - 0.5) + 0.5; y <= high.y; y += 1.0) {
            for (double x = std::ceil(low.x - 0.5) + 0.5; x <= high.x; x += 1.0) {
                int sides = 0;
                for (std::size_t c = 0; c < 3; ++c) {
                    const glm::dvec2 along = t[(c + 1) % 3] - t[c];
                    sides += along.x * (y - t[c].y) - along.y * (x - t[c].x) <= 0.0 ? 1 : 0;
                }
                if (sides == 3) {
                    return true;
                }
            }
        }
    }
    return false;
}

ChartLayout lay_axes(const Chart& chart, Chart::Fit fit_u, Chart::Fit fit_v, double scale) {
    const AxisLayout u = lay_axis(fit_u, chart.anchor.x, chart.lower.x, chart.upper.x, scale);
    const AxisLayout v = lay_axis(fit_v, chart.anchor.y, chart.lower.y, chart.upper.y, scale);
    return {{u.texels, v.texels}, {u.scale, v.scale}, {u.offset, v.offset}};
}

} // namespace

Chart bounded_chart(std::vector<std::uint32_t> triangles, std::span<const glm::vec2> flat) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Chart chart{.triangles = std::move(triangles), .lower = glm::dvec2(infinity), .upper = glm::dvec2(-infinity)};
    for (const std::uint32_t triangle : chart.triangles) {
        for (std::size_t c = 0; c < 3; ++c) {
            for (int axis = 0; axis < 2; ++axis) {
                const double value = flat[3 * std::size_t{triangle} + c][axis];
                chart.lower[axis] = std::min(chart.lower[axis], value);
                chart.upper[axis] = std::max(chart.upper[axis], value);
            }
        }
    }
    return chart;
}

std::vector<Chart> charts_of(std::span<const std::vector<std::uint32_t>> pieces, std::span<const glm::vec2> local_flat,
                             std::span<const std::uint32_t> triangles, std::span<glm::vec2> flat) {
    for (std::size_t local = 0; local < triangles.size(); ++local) {
        std::copy_n(local_flat.begin() + static_cast<std::ptrdiff_t>(3 * local), 3,
                    flat.begin() + 3 * static_cast<std::ptrdiff_t>(triangles[local]));
    }
    std::vector<Chart> charts;
    charts.reserve(pieces.size());
    for (const auto& members : pieces) {
        std::vector<std::uint32_t> numbers(members.size());
        std::ranges::transform(members, numbers.begin(), [&](std::uint32_t local) { return triangles[local]; });
        charts.push_back(bounded_chart(std::move(numbers), flat));
    }
    return charts;
}

void fit_to_texels(Chart& chart, std::span<const glm::vec2> flat) {
    const glm::dvec2 extent = chart.upper - chart.lower;
    std::array<glm::dvec2, 2> straight{}; // by border, lower and upper: length along it, by axis
    double largest = -1.0;
    for (const std::uint32_t triangle : chart.triangles) {
        const glm::vec2* const t = &flat[3 * std::size_t{triangle}];
        for (std::size_t c = 0; c < 3; ++c) {
            const glm::dvec2 a(t[c]);
            const glm::dvec2 b(t[(c + 1) % 3]);
            for (int axis = 0; axis < 2; ++axis) {
                const double near = 1e-4 * extent[axis];
                const double length = std::abs(a[1 - axis] - b[1 - axis]);
                straight[0][axis] += std::max(a[axis], b[axis]) <= chart.lower[axis] + near ? length : 0.0;
                straight[1][axis] += std::min(a[axis], b[axis]) >= chart.upper[axis] - near ? length : 0.0;
            }
        }
        const glm::dvec2 e = glm::dvec2(t[1]) - glm::dvec2(t[0]);
        const glm::dvec2 f = glm::dvec2(t[2]) - glm::dvec2(t[0]);
        const double area = std::abs(e.x * f.y - e.y * f.x);
        if (area > largest) {
            largest = area;
            chart.anchor = (glm::dvec2(t[0]) + glm::dvec2(t[1]) + glm::dvec2(t[2])) / 3.0;
        }
    }
    const auto fit = [&](int axis) {
        const bool at_lower = straight[0][axis] > 0.25 * extent[1 - axis];
        const bool at_upper = straight[1][axis] > 0.25 * extent[1 - axis];
        return at_lower && at_upper ? Chart::Fit::both
               : at_lower           ? Chart::Fit::lower
               : at_upper           ? Chart::Fit::upper
                                    : Chart::Fit::anchored;
    };
    chart.fit_u = fit(0);
    chart.fit_v = fit(1);
}

ChartLayout lay_out(const Chart& chart, std::span<const glm::vec2> flat, double density) {
    const double scale = chart.scale * density;
    const ChartLayout layout = lay_axes(chart, chart.fit_u, chart.fit_v, scale);
    constexpr int small = 6; // above this many texels both ways, what has straight borders holds a centre
    const bool certain = chart.fit_u == Chart::Fit::centred ||
                         (chart.fit_u == Chart::Fit::anchored && chart.fit_v == Chart::Fit::anchored &&
                          std::min(layout.size.width, layout.size.height) > 1) ||
                         std::min(layout.size.width, layout.size.height) > small;
    if (certain || holds_centre(chart, flat, layout)) {
        return layout;
    }
    // The anchor on a texel's centre along both axes, however short they are.
    const AxisLayout u = axis_through(chart.anchor.x, chart.lower.x, chart.upper.x, scale);
    const AxisLayout v = axis_through(chart.anchor.y, chart.lower.y, chart.upper.y, scale);
    return {{u.texels, v.texels}, {u.scale, v.scale}, {u.offset, v.offset}};
}

} // namespace vkbake
