#include "bench/summary/scaling_plot.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace vkbake::bench {
namespace {

constexpr double width = 760.0;
constexpr double height = 440.0;
constexpr double left = 70.0;
constexpr double right = 170.0;
constexpr double top = 40.0;
constexpr double bottom = 60.0;

struct Axes {
    double least = 0.0;    ///< log10 of triangles
    double most = 1.0;     ///< log10 of triangles
    double greatest = 1.0; ///< nanoseconds

    [[nodiscard]] double x(double triangles) const {
        return left + (std::log10(triangles) - least) / (most - least) * (width - left - right);
    }
    [[nodiscard]] double y(double nanoseconds) const {
        return height - bottom - nanoseconds / greatest * (height - top - bottom);
    }
};

struct Point {
    double triangles;
    double nanoseconds;
};

/// 1, 2 or 5 times a power of ten, so that some five of it make up `range`.
double round_step(double range) {
    const double power = std::pow(10.0, std::floor(std::log10(range / 5.0)));
    const double wanted = range / 5.0 / power;
    return power * (wanted < 1.5 ? 1.0 : (wanted < 3.5 ? 2.0 : (wanted < 7.5 ? 5.0 : 10.0)));
}

std::string text(double x, double y, const std::string& words, const std::string& more = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, more, words);
}

std::string frame(const Axes& axes, const std::vector<Point>& points) {
    std::string svg;
    const double step = round_step(axes.greatest);
    for (double value = 0.0; value <= axes.greatest; value += step) {
        svg += fmt::format("<line x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\" stroke=\"#ddd\"/>\n", left,
                           width - right, axes.y(value));
        svg += text(left - 8.0, axes.y(value) + 4.0, fmt::format("{:g}", value), "text-anchor=\"end\"");
    }
    for (const Point& point : points) {
        const double x = axes.x(point.triangles);
        svg += fmt::format("<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\" stroke=\"#ddd\"/>\n", x, top,
                           height - bottom);
        const std::string count = point.triangles >= 1e6 ? fmt::format("{:.1f}M", point.triangles / 1e6)
                                                         : fmt::format("{:.0f}k", point.triangles / 1e3);
        svg += text(x, height - bottom + 18.0, count, "text-anchor=\"middle\"");
    }
    svg += text(0.5 * (left + width - right), height - 16.0, "triangles (logarithmic)", "text-anchor=\"middle\"");
    svg += text(left - 50.0, top - 16.0, "ns a ray, one thread, making included");
    return svg;
}

std::string curve(const Axes& axes, const std::vector<Point>& points, const std::string& name, const std::string& style,
                  bool marked) {
    std::string path;
    std::string marks;
    for (const Point& point : points) {
        const double x = axes.x(point.triangles);
        const double y = axes.y(point.nanoseconds);
        path += fmt::format("{:.1f},{:.1f} ", x, y);
        if (marked) {
            marks += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" {} />\n", x, y, style);
        }
    }
    return fmt::format("<polyline points=\"{}\" stroke-width=\"2\" {} fill-opacity=\"0\" />\n", path, style) + marks +
           text(width - right + 10.0, axes.y(points.back().nanoseconds) + 4.0, name);
}

std::vector<Point> times_of(const std::vector<Result>& results, const std::string& who) {
    std::vector<Point> points;
    points.reserve(results.size());
    for (const Result& result : results) {
        points.push_back({static_cast<double>(result.triangles),
                          1e9 / result.passes.at(who).at(true).at(result.few).rays_per_second});
    }
    return points;
}

} // namespace

std::string scaling_plot(std::vector<Result> results) {
    std::sort(results.begin(), results.end(),
              [](const Result& a, const Result& b) { return a.triangles < b.triangles; });
    const std::vector<Point> ours = times_of(results, "ours");
    const std::vector<Point> embree = times_of(results, "embree robust");
    std::vector<Point> logarithm;
    logarithm.reserve(ours.size());
    for (const Point& point : ours) {
        logarithm.push_back(
            {point.triangles, ours.front().nanoseconds * std::log(point.triangles) / std::log(ours.front().triangles)});
    }
    Axes axes{std::log10(ours.front().triangles), std::log10(ours.back().triangles), 0.0};
    for (const std::vector<Point>* points : {&ours, &embree, static_cast<const std::vector<Point>*>(&logarithm)}) {
        for (const Point& point : *points) {
            axes.greatest = std::max(axes.greatest, 1.08 * point.nanoseconds);
        }
    }
    std::string svg = fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
                                  "height=\"{1}\" font-family=\"sans-serif\" font-size=\"12\">\n"
                                  "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
                                  width, height);
    svg += frame(axes, ours);
    svg += curve(axes, logarithm, "c · log n", "stroke=\"#888\" stroke-dasharray=\"6 4\"", false);
    svg += curve(axes, embree, "Embree robust", "stroke=\"#c60\" fill=\"#c60\"", true);
    svg += curve(axes, ours, "ours", "stroke=\"#06c\" fill=\"#06c\"", true);
    return svg + "</svg>\n";
}

} // namespace vkbake::bench
