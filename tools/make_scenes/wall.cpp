#include <cmath>

#include "make_scenes/objects.hpp"
#include "make_scenes/shapes.hpp"
#include "make_scenes/textures.hpp"

namespace vkbake::scenes {
namespace {

constexpr double course = 0.085; // a brick's height with its joint
constexpr double module = 0.26;  // a brick's length with its joint
constexpr double joint = 0.012;
constexpr int courses = 20;
constexpr int bricks = 10; // in a course
constexpr double width = bricks * module;
constexpr double height = courses * course;

void add_brick(Model& wall, double low_x, double high_x, int row, std::uint32_t number) {
    const double bump = 0.006 * random_of(number);
    const double hue = random_of(number + 1000);
    const Paint paint = hue < 0.2 ? Paint::brick_dark : (hue < 0.45 ? Paint::brick_pale : Paint::brick);
    wall.add(front_bevelled_box({low_x + joint / 2, row * course + joint / 2, contact_gap},
                                {high_x - joint / 2, (row + 1) * course - joint / 2, 0.018 + bump}, 0.005, paint));
}

// Running bond: every other course begins with half a brick.
void add_bricks(Model& wall) {
    std::uint32_t number = 0;
    for (int row = 0; row < courses; ++row) {
        const bool shifted_row = row % 2 == 1;
        double low = -width / 2;
        while (low < width / 2 - 0.01) {
            const bool half = shifted_row && (low == -width / 2 || low > width / 2 - module);
            const double high = low + (half ? module / 2 : module);
            add_brick(wall, low, high, row, number++);
            low = high;
        }
    }
}

void add_pier(Model& wall, double side) {
    const double inner = width / 2 + contact_gap;
    constexpr int stones = 5;
    constexpr double stone = 0.35;
    for (int k = 0; k < stones; ++k) {
        const double reach = k % 2 == 0 ? 0.0 : 0.012;
        const double outer = inner + 0.30 - reach;
        const glm::dvec3 low{side > 0 ? inner : -outer, k * stone + (k > 0 ? contact_gap : 0.0), -0.19 + reach};
        const glm::dvec3 high{side > 0 ? outer : -inner, (k + 1) * stone, 0.08 - reach};
        wall.add(bevelled_box(low, high, 0.012, k % 2 == 0 ? Paint::stone_warm : Paint::stone));
    }
    const double top = stones * stone + contact_gap;
    const glm::dvec3 low{side > 0 ? inner - 0.02 : -inner - 0.33, top, -0.22};
    const glm::dvec3 high{side > 0 ? inner + 0.33 : -inner + 0.02, top + 0.08, 0.11};
    wall.add(bevelled_box(low, high, 0.02, Paint::stone));
}

// Goes on into the ground, so it has no underside: that makes an odd number of triangles possible.
Solid open_core() {
    Solid core = box({-width / 2, 0.0, -0.12}, {width / 2, height + 0.012, 0.0}, Paint::mortar);
    std::erase_if(core.triangles, [&](const Triangle& t) {
        return core.points[t.corners[0]].y == 0.0 && core.points[t.corners[1]].y == 0.0 &&
               core.points[t.corners[2]].y == 0.0;
    });
    return core;
}

} // namespace

Model make_wall() {
    Model wall{"wall", {}};
    wall.add(open_core());
    add_bricks(wall);
    add_pier(wall, -1.0);
    add_pier(wall, 1.0);
    constexpr int copings = 5;
    for (int k = 0; k < copings; ++k) {
        const double low = -width / 2 + k * width / copings;
        const double base = height + 0.012 + contact_gap;
        const double ends = 0.002;
        wall.add(bevelled_box({low + ends, base, -0.16}, {low + width / copings - ends, base + 0.035, 0.05}, 0.01,
                              Paint::stone_warm));
    }
    refine_model_to(wall, 0, 4999);
    return wall;
}

} // namespace vkbake::scenes
