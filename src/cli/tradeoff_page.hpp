// What `vkbake tradeoff` shows: table, plot, page.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "vkbake/compare.hpp"
#include "vkbake/lightmap.hpp"

namespace vkbake::cli {

/// A square of one light map's texels.
struct DetailPlace {
    std::size_t map = 0;
    int x = 0;
    int y = 0;
    int side = 0;
    double white = 1.0; ///< the luminance that is shown white
};

/// Where the light changes most: the square in which the reference's luminance varies most among covered texels.
[[nodiscard]] DetailPlace choose_detail(const Bake& reference);

/// The detail as a BMP file, base64: what every browser shows and needs no library. Left the values, right the error
/// against the reference, ten times as bright.
[[nodiscard]] std::string detail_picture(const Bake& bake, const Bake& reference, const DetailPlace& place);

struct TradePoint {
    std::string flags;
    bool adaptive = false;
    bool denoised = false;
    BakeError error;
    double color_difference = 0.0; ///< of a picture drawn with it from one drawn with the reference
    double rays_a_texel = 0.0;
    double seconds = 0.0; ///< tracing and denoising
    bool on_frontier = false;
    std::string picture;
};

struct Trade {
    std::string scene;
    std::string sky;
    int size = 0;
    std::vector<TradePoint> points;
    std::string reference_picture;
    std::size_t recommended = 0;
};

/// What the plot stands on: white, for paper and for any page; or nothing, with the page's own colours.
enum class PlotGround { white, page };

constexpr int plot_width = 720;
constexpr int plot_height = 420;

[[nodiscard]] std::string trade_table(const Trade& trade); ///< for a terminal
[[nodiscard]] std::string trade_json(const Trade& trade);
[[nodiscard]] std::string trade_plot(const Trade& trade, PlotGround ground); ///< SVG: error against time, logarithmic
[[nodiscard]] std::string trade_page(const Trade& trade);                    ///< HTML that needs nothing but itself

} // namespace vkbake::cli
