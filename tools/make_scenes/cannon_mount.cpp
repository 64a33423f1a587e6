// A ship's gun carriage: two stepped cheeks on two axles with four small wheels.
#include "make_scenes/objects.hpp"
#include "make_scenes/shapes.hpp"
#include "make_scenes/turn.hpp"

namespace vkbake::scenes {
namespace {

constexpr double cheek_inside = 0.20;
constexpr double cheek_outside = 0.275;
constexpr double axle_height = 0.15;
constexpr double front_axle = 0.42;
constexpr double rear_axle = -0.52;
constexpr double cheek_base = 0.215;

// Seen from the side; x is the carriage's z, y its height. The trunnion lies in a round notch on top.
std::vector<glm::dvec2> cheek_outline() {
    std::vector<glm::dvec2> outline{{-0.80, cheek_base}, {0.60, cheek_base}, {0.60, cannon_on_mount.y}};
    constexpr int steps = 6;
    for (int k = 0; k <= steps; ++k) {
        const glm::dvec2 c = on_circle(-0.5 * k / steps);
        const double radius = trunnion_radius + 0.004;
        outline.emplace_back(cannon_on_mount.z + radius * c.x, cannon_on_mount.y + radius * c.y);
    }
    for (const glm::dvec2& step :
         {glm::dvec2{0.10, 0.62}, glm::dvec2{0.10, 0.53}, glm::dvec2{-0.18, 0.53}, glm::dvec2{-0.18, 0.44},
          glm::dvec2{-0.46, 0.44}, glm::dvec2{-0.46, 0.35}, glm::dvec2{-0.80, 0.35}}) {
        outline.push_back(step);
    }
    return outline;
}

void add_wheels(Model& mount, double axle) {
    constexpr double radius = axle_height;
    for (const double side : {-1.0, 1.0}) {
        Solid wheel = cylinder(radius, 0.085, 12, Paint::walnut, 0.012);
        const double inner = 0.31;
        wheel = moved(std::move(wheel), about_z(-0.25));
        const double shift = side > 0 ? inner : -inner - 0.085;
        mount.add(grained(moved(std::move(wheel), glm::dvec3{shift, axle_height, axle}), {0, 1, 0}));
        Solid hub = moved(cylinder(0.035, 0.03, 6, Paint::iron), about_z(-0.25));
        const double hub_shift = side > 0 ? inner + 0.085 + contact_gap : -inner - 0.085 - contact_gap - 0.03;
        mount.add(moved(std::move(hub), glm::dvec3{hub_shift, axle_height, axle}));
    }
}

} // namespace

Model make_cannon_mount() {
    Model mount{"cannon mount", {}};
    const double bed_top = cheek_base + 0.09;
    mount.add(grained(bevelled_box({-cheek_inside + contact_gap, cheek_base, -0.76},
                                   {cheek_inside - contact_gap, bed_top, 0.50}, 0.012, Paint::oak),
                      {0, 0, 1}));
    for (const double low : {-cheek_outside, cheek_inside}) {
        // The outline's x becomes the carriage's z.
        Solid cheek = extrude(cheek_outline(), 0.0, cheek_outside - cheek_inside, Paint::oak);
        cheek = moved(std::move(cheek), about_y(-0.25));
        mount.add(grained(moved(std::move(cheek), glm::dvec3{low + cheek_outside - cheek_inside, 0, 0}), {0, 0, 1}));
    }
    for (const double axle : {front_axle, rear_axle}) {
        mount.add(
            grained(bevelled_box({-0.31 + contact_gap, axle_height - 0.06, axle - 0.06},
                                 {0.31 - contact_gap, cheek_base - contact_gap, axle + 0.06}, 0.01, Paint::walnut),
                    {1, 0, 0}));
        add_wheels(mount, axle);
    }
    // The quoin, a wedge that the breech rests on, with its handle.
    const std::vector<glm::dvec2> wedge{{-0.62, bed_top + contact_gap},
                                        {-0.22, bed_top + contact_gap},
                                        {-0.22, bed_top + 0.03},
                                        {-0.62, bed_top + 0.11}};
    Solid quoin = moved(extrude(wedge, -0.09, 0.09, Paint::pine), about_y(-0.25));
    mount.add(grained(std::move(quoin), {0, 0, 1}));
    mount.add(tube({{0, bed_top + 0.05, -0.62 - contact_gap}, {0, bed_top + 0.05, -0.76}}, 0.018, 6, {1, 0, 0},
                   Paint::walnut));
    refine_model_to(mount, 0, 766);
    return mount;
}

} // namespace vkbake::scenes
