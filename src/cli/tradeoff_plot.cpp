#include "tradeoff_page.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace vkbake::cli {
namespace {

constexpr double left_margin = 70.0;
constexpr double right_margin = 20.0;
constexpr double upper_margin = 20.0;
constexpr double lower_margin = 55.0;

/// From values to places on a logarithmic axis of whole and half decades.
struct Axis {
    double low = 0.0; ///< logarithms
    double high = 1.0;
    double from = 0.0; ///< places
    double to = 1.0;

    [[nodiscard]] double place(double value) const {
        return from + (std::log10(value) - low) / (high - low) * (to - from);
    }
};

template<typename Value>
Axis axis_over(const std::vector<TradePoint>& points, const Value& value, double from, double to) {
    double low = 1e30;
    double high = -1e30;
    for (const TradePoint& point : points) {
        low = std::min(low, std::log10(value(point)));
        high = std::max(high, std::log10(value(point)));
    }
    constexpr double room = 0.12;
    return {low - room, high + room, from, to};
}

/// 1, 2 and 5 of each decade that the axis shows.
std::vector<double> ticks(const Axis& axis) {
    std::vector<double> values;
    for (int decade = static_cast<int>(std::floor(axis.low)); decade <= static_cast<int>(std::ceil(axis.high));
         ++decade) {
        for (const double first : {1.0, 2.0, 5.0}) {
            const double value = first * std::pow(10.0, decade);
            if (std::log10(value) >= axis.low && std::log10(value) <= axis.high) {
                values.push_back(value);
            }
        }
    }
    return values;
}

const char* point_class(const TradePoint& point) {
    if (point.denoised) {
        return "denoised";
    }
    return point.adaptive ? "adaptive" : "even";
}

double seconds_of(const TradePoint& point) { return std::max(point.seconds, 1e-4); }
double percent_of(const TradePoint& point) { return std::max(100.0 * point.error.relative_rmse, 1e-4); }

std::string axes_svg(const Axis& x, const Axis& y) {
    std::string svg;
    for (const double value : ticks(x)) {
        svg += fmt::format(
            "<path class='grid' d='M{0:.1f} {1} V{2}'/><text x='{0:.1f}' y='{3}' text-anchor='middle'>{4:g} s</text>\n",
            x.place(value), upper_margin, plot_height - lower_margin, plot_height - lower_margin + 18.0, value);
    }
    for (const double value : ticks(y)) {
        svg += fmt::format(
            "<path class='grid' d='M{1} {0:.1f} H{2}'/><text x='{3}' y='{4:.1f}' text-anchor='end'>{5:g} %</text>\n",
            y.place(value), left_margin, plot_width - right_margin, left_margin - 8.0, y.place(value) + 4.0, value);
    }
    return svg + fmt::format("<text x='{}' y='{}' text-anchor='middle'>time of tracing and denoising</text>\n"
                             "<text transform='translate(16 {}) rotate(-90)' text-anchor='middle'>relative error (RMSE "
                             "/ mean)</text>\n",
                             0.5 * (left_margin + plot_width), plot_height - 12.0, 0.5 * plot_height);
}

/// In the corner where points would be slow and bad.
std::string legend_svg() {
    constexpr std::array<std::array<const char*, 2>, 3> entries{{{"even", "as many rays for every texel"},
                                                                 {"adaptive", "rays where they are needed"},
                                                                 {"denoised", "denoised"}}};
    const double x = plot_width - right_margin - 205.0;
    double y = upper_margin + 14.0;
    std::string svg;
    for (const auto& [name, text] : entries) {
        svg += fmt::format("<circle class='{}' cx='{}' cy='{}' r='5'/><text x='{}' y='{}'>{}</text>\n", name, x, y,
                           x + 12.0, y + 4.0, text);
        y += 20.0;
    }
    return svg;
}

struct Box {
    double left = 0.0;
    double top = 0.0;
    double right = 0.0;
    double bottom = 0.0;

