#include <cmath>

#include "make_scenes/furniture.hpp"
#include "make_scenes/objects.hpp"
#include "make_scenes/shapes.hpp"

namespace vkbake::scenes {
namespace {

// The room inside: x −2…2, y 0…2.7, z −1.6…1.6; walls 0.2 m thick, a roof of 0.15 m on top, a slab of 0.12 m under it.
constexpr double half_width = 2.0;
constexpr double half_depth = 1.6;
constexpr double ceiling = 2.7;
constexpr double wall = 0.2;

bool between(double v, double low, double high) { return v > low && v < high; }

bool is_masonry(const glm::dvec3& p) {
    if (p.y < 0.0) {
        return true;
    }
    if (p.y > ceiling) { // the skylight
        return !(between(p.x, -0.9, 1.4) && between(p.z, -0.9, 0.3));
    }
    if (std::fabs(p.x) < half_width && std::fabs(p.z) < half_depth) {
        return false;
    }
    const bool front_opening = p.z > half_depth && std::fabs(p.x) < 1.6 && p.y < 2.3;
    const bool window = p.x < -half_width && between(p.z, -0.5, 0.7) && between(p.y, 1.0, 2.0);
    return !front_opening && !window;
}

Paint masonry_paint(const glm::dvec3& p, const glm::dvec3& normal) {
    const bool inside =
        std::fabs(p.x) < half_width + 0.01 && std::fabs(p.z) < half_depth + 0.01 && between(p.y, -0.01, ceiling + 0.01);
    if (p.y < 0.01 && normal.y > 0.5) {
        return Paint::terracotta;
    }
    if (inside) {
        return normal.y < -0.5 ? Paint::plaster : Paint::cream_plaster;
    }
    return p.y > ceiling ? Paint::plaster : Paint::stone_warm;
}

Solid make_shell() {
    const double out_x = half_width + wall;
    const double out_z = half_depth + wall;
    const Cuts cuts{{-out_x, -half_width, -1.6, -0.9, 1.4, 1.6, half_width, out_x},
                    {-0.12, 0.0, 1.0, 2.0, 2.3, ceiling, ceiling + 0.15},
                    {-out_z, -half_depth, -0.9, -0.5, 0.3, 0.7, half_depth, out_z}};
    return blocks(cuts, is_masonry, masonry_paint);
}

void add_window_frame(Model& room) {
    // In the left wall's opening: z −0.5…0.7, y 1…2, a hair inside it; cut from one grid so that no joints coincide.
    const double g = contact_gap;
    const double bar = 0.05;
    const Cuts cuts{{-2.13, -2.07},
                    {1.0 + g, 1.0 + bar, 1.5 - bar / 2, 1.5 + bar / 2, 2.0 - bar, 2.0 - g},
                    {-0.5 + g, -0.5 + bar, 0.1 - bar / 2, 0.1 + bar / 2, 0.7 - bar, 0.7 - g}};
    const auto is_bar = [&](const glm::dvec3& p) {
        const bool pane_y = between(p.y, 1.0 + bar, 1.5 - bar / 2) || between(p.y, 1.5 + bar / 2, 2.0 - bar);
        const bool pane_z = between(p.z, -0.5 + bar, 0.1 - bar / 2) || between(p.z, 0.1 + bar / 2, 0.7 - bar);
        return !(pane_y && pane_z);
    };
    room.add(blocks(cuts, is_bar, [](const glm::dvec3&, const glm::dvec3&) { return Paint::green_wood; }));
}

} // namespace

Model make_storage_room() {
    Model room{"storage room", {}};
    room.add(make_shell());
    add_window_frame(room);
    const double g = contact_gap;
    for (const double z : {-1.15, 0.55, 1.25}) {
        room.add(grained(bevelled_box({-half_width + g, ceiling - 0.16, z - 0.06},
                                      {half_width - g, ceiling - g, z + 0.06}, 0.01, Paint::walnut),
                         {1, 0, 0}));
    }
    room.add(make_shelf(1.7, 0.42, 1.9, 4, Paint::pine), shifted({-0.50, 0, -half_depth + g + 0.21}));
    room.add(make_crate({0.62, 0.55, 0.5}, Paint::oak), shifted({half_width - g - 0.31, 0, -half_depth + g + 0.25}));
    room.add(make_chest({0.75, 0.42, 0.45}, Paint::blue_wood),
             shifted({half_width - g - 0.24, 0, -0.35}) * about_y(0.25));
    refine_model_to(room, 0, 1500);
    return room;
}

} // namespace vkbake::scenes
