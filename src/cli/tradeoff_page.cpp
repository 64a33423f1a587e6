#include "tradeoff_page.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace vkbake::cli {
namespace {

constexpr double plot_width = 720.0;
constexpr double plot_height = 420.0;
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

std::string escaped(const std::string& text) {
    std::string result;
    for (const char letter : text) {
        switch (letter) {
        case '<':
            result += "&lt;";
            break;
        case '&':
            result += "&amp;";
            break;
        case '"':
            result += "&quot;";
            break;
        default:
            result += letter;
        }
    }
    return result;
}

const char* point_class(const TradePoint& point) {
    if (point.denoised) {
        return "denoised";
    }
    return point.adaptive ? "adaptive" : "even";
}

double percent(double share) { return 100.0 * share; }

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

std::string row_html(const TradePoint& point, bool recommended) {
    return fmt::format(
        "<tr{}><td><code>{}</code>{}</td><td>{:.0f}</td><td>{:.2f}</td><td>{:.2f}</td><td>{:.2f}</td><td>{:.1f}</td>"
        "<td>{:+.3f}</td><td>{}</td></tr>\n",
        recommended ? " class='recommended'" : "", escaped(point.flags), recommended ? " ← recommended" : "",
        point.rays_a_texel, point.seconds, percent(point.error.relative_rmse), percent(point.error.percentile_99),
        percent(point.error.maximum), percent(point.error.bias), point.on_frontier ? "●" : "");
}

std::string figure_html(const std::string& picture, const std::string& caption) {
    return fmt::format("<figure><img alt='' src='data:image/bmp;base64,{}'><figcaption>{}</figcaption></figure>\n",
                       picture, caption);
}

constexpr const char* page_style = R"(
:root{color-scheme:light dark;--ink:#1b1e23;--paper:#fff;--soft:#667;--line:#ccd;--a:#c2410c;--b:#1d4ed8;--c:#15803d;--mark:#fef3c7}
@media(prefers-color-scheme:dark){:root{--ink:#e8eaf0;--paper:#15171c;--soft:#9aa3b2;--line:#333a46;--a:#fb923c;--b:#7aa2ff;--c:#4ade80;--mark:#3b3416}}
body{font:16px/1.5 system-ui,sans-serif;color:var(--ink);background:var(--paper);max-width:60rem;margin:2rem auto;padding:0 1rem}
table{border-collapse:collapse;width:100%;font-variant-numeric:tabular-nums}
td,th{padding:.3rem .6rem;text-align:right;border-bottom:1px solid var(--line)}
td:first-child,th:first-child{text-align:left}.recommended{background:var(--mark)}
svg,img{max-width:100%}figure{display:inline-block;margin:.5rem;vertical-align:top}
img{width:26rem;image-rendering:pixelated;border:1px solid var(--line)}figcaption{color:var(--soft);font-size:.9rem}
@media print{body{max-width:none;color:#000;background:#fff}figure{break-inside:avoid}}
)";

constexpr const char* plot_style = R"(<style>
.plot text{font:13px system-ui,sans-serif;fill:var(--ink,#444)}.plot .grid{stroke:var(--line,#bbb);stroke-width:.6}
.plot .even{fill:var(--b,#2563eb);stroke:none}.plot .denoised{fill:var(--c,#15803d);stroke:none}
.plot .adaptive{fill:var(--a,#ea580c);stroke:none}
.plot .frontier{fill:none;stroke:var(--soft,#888);stroke-width:1.5;stroke-dasharray:5 4}
</style>
)";

} // namespace

std::string trade_table(const Trade& trade) {
    std::string text = fmt::format("{:<36} {:>8} {:>9} {:>8} {:>8} {:>8} {:>9}\n", "", "rays", "seconds", "RMSE %",
                                   "99th %", "max %", "bias %");
    for (const TradePoint& point : trade.points) {
        text += fmt::format("{:<36} {:>8.0f} {:>9.2f} {:>8.2f} {:>8.2f} {:>8.1f} {:>+9.3f}{}\n", point.flags,
                            point.rays_a_texel, point.seconds, percent(point.error.relative_rmse),
                            percent(point.error.percentile_99), percent(point.error.maximum), percent(point.error.bias),
                            point.on_frontier ? "  *" : "");
    }
    return text + "* nothing that was tried is faster and better\n";
}

std::string trade_json(const Trade& trade) {
    std::string points;
    for (const TradePoint& point : trade.points) {
        points += fmt::format(
            "{}    {{\"flags\": \"{}\", \"rays_a_texel\": {}, \"seconds\": {}, \"relative_rmse\": {}, "
            "\"percentile_99\": {}, \"maximum\": {}, \"bias\": {}, \"on_frontier\": {}}}",
            points.empty() ? "" : ",\n", point.flags, point.rays_a_texel, point.seconds, point.error.relative_rmse,
            point.error.percentile_99, point.error.maximum, point.error.bias, point.on_frontier);
    }
    return fmt::format("{{\n  \"size\": {},\n  \"recommended\": \"{}\",\n  \"points\": [\n{}\n  ]\n}}\n", trade.size,
                       trade.points[trade.recommended].flags, points);
}

std::string trade_plot(const Trade& trade) {
    const Axis x = axis_over(
        trade.points, [](const TradePoint& point) { return std::max(point.seconds, 1e-4); }, left_margin,
        plot_width - right_margin);
    const Axis y = axis_over(
        trade.points, [](const TradePoint& point) { return std::max(percent(point.error.relative_rmse), 1e-4); },
        plot_height - lower_margin, upper_margin);
    std::string svg = fmt::format(
        "<svg xmlns='http://www.w3.org/2000/svg' class='plot' viewBox='0 0 {0} {1}' width='{0}' height='{1}'>\n",
        plot_width, plot_height);
    svg += plot_style + axes_svg(x, y);
    std::vector<TradePoint> frontier;
    std::copy_if(trade.points.begin(), trade.points.end(), std::back_inserter(frontier),
                 [](const TradePoint& point) { return point.on_frontier; });
    std::sort(frontier.begin(), frontier.end(),
              [](const TradePoint& a, const TradePoint& b) { return a.seconds < b.seconds; });
    std::string path;
    for (const TradePoint& point : frontier) {
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : " L", x.place(std::max(point.seconds, 1e-4)),
                            y.place(std::max(percent(point.error.relative_rmse), 1e-4)));
    }
    svg += fmt::format("<path class='frontier' d='{}'/>\n", path);
    for (const TradePoint& point : trade.points) {
        const double at_x = x.place(std::max(point.seconds, 1e-4));
        const double at_y = y.place(std::max(percent(point.error.relative_rmse), 1e-4));
        const bool to_left = at_x > 0.72 * plot_width;
        svg += fmt::format("<circle class='{}' cx='{:.1f}' cy='{:.1f}' r='5'/><text x='{:.1f}' y='{:.1f}' "
                           "text-anchor='{}'>{}</text>\n",
                           point_class(point), at_x, at_y, at_x + (to_left ? -9.0 : 9.0),
                           at_y + (point.adaptive ? 14.0 : -7.0), to_left ? "end" : "start",
                           escaped(point.flags.substr(2)));
    }
    return svg + "</svg>\n";
}

std::string trade_page(const Trade& trade) {
    std::string rows;
    std::string figures = figure_html(trade.reference_picture, "reference");
    for (std::size_t index = 0; index < trade.points.size(); ++index) {
        const TradePoint& point = trade.points[index];
        rows += row_html(point, index == trade.recommended);
        figures += figure_html(point.picture, fmt::format("<code>{}</code>: {:.2f} %, {:.2f} s", escaped(point.flags),
                                                          percent(point.error.relative_rmse), point.seconds));
    }
    return fmt::format(
        "<!doctype html>\n<html lang='en'><meta charset='utf-8'><meta name='viewport' content='width=device-width'>\n"
        "<title>{0}: speed for accuracy</title><style>{1}</style>\n"
        "<h1>{0}: speed for accuracy</h1>\n<p>Light maps of {2} × {2} texels under the sky <code>{3}</code>, measured "
        "against a "
        "bake of 0.05 % error and another seed.</p>\n{4}<p>Blue: the same rays for every texel; orange: rays where "
        "they are "
        "needed; green: either, denoised. Dashed: the frontier, nothing that was tried is faster and better.</p>\n"
        "<table><thead><tr><th></th><th>rays a texel</th><th>seconds</th><th>RMSE %</th><th>99th %</th><th>max %</th>"
        "<th>bias %</th><th>frontier</th></tr></thead>\n<tbody>\n{5}</tbody></table>\n"
        "<h2>The same detail of the map</h2><p>Left the light, right its error, ten times as bright.</p>\n{6}</html>\n",
        escaped(trade.scene), page_style, trade.size, escaped(trade.sky), trade_plot(trade), rows, figures);
}

} // namespace vkbake::cli
