// The storage room of the picture: three walls under open rafters, so that the sky alone lights every corner of it.
#include <cmath>

#include "make_scenes/furniture.hpp"
#include "make_scenes/objects.hpp"
#include "make_scenes/shapes.hpp"

namespace vkbake::scenes {
namespace {

// The room inside: x −2…2, y 0…2.4, z from −1.6 to the slab's end at 1.8, where there is no wall.
constexpr double half_width = 2.0;
constexpr double back = -1.6;
constexpr double front = 1.8;
constexpr double top = 2.4;
constexpr double wall = 0.2;

// In the left wall, above the eye: only sky shows in it.
constexpr glm::dvec2 sill_and_lintel{1.55, 2.15};
constexpr glm::dvec2 jambs{-0.65, 0.55};

bool between(double v, const glm::dvec2& range) { return v > range.x && v < range.y; }

Solid make_walls() {
    const double out = half_width + wall;
    const Cuts cuts{{-out, -half_width, half_width, out},
                    {-0.12, 0.0, sill_and_lintel.x, sill_and_lintel.y, top},
                    {back - wall, back, jambs.x, jambs.y, front}};
    const auto filled = [](const glm::dvec3& p) {
        const bool window = p.x < -half_width && between(p.y, sill_and_lintel) && between(p.z, jambs);
        return p.y < 0.0 || (!window && (std::fabs(p.x) > half_width || p.z < back));
    };
    return blocks(cuts, filled, [](const glm::dvec3& p, const glm::dvec3& normal) {
        if (p.y < 0.01) {
            return normal.y > 0.5 ? Paint::terracotta : Paint::concrete;
        }
        const bool inside = std::fabs(p.x) < half_width + 0.01 && p.z > back - 0.01 && p.z < front - 0.01;
        return inside ? Paint::cream_plaster : Paint::stone_warm;
    });
}

// One grid, so that its bars' joints do not coincide.
Solid make_window_frame() {
    const double g = contact_gap;
    const double bar = 0.05;
    const auto cuts_of = [&](const glm::dvec2& range) {
        const double middle = 0.5 * (range.x + range.y);
        return std::vector{range.x + g, range.x + bar, middle - bar / 2, middle + bar / 2, range.y - bar, range.y - g};
    };
    const Cuts cuts{{-half_width - 0.13, -half_width - 0.07}, cuts_of(sill_and_lintel), cuts_of(jambs)};
    const auto in_pane = [&](double v, const std::vector<double>& c) {
        return between(v, {c[1], c[2]}) || between(v, {c[3], c[4]});
    };
    const auto is_bar = [&](const glm::dvec3& p) { return !(in_pane(p.y, cuts.y) && in_pane(p.z, cuts.z)); };
    return blocks(cuts, is_bar, [](const glm::dvec3&, const glm::dvec3&) { return Paint::green_wood; });
}

// Rafters lie across on the side walls; what they might carry is left out for the light's sake.
void add_rafters(Model& room) {
    const double g = contact_gap;
    const double over = half_width + wall + 0.12;
    for (const double z : {-1.7, -0.85, 0.0, 0.85, 1.65}) {
        room.add(grained(bevelled_box({-over, top + g, z - 0.05}, {over, top + 0.14, z + 0.05}, 0.008, Paint::walnut),
                         {1, 0, 0}));
    }
}

} // namespace

Model make_store() {
    Model room{"storage room", {}};
    room.add(make_walls());
    room.add(make_window_frame());
    add_rafters(room);
    const double g = contact_gap;
    room.add(make_shelf(1.7, 0.42, 1.9, 4, Paint::pine), shifted({-0.50, 0, back + g + 0.21}));
    room.add(make_crate({0.62, 0.55, 0.5}, Paint::oak), shifted({half_width - g - 0.31, 0, back + g + 0.25}));
    room.add(make_chest({0.75, 0.42, 0.45}, Paint::blue_wood),
             shifted({half_width - g - 0.24, 0, -0.35}) * about_y(0.25));
    return room;
}

} // namespace vkbake::scenes