    [[nodiscard]] bool meets(const Box& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

struct Mark {
    const TradePoint* point = nullptr; ///< never null
    double x = 0.0;
    double y = 0.0;
    std::string text;
    Box label;
};

Box dot_of(const Mark& mark) {
    constexpr double radius = 6.0;
    return {mark.x - radius, mark.y - radius, mark.x + radius, mark.y + radius};
}

/// The places of a label beside its point, the best first.
std::array<Box, 8> places_of(const Mark& mark) {
    constexpr double a_letter = 6.9; // of the plot's font, about
    constexpr double height = 15.0;
    const double width = a_letter * static_cast<double>(mark.text.size());
    const auto box = [&](double left, double top) { return Box{left, top, left + width, top + height}; };
    const double right = mark.x + 9.0;
    const double left = mark.x - 9.0 - width;
    return {box(right, mark.y - 17.0),
            box(right, mark.y + 2.0),
            box(left, mark.y + 2.0),
            box(left, mark.y - 17.0),
            box(right, mark.y + 16.0),
            box(left, mark.y + 16.0),
            box(mark.x - 0.5 * width, mark.y - 22.0),
            box(mark.x - 0.5 * width, mark.y + 7.0)};
}

/// The colour says that a point is denoised; beside its like, what sets a point apart is enough.
std::string label_of(const TradePoint& point) {
    const std::string flags = point.flags.substr(2);
    const std::size_t apart = flags.find("reuse off");
    return apart == std::string::npos ? flags.substr(0, flags.find(" --denoise on")) : flags.substr(apart);
}

/// The points with their labels, each where it hides no point and no label before it, if there is such a place.
std::vector<Mark> marks(const std::vector<TradePoint>& points, const Axis& x, const Axis& y) {
    std::vector<Mark> result;
    result.reserve(points.size());
    for (const TradePoint& point : points) {
        result.push_back({&point, x.place(seconds_of(point)), y.place(percent_of(point)), label_of(point), {}});
    }
    for (std::size_t index = 0; index < result.size(); ++index) {
        const auto is_free = [&](const Box& place) {
            const auto label_meets = [&](const Mark& mark) { return mark.label.meets(place); };
            const auto dot_meets = [&](const Mark& mark) { return dot_of(mark).meets(place); };
            const auto before = result.begin() + static_cast<std::ptrdiff_t>(index);
            return place.left > left_margin && place.right < plot_width &&
                   std::none_of(result.begin(), before, label_meets) && std::ranges::none_of(result, dot_meets);
        };
        const std::array<Box, 8> places = places_of(result[index]);
        const auto* const found = std::ranges::find_if(places, is_free);
        result[index].label = found != places.end() ? *found : places.front();
    }
    return result;
}

/// Where the plot is part of a page it has the page's colours.
std::string style_svg(PlotGround ground) {
    const auto color = [ground](const char* name, const char* plain) {
        return ground == PlotGround::page ? fmt::format("var(--{},{})", name, plain) : std::string(plain);
    };
    return fmt::format("<style>\n.plot text{{font:13px system-ui,sans-serif;fill:{};"
                       "paint-order:stroke;stroke:{};stroke-width:3}}\n"
                       ".plot .grid{{stroke:{};stroke-width:.6}}\n"
                       ".plot .even{{fill:{};stroke:none}}.plot .denoised{{fill:{};stroke:none}}\n"
                       ".plot .adaptive{{fill:{};stroke:none}}\n"
                       ".plot .frontier{{fill:none;stroke:{};stroke-width:1.5;stroke-dasharray:5 4}}\n</style>\n{}",
                       color("ink", "#333"), color("paper", "#fff"), color("line", "#bbb"), color("b", "#2563eb"),
                       color("c", "#15803d"), color("a", "#ea580c"), color("soft", "#888"),
                       ground == PlotGround::white ? "<rect width='100%' height='100%' fill='#fff'/>\n" : "");
}

} // namespace

std::string trade_plot(const Trade& trade, PlotGround ground) {
    const Axis x = axis_over(trade.points, seconds_of, left_margin, plot_width - right_margin);
    const Axis y = axis_over(trade.points, percent_of, plot_height - lower_margin, upper_margin);
    std::string svg = fmt::format(
        "<svg xmlns='http://www.w3.org/2000/svg' class='plot' viewBox='0 0 {0} {1}' width='{0}' height='{1}'>\n",
        plot_width, plot_height);
    svg += style_svg(ground) + axes_svg(x, y) + legend_svg();
    std::vector<TradePoint> frontier;
    std::copy_if(trade.points.begin(), trade.points.end(), std::back_inserter(frontier),
                 [](const TradePoint& point) { return point.on_frontier; });
    std::sort(frontier.begin(), frontier.end(),
              [](const TradePoint& a, const TradePoint& b) { return a.seconds < b.seconds; });
    std::string path;
    for (const TradePoint& point : frontier) {
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : " L", x.place(seconds_of(point)),
                            y.place(percent_of(point)));
    }
    svg += fmt::format("<path class='frontier' d='{}'/>\n", path);
    for (const Mark& mark : marks(trade.points, x, y)) {
        svg +=
            fmt::format("<circle class='{}' cx='{:.1f}' cy='{:.1f}' r='5'/><text x='{:.1f}' y='{:.1f}'>{}</text>\n",
                        point_class(*mark.point), mark.x, mark.y, mark.label.left, mark.label.bottom - 3.0, mark.text);
    }
    return svg + "</svg>\n";
}

} // namespace vkbake::cli
