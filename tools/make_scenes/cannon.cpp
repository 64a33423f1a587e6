#include "make_scenes/objects.hpp"
#include "make_scenes/shapes.hpp"

namespace vkbake::scenes {
namespace {

// From the knob behind the breech along the barrel to the muzzle, and back down the bore.
const Profile& barrel_profile() {
    static const Profile profile{{0.0, -0.98},    {0.035, -0.97}, {0.058, -0.93}, {0.05, -0.885},  {0.032, -0.86},
                                 {0.075, -0.835}, {0.165, -0.80}, {0.185, -0.79}, {0.185, -0.74},  {0.168, -0.725},
                                 {0.160, -0.30},  {0.168, -0.29}, {0.168, -0.25}, {0.145, -0.235}, {0.145, 0.13},
                                 {0.153, 0.14},   {0.153, 0.18},  {0.132, 0.195}, {0.100, 0.93},   {0.112, 0.95},
                                 {0.138, 1.04},   {0.138, 1.07},  {0.112, 1.085}, {0.066, 1.085},  {0.062, 0.45},
                                 {0.0, 0.43}};
    return profile;
}

constexpr double trunnion_body = 0.145; // the barrel's radius where the trunnions sit

} // namespace

Model make_cannon() {
    Model cannon{"cannon", {}};
    constexpr int around = 22;
    cannon.add(moved(lathe(barrel_profile(), around, Paint::bronze), about_x(0.25)));
    for (const double turns : {0.0, 0.5}) {
        const Profile trunnion{{trunnion_radius, 0.0}, {trunnion_radius, 0.265}, {trunnion_radius - 0.008, 0.273}};
        cannon.add(moved(on_cylinder(trunnion_body, 0.002, trunnion, 14, Paint::bronze), about_y(turns)));
    }
    // The two dolphins: handles to lift the barrel by, a little off its surface.
    for (const double side : {-1.0, 1.0}) {
        const double x = side * 0.055;
        const double foot = 0.158;
        cannon.add(tube({{x, foot, -0.14},
                         {x, foot + 0.05, -0.11},
                         {x, foot + 0.06, -0.05},
                         {x, foot + 0.05, 0.01},
                         {x, foot, 0.04}},
                        0.014, 6, {1, 0, 0}, Paint::bronze));
    }
    // The vent's raised field, on the reinforce behind.
    cannon.add(moved(front_bevelled_box({-0.022, -0.04, 0.171}, {0.022, 0.04, 0.185}, 0.005, Paint::bronze),
                     shifted({0.0, 0.0, -0.64}) * about_x(-0.25)));
    refine_model_to(cannon, cannon.solids.size() - 1, 1350);
    return cannon;
}

} // namespace vkbake::scenes
