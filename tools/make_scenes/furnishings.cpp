#include "make_scenes/furnishings.hpp"

#include <array>

#include "make_scenes/furniture.hpp"
#include "make_scenes/shapes.hpp"
#include "make_scenes/soft_goods.hpp"
#include "make_scenes/textures.hpp"
#include "make_scenes/turn.hpp"

namespace vkbake::scenes {
namespace {

constexpr double low = contact_gap;

constexpr std::array<Paint, 8> covers{Paint::red_enamel, Paint::blue_enamel, Paint::green_enamel, Paint::walnut,
                                      Paint::linen,      Paint::iron,        Paint::terracotta,   Paint::yellow_enamel};

// Pages between covers and a spine, upright, the spine towards +Z; its left side at x = 0.
Model make_book(double thickness, double height, double depth, Paint cover) {
    Model book{"book", {}};
    const double board = 0.0025;
    book.add(box({board + 0.0005, low + 0.003, 0.004},
                 {thickness - board - 0.0005, height - 0.003, depth - board - 0.0005}, Paint::linen));
    // Seen from above: a U around the pages.
    Solid shell = extrude({{0, 0},
                           {board, 0},
                           {board, depth - board},
                           {thickness - board, depth - board},
                           {thickness - board, 0},
                           {thickness, 0},
                           {thickness, depth - 0.004},
                           {thickness - 0.004, depth},
                           {0.004, depth},
                           {0, depth - 0.004}},
                          0.0, height - low, cover);
    shell = moved(std::move(shell), about_x(0.25)); // (x, y, z) → (x, −z, y)
    book.add(moved(std::move(shell), glm::dvec3(0, height, 0)));
    return book;
}

} // namespace

Model make_chair() {
    Model chair{"chair", {}};
    for (const double x : {-0.19, 0.19}) {
        for (const double z : {-0.19, 0.19}) {
            chair.add(lathe(
                {{0.014, low}, {0.018, low + 0.05}, {0.022, low + 0.25}, {0.024, low + 0.40}, {0.020, low + 0.43}}, 14,
                Paint::oak));
            chair.solids.back() = moved(chair.solids.back(), glm::dvec3(x, 0, z));
        }
    }
    chair.add(moved(bevelled_box({-0.22, 0.432, -0.22}, {0.22, 0.455, 0.22}, 0.008, Paint::oak), glm::dvec3(0.0)));
    chair.add(make_cushion({0.40, 0.05, 0.40}, Paint::linen), shifted({0, 0.455, 0}));
    for (int k = 0; k < 6; ++k) {
        const double x = -0.18 + 0.072 * k;
        chair.add(tube({{x, 0.457, -0.20},
                        {x, 0.55, -0.205},
                        {x * 1.02, 0.64, -0.215},
                        {x * 1.04, 0.73, -0.23},
                        {x * 1.06, 0.82, -0.25},
                        {x * 1.08, 0.90, -0.275}},
                       0.010, 10, {1, 0, 0}, Paint::oak));
    }
    chair.add(bevelled_box({-0.23, 0.902, -0.30}, {0.23, 0.96, -0.265}, 0.008, Paint::oak));
    return chair;
}

Model make_table(const glm::dvec3& size, Paint paint) {
    Model table{"table", {}};
    const glm::dvec3 half = 0.5 * size;
    table.add(
        grained(bevelled_box({-half.x, size.y - 0.035, -half.z}, {half.x, size.y, half.z}, 0.006, paint), {1, 0, 0}));
    for (const double x : {-half.x + 0.08, half.x - 0.08}) {
        for (const double z : {-half.z + 0.08, half.z - 0.08}) {
            table.add(moved(lathe({{0.020, low},
                                   {0.026, low + 0.1},
                                   {0.034, 0.5 * size.y},
                                   {0.030, 0.8 * size.y},
                                   {0.040, size.y - 0.036}},
                                  18, paint),
                            glm::dvec3(x, 0, z)));
        }
    }
    return table;
}

Model make_bookcase(double width, std::uint32_t number) {
    constexpr double depth = 0.30;
    constexpr double height = 2.1;
    constexpr int boards = 5;
    Model bookcase = make_shelf(width, depth, height, boards, Paint::pine);
    bookcase.name = "bookcase";
    bookcase.add(box({-0.5 * width + 0.052, 0.05, -0.5 * depth - 0.014},
                     {0.5 * width - 0.052, height, -0.5 * depth - 0.002}, Paint::pine));
    std::uint32_t draw = number * 1000;
    for (int k = 0; k < boards; ++k) {
        const double top = 0.21 + (height - 0.25) * k / boards;
        double x = -0.5 * width + 0.06;
        while (x < 0.5 * width - 0.12) {
            const double thickness = 0.018 + 0.035 * random_of(draw++);
            const double tall = 0.19 + 0.11 * random_of(draw++);
            const double deep = 0.14 + 0.08 * random_of(draw++);
            const double turn = random_of(draw++) < 0.12 ? -0.015 : 0.0; // one in a while leans a little
            bookcase.add(make_book(thickness, tall, deep, covers[static_cast<std::size_t>(random_of(draw) * 7.99)]),
                         shifted({x, top + low, 0.13 - deep}) * about_z(turn));
            ++draw;
            x += thickness + 0.002 + (turn != 0.0 ? 0.03 : 0.0);
        }
    }
    return bookcase;
}

Model make_sofa() {
    Model sofa{"sofa", {}};
    const Paint cloth = Paint::blue_enamel;
    sofa.add(bevelled_box({-1.05, 0.10, -0.42}, {1.05, 0.26, 0.42}, 0.02, cloth));
    sofa.add(bevelled_box({-1.05, 0.262, -0.42}, {1.05, 0.80, -0.26}, 0.03, cloth));
    for (const double x : {-1.22, 1.06}) {
        sofa.add(bevelled_box({x, 0.10, -0.42}, {x + 0.16, 0.58, 0.42}, 0.03, cloth));
    }
    for (const double x : {-1.1, 1.1}) {
        for (const double z : {-0.34, 0.34}) {
            sofa.add(moved(cylinder(0.025, 0.097, 16, Paint::walnut, 0.004), glm::dvec3(x, low, z)));
        }
    }
    for (int k = 0; k < 3; ++k) {
        const double x = -0.7 + 0.7 * k;
        sofa.add(make_cushion({0.68, 0.16, 0.66}, cloth), shifted({x, 0.262, 0.08}));
        sofa.add(make_cushion({0.64, 0.16, 0.44}, cloth), shifted({x, 0.66, -0.24}) * about_x(0.22));
    }
    const std::array<Paint, 4> small{Paint::linen, Paint::terracotta, Paint::straw, Paint::linen};
    for (std::size_t k = 0; k < small.size(); ++k) {
        sofa.add(make_cushion({0.40, 0.13, 0.40}, small[k]),
                 shifted({-0.85 + 0.55 * static_cast<double>(k), 0.56, 0.02}) * about_x(0.18) * about_y(0.03));
    }
    return sofa;
}

Model make_bed(double width) {
    Model bed{"bed", {}};
    const double half = 0.5 * width;
    bed.add(bevelled_box({-half, 0.12, -1.02}, {half, 0.30, 1.02}, 0.015, Paint::walnut));
    bed.add(bevelled_box({-half, 0.05, -1.08}, {half, 1.0, -1.03}, 0.015, Paint::walnut));
    bed.add(bevelled_box({-half + 0.02, 0.302, -1.0}, {half - 0.02, 0.50, 1.0}, 0.05, Paint::white));
    bed.add(make_blanket(width + 0.02, 1.5, 0.25, Paint::green_enamel), shifted({0, 0.51, 0.27}));
    for (const double x : {-0.25 * width, 0.25 * width}) {
        bed.add(make_cushion({0.45 * width, 0.16, 0.45}, Paint::white), shifted({x, 0.50, -0.75}));
    }
    return bed;
}

Model make_floor_lamp() {
    Model lamp{"floor lamp", {}};
    lamp.add(lathe({{0.0, low},
                    {0.15, low},
                    {0.15, low + 0.012},
                    {0.03, low + 0.03},
                    {0.012, low + 0.06},
                    {0.012, 1.40},
                    {0.0, 1.40}},
                   28, Paint::bronze));
    lamp.add(moved(sphere(0.05, 20, 14, Paint::white), glm::dvec3(0, 1.455, 0)));
    Profile shade;
    for (const double inset : {0.0, 0.004}) {
        for (int k = 0; k <= 8; ++k) {
            const double share = inset > 0.0 ? 1.0 - k / 8.0 : k / 8.0;
            shade.emplace_back(0.22 - 0.10 * share - inset, 1.36 + 0.28 * share);
        }
    }
    lamp.add(lathe(shade, 40, Paint::linen, Ends::joined));
    return lamp;
}

Model make_chandelier(int arms) {
    Model chandelier{"chandelier", {}};
    chandelier.add(lathe({{0.0, -0.55},
                          {0.03, -0.53},
                          {0.05, -0.48},
                          {0.02, -0.42},
                          {0.008, -0.38},
                          {0.008, -0.02},
                          {0.05, -0.012},
                          {0.05, -0.002},
                          {0.0, -0.002}},
                         24, Paint::bronze));
    for (int k = 0; k < arms; ++k) {
        Model arm{"arm", {}};
        arm.add(tube({{0.055, -0.48, 0},
                      {0.12, -0.52, 0},
                      {0.20, -0.53, 0},
                      {0.28, -0.50, 0},
                      {0.32, -0.45, 0},
                      {0.325, -0.40, 0}},
                     0.007, 10, {0, 0, 1}, Paint::bronze));
        arm.add(moved(lathe({{0.0, 0.0}, {0.03, 0.005}, {0.035, 0.015}, {0.012, 0.02}, {0.012, 0.08}, {0.0, 0.08}}, 18,
                            Paint::white),
                      glm::dvec3(0.325, -0.395, 0)));
        arm.add(moved(sphere(0.028, 16, 12, Paint::white), glm::dvec3(0.325, -0.285, 0)));
        for (int drop = 0; drop < 3; ++drop) { // glass drops below the arm
            arm.add(moved(lathe({{0.0, -0.03}, {0.006, -0.015}, {0.004, -0.003}, {0.0, 0.0}}, 8, Paint::white),
                          glm::dvec3(0.12 + 0.08 * drop, -0.545, 0)));
        }
        chandelier.add(arm, about_y(static_cast<double>(k) / arms));
    }
    return chandelier;
}

Model make_cupboards(int count, double height) {
    Model row{"cupboards", {}};
    const double left = -0.3 * count;
    row.add(grained(
        bevelled_box({left - 0.01, height + low, -0.31}, {-left + 0.01, height + 0.04, 0.32}, 0.006, Paint::oak),
        {1, 0, 0}));
    for (int k = 0; k < count; ++k) {
        const double x = left + 0.6 * k;
        row.add(box({x + 0.002, 0.08, -0.30}, {x + 0.598, height, 0.28}, Paint::white));
        for (int drawer = 0; drawer < 3; ++drawer) {
            const double y = 0.10 + (height - 0.12) * drawer / 3.0;
            row.add(bevelled_box({x + 0.008, y, 0.282}, {x + 0.592, y + (height - 0.12) / 3.0 - 0.008, 0.302}, 0.004,
                                 Paint::blue_wood));
            row.add(moved(sphere(0.014, 12, 8, Paint::bronze),
                          glm::dvec3(x + 0.3, y + 0.5 * (height - 0.12) / 3.0, 0.318)));
        }
    }
    return row;
}

Model make_bathtub() {
    Model tub{"bathtub", {}};
    std::vector<Ring> rings;
    const auto oval = [&](double x, double z, double y) {
        Ring ring;
        for (int k = 0; k < 48; ++k) {
            const glm::dvec2 c = on_circle(k / 48.0);
            ring.emplace_back(x * c.x, y, -z * c.y);
        }
        rings.push_back(std::move(ring));
    };
    oval(0.60, 0.25, low);
    oval(0.74, 0.33, 0.15);
    oval(0.82, 0.38, 0.45);
    oval(0.85, 0.41, 0.57);
    oval(0.86, 0.42, 0.585);
    oval(0.84, 0.40, 0.595);
    oval(0.80, 0.36, 0.57);
    oval(0.77, 0.33, 0.40);
    oval(0.70, 0.29, 0.16);
    oval(0.56, 0.21, 0.10);
    tub.add(loft(rings, Paint::white));
    return tub;
}

} // namespace vkbake::scenes
