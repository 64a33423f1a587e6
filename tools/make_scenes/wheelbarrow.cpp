#include "make_scenes/objects.hpp"
#include "make_scenes/shapes.hpp"
#include "make_scenes/turn.hpp"

namespace vkbake::scenes {
namespace {

constexpr double wheel_radius = 0.20;
constexpr double wheel_at = 0.78;

// A rectangle with round corners in the plane of height `y`, centred on x = 0.
Ring tray_ring(double half_x, double low_z, double high_z, double y, double corner) {
    Ring ring;
    constexpr int steps = 4;
    const std::array<glm::dvec2, 4> centres{{{half_x - corner, high_z - corner},
                                             {-half_x + corner, high_z - corner},
                                             {-half_x + corner, low_z + corner},
                                             {half_x - corner, low_z + corner}}};
    for (std::size_t quarter = 0; quarter < 4; ++quarter) {
        for (int k = 0; k <= steps; ++k) {
            const glm::dvec2 c = on_circle((static_cast<double>(quarter) + static_cast<double>(k) / steps) / 4.0);
            ring.emplace_back(centres[quarter].x + corner * c.x, y, centres[quarter].y + corner * c.y);
        }
    }
    return ring;
}

Solid make_tray() {
    const double sheet = 0.006;
    // One radius throughout keeps the corners' quads flat, so the sheet's two sides cannot meet.
    const double corner = 0.09;
    return loft({tray_ring(0.17, -0.22, 0.34, 0.42, corner), tray_ring(0.19, -0.26, 0.38, 0.44, corner),
                 tray_ring(0.33, -0.42, 0.58, 0.70, corner), tray_ring(0.345, -0.435, 0.595, 0.705, corner),
                 tray_ring(0.345, -0.435, 0.595, 0.715, corner),
                 tray_ring(0.33 - sheet, -0.42 + sheet, 0.58 - sheet, 0.715, corner),
                 tray_ring(0.19 - sheet, -0.26 + sheet, 0.38 - sheet, 0.447, corner),
                 tray_ring(0.17 - sheet, -0.22 + sheet, 0.34 - sheet, 0.43, corner)},
                Paint::green_enamel);
}

void add_wheel(Model& barrow) {
    Model wheel{"wheel", {}};
    wheel.add(torus(0.155, 0.045, 24, 8, Paint::rubber));
    const double inside = 0.155 - 0.045 - 0.002;
    wheel.add(lathe({{inside - 0.008, -0.03}, {inside, -0.03}, {inside, 0.03}, {inside - 0.008, 0.03}}, 24,
                    Paint::yellow_enamel, Ends::joined));
    wheel.add(moved(cylinder(0.028, 0.09, 12, Paint::yellow_enamel, 0.005), glm::dvec3{0, -0.045, 0}));
    constexpr int spokes = 6;
    for (int k = 0; k < spokes; ++k) {
        const Solid spoke = tube({{0.030, 0, 0}, {inside - 0.011, 0, 0}}, 0.008, 6, {0, 1, 0}, Paint::yellow_enamel);
        wheel.add(moved(spoke, about_y(static_cast<double>(k) / spokes + 1.0 / 24.0)));
    }
    barrow.add(wheel, shifted({0, wheel_radius + contact_gap, wheel_at}) * about_z(0.25));
}

} // namespace

Model make_wheelbarrow() {
    Model barrow{"wheelbarrow", {}};
    barrow.add(make_tray());
    add_wheel(barrow);
    const double axle = wheel_radius + contact_gap;
    for (const double side : {-1.0, 1.0}) {
        const auto at = [&](double x, double y, double z) { return glm::dvec3{side * x, y, z}; };
        barrow.add(tube({at(0.085, axle, wheel_at + 0.04), at(0.085, axle, wheel_at - 0.04), at(0.10, 0.30, 0.50),
                         at(0.16, 0.385, 0.30), at(0.24, 0.395, 0.00), at(0.285, 0.42, -0.22), at(0.295, 0.52, -0.42),
                         at(0.295, 0.60, -0.60), at(0.295, 0.63, -0.72)},
                        0.018, 8, {1, 0.2, 0}, Paint::iron));
        barrow.add(tube({at(0.295, 0.631, -0.722), at(0.295, 0.645, -0.78), at(0.295, 0.66, -0.87)}, 0.022, 8,
                        {1, 0, 0}, Paint::rubber));
        // A leg with a foot, from below the rail.
        barrow.add(
            tube({at(0.262, 0.383, -0.15), at(0.262, 0.06, -0.20), at(0.262, 0.018, -0.19), at(0.262, 0.016, -0.12)},
                 0.014, 8, {1, 0, 0}, Paint::iron));
        // Between fork and hub.
        barrow.add(moved(moved(cylinder(0.012, 0.018, 10, Paint::iron), about_z(side > 0 ? -0.25 : 0.25)),
                         at(0.047, axle, wheel_at)));
    }
    barrow.add(tube({{-0.245, 0.22, -0.177}, {0.245, 0.22, -0.177}}, 0.010, 6, {0, 1, 0}, Paint::iron));
    refine_model_to(barrow, 0, 1700);
    return barrow;
}

} // namespace vkbake::scenes
