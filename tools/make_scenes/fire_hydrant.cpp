#include "make_scenes/objects.hpp"
#include "make_scenes/shapes.hpp"
#include "make_scenes/turn.hpp"

namespace vkbake::scenes {
namespace {

constexpr double body_radius = 0.105;

// Foot flange, barrel, upper flange, bonnet.
Profile body_profile() {
    return {{0.170, 0.0},   {0.175, 0.005},       {0.175, 0.030},       {0.170, 0.035},       {0.128, 0.035},
            {0.115, 0.050}, {body_radius, 0.075}, {body_radius, 0.240}, {body_radius, 0.420}, {body_radius, 0.500},
            {0.112, 0.520}, {0.118, 0.530},       {0.150, 0.533},       {0.155, 0.538},       {0.155, 0.560},
            {0.150, 0.565}, {0.126, 0.565},       {0.123, 0.580},       {0.120, 0.610},       {0.108, 0.645},
            {0.088, 0.672}, {0.062, 0.690},       {0.048, 0.696},       {0.046, 0.716},       {0.040, 0.722},
            {0.0, 0.722}};
}

Solid bolt(double radius, double height, int sides, Paint paint) {
    return lathe({{radius, 0.0}, {radius, height * 0.75}, {radius * 0.8, height}}, sides, paint);
}

void add_bolts(Model& hydrant, int count, double circle, double height) {
    for (int k = 0; k < count; ++k) {
        const glm::dvec2 c = on_circle((k + 0.5) / count) * circle;
        hydrant.add(moved(bolt(0.011, 0.014, 6, Paint::iron), glm::dvec3{c.x, height, c.y}));
    }
}

// A nozzle with its cap, along the direction `turns` about +Y, at a height.
void add_nozzle(Model& hydrant, double radius, double length, int segments, double height, double turns) {
    const double flange = radius * 1.32;
    const double end = body_radius + length;
    const glm::dmat4 place = shifted({0, height, 0}) * about_y(turns);
    const glm::dmat4 upright = about_x(0.25); // on_cylinder's body stands along Z
    const Profile neck{{radius, 0.0},
                       {radius, body_radius + 0.35 * length},
                       {radius * 0.94, body_radius + 0.45 * length},
                       {radius * 0.94, end - 0.012},
                       {radius, end - 0.006},
                       {radius, end}};
    hydrant.add(moved(on_cylinder(body_radius, 0.003, neck, segments, Paint::red_enamel), place * upright));
    const Profile cap{{flange - 0.004, 0.0},  {flange, 0.004},       {flange, 0.026},       {flange - 0.006, 0.032},
                      {radius * 0.95, 0.036}, {radius * 0.7, 0.046}, {radius * 0.42, 0.050}};
    const glm::dmat4 outward = place * shifted({end + contact_gap, 0, 0}) * about_z(-0.25);
    hydrant.add(moved(lathe(cap, segments, Paint::yellow_enamel), outward));
    const Profile nut{{0.017, 0.0}, {0.017, 0.020}, {0.013, 0.024}};
    hydrant.add(moved(lathe(nut, 5, Paint::iron), outward * shifted({0, 0.050 + contact_gap, 0})));
}

} // namespace

Model make_fire_hydrant() {
    Model hydrant{"fire hydrant", {}};
    const double slab = 0.06;
    hydrant.add(bevelled_box({-0.26, 0.0, -0.26}, {0.26, slab, 0.26}, 0.012, Paint::concrete));
    Model iron{"hydrant", {}};
    iron.add(lathe(body_profile(), 40, Paint::red_enamel));
    add_bolts(iron, 8, 0.152, 0.035 + contact_gap);
    add_bolts(iron, 8, 0.139, 0.565 + contact_gap);
    add_nozzle(iron, 0.068, 0.075, 26, 0.330, -0.25);
    add_nozzle(iron, 0.046, 0.070, 22, 0.400, 0.0);
    add_nozzle(iron, 0.046, 0.070, 22, 0.400, 0.5);
    iron.add(moved(lathe({{0.030, 0.0}, {0.032, 0.004}, {0.032, 0.010}, {0.030, 0.014}}, 20, Paint::red_enamel),
                   glm::dvec3{0, 0.722 + contact_gap, 0}));
    iron.add(moved(bolt(0.021, 0.035, 5, Paint::iron), glm::dvec3{0, 0.736 + 2 * contact_gap, 0}));
    hydrant.add(iron, shifted({0, slab + contact_gap, 0}));
    refine_model_to(hydrant, 0, 4634);
    return hydrant;
}

} // namespace vkbake::scenes
