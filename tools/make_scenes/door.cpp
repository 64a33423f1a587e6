// A plank door with iron straps and rivets in a frame of dressed stone.
#include "make_scenes/objects.hpp"
#include "make_scenes/shapes.hpp"

namespace vkbake::scenes {
namespace {

constexpr double width = 1.05;
constexpr double height = 2.15;
constexpr double thickness = 0.06;

Solid rivet(double radius) {
    return lathe({{radius, 0.0}, {radius * 0.92, radius * 0.35}, {radius * 0.6, radius * 0.62}, {0.0, radius * 0.75}},
                 10, Paint::iron);
}

void add_planks(Model& door) {
    constexpr int planks = 7;
    constexpr double plank = width / planks;
    for (int k = 0; k < planks; ++k) {
        const double low = -width / 2 + k * plank;
        const Paint paint = k % 3 == 1 ? Paint::walnut : Paint::oak;
        door.add(bevelled_box({low + 0.001, 0.012, 0.0}, {low + plank - 0.001, height, thickness}, 0.006, paint));
    }
}

// Rivets stand in a row on a face of height z, towards +Z.
void add_rivet(Model& door, double x, double y, double z, double radius) {
    door.add(moved(rivet(radius), shifted({x, y, z + contact_gap}) * about_x(0.25)));
}

void add_strap(Model& door, double y) {
    const double z = thickness + contact_gap;
    const double left = -width / 2 + 0.045;
    const double tip = width / 2 - 0.10;
    const std::vector<glm::dvec2> outline{
        {left, y - 0.035},       {tip - 0.16, y - 0.028}, {tip - 0.13, y - 0.055}, {tip - 0.06, y - 0.035}, {tip, y},
        {tip - 0.06, y + 0.035}, {tip - 0.13, y + 0.055}, {tip - 0.16, y + 0.028}, {left, y + 0.035}};
    door.add(extrude(outline, z, z + 0.008, Paint::iron));
    constexpr int rivets = 8;
    for (int k = 0; k < rivets; ++k) {
        add_rivet(door, left + 0.05 + k * 0.108, y, z + 0.008, 0.014);
    }
    // The hinge's knuckle, beside the leaf's edge.
    door.add(
        moved(cylinder(0.018, 0.11, 14, Paint::iron, 0.003), glm::dvec3{left - 0.020, y - 0.055, thickness + 0.021}));
}

void add_border_rivets(Model& door) {
    constexpr int columns = 7;
    for (const double y : {0.10, 0.61, 0.80, 1.42, 2.06}) {
        for (int k = 0; k < columns; ++k) {
            add_rivet(door, (k - 3) * width / columns, y, thickness, 0.017);
        }
    }
}

void add_handle(Model& door) {
    const double x = width / 2 - 0.14;
    const double y = 1.32;
    const glm::dmat4 face = shifted({x, y, thickness + contact_gap}) * about_x(0.25);
    door.add(moved(
        lathe({{0.055, 0.0}, {0.055, 0.004}, {0.048, 0.010}, {0.030, 0.012}, {0.022, 0.020}}, 20, Paint::iron), face));
    // The ring hangs in front of the boss.
    door.add(
        moved(torus(0.062, 0.008, 32, 10, Paint::iron), shifted({x, y - 0.052, thickness + 0.034}) * about_x(0.25)));
    door.add(
        box({x - 0.035, y - 0.24, thickness + contact_gap}, {x + 0.035, y - 0.14, thickness + 0.007}, Paint::iron));
}

void add_frame(Model& door) {
    constexpr int stones = 6;
    const double stone = (height + 0.02) / stones;
    for (const double side : {-1.0, 1.0}) {
        for (int k = 0; k < stones; ++k) {
            const double inner = width / 2 + 0.008;
            const double outer = inner + (k % 2 == 0 ? 0.30 : 0.22);
            const double base = k * stone + (k > 0 ? contact_gap : 0.0);
            door.add(bevelled_box({side > 0 ? inner : -outer, base, -0.14},
                                  {side > 0 ? outer : -inner, (k + 1) * stone, 0.13}, 0.012,
                                  k % 2 == 0 ? Paint::stone_warm : Paint::stone));
        }
    }
    // The lintel: wedge-shaped stones.
    constexpr int wedges = 5;
    const double base = height + 0.02 + contact_gap;
    const double span = width / 2 + 0.308;
    for (int k = 0; k < wedges; ++k) {
        const auto at = [&](int i, double lean) { return -span + 2 * span * i / wedges + lean * (i - 2.5) * 0.02; };
        const double g = contact_gap;
        const double top = base + (k == 2 ? 0.36 : 0.30);
        const double out = k == 2 ? 0.15 : 0.13;
        door.add(extrude({{at(k, 0) + g, base}, {at(k + 1, 0) - g, base}, {at(k + 1, 1) - g, top}, {at(k, 1) + g, top}},
                         -0.14, out, k == 2 ? Paint::stone : Paint::stone_warm));
    }
    door.add(bevelled_box({-width / 2, -0.06, -0.14}, {width / 2, 0.0, 0.22}, 0.01, Paint::stone));
}

// Two ledges and a brace hold the planks together behind.
void add_back(Model& door) {
    for (const double y : {0.35, 1.75}) {
        door.add(grained(bevelled_box({-width / 2 + 0.04, y - 0.07, -0.035}, {width / 2 - 0.04, y + 0.07, -contact_gap},
                                      0.006, Paint::walnut),
                         {1, 0, 0}));
    }
    const std::vector<glm::dvec2> brace{{-0.46, 0.43}, {-0.34, 0.43}, {0.46, 1.67}, {0.34, 1.67}};
    door.add(grained(extrude(brace, -0.035, -contact_gap, Paint::walnut), {0.8, 1.24, 0}));
}

} // namespace

Model make_door() {
    Model door{"door", {}};
    add_planks(door);
    add_back(door);
    for (const double y : {0.42, 1.00, 1.76}) {
        add_strap(door, y);
    }
    add_border_rivets(door);
    add_handle(door);
    add_frame(door);
    refine_model_to(door, 0, 5772);
    return door;
}

} // namespace vkbake::scenes
