#include "tradeoff_page.hpp"

#include <fmt/format.h>

namespace vkbake::cli {
namespace {

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

double percent(double share) { return 100.0 * share; }

std::string row_html(const TradePoint& point, bool recommended) {
    return fmt::format(
        "<tr{}><td><code>{}</code>{}</td><td>{:.0f}</td><td>{:.2f}</td><td>{:.2f}</td><td>{:.2f}</td><td>{:.1f}</td>"
        "<td>{:+.3f}</td><td>{:.2f}</td><td>{}</td></tr>\n",
        recommended ? " class='recommended'" : "", escaped(point.flags), recommended ? "<br>↑ recommended" : "",
        point.rays_a_texel, point.seconds, percent(point.error.relative_rmse), percent(point.error.percentile_99),
        percent(point.error.maximum), percent(point.error.bias), point.color_difference, point.on_frontier ? "●" : "");
}

std::string figure_html(const std::string& picture, const std::string& caption) {
    return fmt::format("<figure><img alt='' src='data:image/bmp;base64,{}'><figcaption>{}</figcaption></figure>\n",
                       picture, caption);
}

constexpr const char* page_style = R"(
:root{color-scheme:light dark;--ink:#1b1e23;--paper:#fff;--soft:#667;--line:#ccd;--a:#c2410c;--b:#1d4ed8;--c:#15803d;--mark:#fef3c7}
@media(prefers-color-scheme:dark){:root{--ink:#e8eaf0;--paper:#15171c;--soft:#9aa3b2;--line:#333a46;--a:#fb923c;--b:#7aa2ff;--c:#4ade80;--mark:#3b3416}}
body{font:16px/1.5 system-ui,sans-serif;color:var(--ink);background:var(--paper);max-width:64rem;margin:2rem auto;padding:0 1rem}
table{border-collapse:collapse;width:100%;font-variant-numeric:tabular-nums}
td,th{padding:.3rem .6rem;text-align:right;border-bottom:1px solid var(--line)}
td:first-child,th:first-child{text-align:left;white-space:nowrap}.recommended{background:var(--mark)}
svg,img{max-width:100%}figure{display:inline-block;margin:.5rem;vertical-align:top}
img{width:26rem;image-rendering:pixelated;border:1px solid var(--line)}figcaption{color:var(--soft);font-size:.9rem}
@media print{body{max-width:none;color:#000;background:#fff}figure{break-inside:avoid}}
)";

} // namespace

std::string trade_table(const Trade& trade) {
    std::string text = fmt::format("{:<36} {:>8} {:>9} {:>8} {:>8} {:>8} {:>9} {:>8}\n", "", "rays", "seconds",
                                   "RMSE %", "99th %", "max %", "bias %", "colour");
    for (const TradePoint& point : trade.points) {
        text += fmt::format("{:<36} {:>8.0f} {:>9.2f} {:>8.2f} {:>8.2f} {:>8.1f} {:>+9.3f} {:>8.2f}{}\n", point.flags,
                            point.rays_a_texel, point.seconds, percent(point.error.relative_rmse),
                            percent(point.error.percentile_99), percent(point.error.maximum), percent(point.error.bias),
                            point.color_difference, point.on_frontier ? "  *" : "");
    }
    return text + "* nothing that was tried is faster and better\n"
                  "colour: how different a picture drawn with the maps looks (mean CIEDE2000; 1 can just be seen)\n";
}

std::string trade_json(const Trade& trade) {
    std::string points;
    for (const TradePoint& point : trade.points) {
        points += fmt::format(
            "{}    {{\"flags\": \"{}\", \"rays_a_texel\": {}, \"seconds\": {}, \"relative_rmse\": {}, "
            "\"percentile_99\": {}, \"maximum\": {}, \"bias\": {}, \"color_difference\": {}, \"on_frontier\": {}}}",
            points.empty() ? "" : ",\n", point.flags, point.rays_a_texel, point.seconds, point.error.relative_rmse,
            point.error.percentile_99, point.error.maximum, point.error.bias, point.color_difference,
            point.on_frontier);
    }
    return fmt::format("{{\n  \"size\": {},\n  \"recommended\": \"{}\",\n  \"points\": [\n{}\n  ]\n}}\n", trade.size,
                       trade.points[trade.recommended].flags, points);
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
        "bake of 0.05 % error and another seed.</p>\n{4}<p>Dashed: the frontier, nothing that was tried is "
        "faster and better.</p>\n"
        "<table><thead><tr><th></th><th>rays a texel</th><th>seconds</th><th>RMSE %</th><th>99th %</th><th>max %</th>"
        "<th>bias %</th><th>colour</th><th>frontier</th></tr></thead>\n<tbody>\n{5}</tbody></table>\n"
        "<p>Errors are those of the maps, against the reference; <em>colour</em> is how different a picture of the "
        "scene "
        "looks that is drawn with them: the mean CIEDE2000, of which 1 can just be seen.</p>\n"
        "<h2>The same detail of the map</h2><p>Left the light, right its error, ten times as bright.</p>\n{6}</html>\n",
        escaped(trade.scene), page_style, trade.size, escaped(trade.sky), trade_plot(trade, PlotGround::page), rows,
        figures);
}

} // namespace vkbake::cli
