#include "make_scenes/tableware.hpp"

#include "make_scenes/shapes.hpp"
#include "make_scenes/turn.hpp"

namespace vkbake::scenes {
namespace {

constexpr double low = contact_gap;

Model turned(const std::string& name, const Profile& profile, int segments, Paint paint) {
    Model model{name, {}};
    model.add(lathe(profile, segments, paint));
    return model;
}

Solid handle(double length, double thickness, Paint paint) {
    return tube(
        {{0, low + 0.006, 0}, {0, low + 0.008, 0.3 * length}, {0, low + 0.008, 0.7 * length}, {0, low + 0.006, length}},
        thickness, 8, {1, 0, 0}, paint);
}

} // namespace

Model make_plate(double radius, Paint paint) {
    return turned("plate",
                  {{0.0, low},
                   {0.55 * radius, low},
                   {0.62 * radius, low + 0.006},
                   {0.98 * radius, low + 0.020},
                   {radius, low + 0.023},
                   {0.98 * radius, low + 0.026},
                   {0.66 * radius, low + 0.013},
                   {0.60 * radius, low + 0.008},
                   {0.0, low + 0.007}},
                  40, paint);
}

Model make_bowl(double radius, Paint paint) {
    Profile profile{{0.0, low}, {0.45 * radius, low}, {0.47 * radius, low + 0.008}};
    for (int k = 1; k <= 6; ++k) { // a quarter of a circle up the outside, and down the inside
        const glm::dvec2 c = on_circle(k / 24.0);
        profile.emplace_back(radius * (0.47 + 0.53 * c.y), low + 0.008 + 0.5 * radius * (1.0 - c.x));
    }
    for (int k = 6; k >= 1; --k) {
        const glm::dvec2 c = on_circle(k / 24.0);
        profile.emplace_back(radius * (0.44 + 0.52 * c.y), low + 0.012 + 0.5 * radius * (1.0 - c.x));
    }
    profile.emplace_back(0.0, low + 0.012);
    return turned("bowl", profile, 36, paint);
}

Model make_glass() {
    return turned("glass",
                  {{0.0, low},
                   {0.034, low},
                   {0.034, low + 0.003},
                   {0.005, low + 0.008},
                   {0.004, low + 0.075},
                   {0.020, low + 0.090},
                   {0.038, low + 0.120},
                   {0.040, low + 0.150},
                   {0.034, low + 0.185},
                   {0.032, low + 0.185},
                   {0.038, low + 0.150},
                   {0.036, low + 0.121},
                   {0.018, low + 0.093},
                   {0.0, low + 0.085}},
                  28, Paint::white);
}

Model make_bottle(double height, Paint paint) {
    return turned("bottle",
                  {{0.0, low},
                   {0.034, low},
                   {0.038, low + 0.006},
                   {0.038, low + 0.55 * height},
                   {0.034, low + 0.62 * height},
                   {0.020, low + 0.72 * height},
                   {0.014, low + 0.80 * height},
                   {0.013, low + 0.94 * height},
                   {0.016, low + 0.95 * height},
                   {0.016, low + height},
                   {0.0, low + height}},
                  20, paint);
}

Model make_jug(Paint paint) {
    Model jug = turned("jug",
                       {{0.0, low},
                        {0.055, low},
                        {0.060, low + 0.01},
                        {0.078, low + 0.07},
                        {0.075, low + 0.12},
                        {0.052, low + 0.18},
                        {0.050, low + 0.21},
                        {0.062, low + 0.24},
                        {0.057, low + 0.24},
                        {0.045, low + 0.21},
                        {0.047, low + 0.18},
                        {0.069, low + 0.12},
                        {0.0, low + 0.02}},
                       32, paint);
    jug.add(tube({{0.072, low + 0.20, 0},
                  {0.100, low + 0.205, 0},
                  {0.118, low + 0.185, 0},
                  {0.122, low + 0.15, 0},
                  {0.112, low + 0.11, 0},
                  {0.092, low + 0.085, 0}},
                 0.007, 10, {0, 0, 1}, paint));
    return jug;
}

Model make_place_setting() {
    Model setting{"place setting", {}};
    setting.add(make_plate(0.13, Paint::white), shifted({0, 0, 0}));
    setting.add(make_bowl(0.075, Paint::blue_enamel), shifted({0, 0.0095, 0}));
    setting.add(make_glass(), shifted({0.13, 0, -0.15}));
    for (const double x : {-0.18, 0.17, 0.20}) {
        setting.add(moved(handle(0.15, 0.004, Paint::iron), glm::dvec3(x, 0, -0.03)));
    }
    Solid spoon = sphere(0.018, 12, 8, Paint::iron);
    for (glm::dvec3& point : spoon.points) {
        point = {point.x, 0.25 * point.y, 1.4 * point.z};
    }
    setting.add(moved(std::move(spoon), glm::dvec3(0.20, low + 0.0065, -0.06)));
    for (const double x : {-0.188, -0.183, -0.178, -0.173}) { // the fork's tines
        setting.add(box({x - 0.001, low + 0.003, -0.08}, {x + 0.001, low + 0.006, -0.034}, Paint::iron));
    }
    setting.add(box({0.164, low + 0.003, -0.13}, {0.178, low + 0.0045, -0.034}, Paint::iron));
    return setting;
}

Model make_fruit_bowl() {
    Model bowl{"fruit bowl", {}};
    bowl.add(make_bowl(0.16, Paint::green_enamel), glm::dmat4(1.0));
    for (int k = 0; k < 12; ++k) {
        const bool upper = k >= 8;
        const glm::dvec2 c = on_circle(upper ? k / 4.0 + 0.06 : k / 8.0);
        const double radius = upper ? 0.045 : 0.095;
        bowl.add(moved(sphere(0.033, 18, 12, k % 3 == 0 ? Paint::red_enamel : Paint::yellow_enamel),
                       glm::dvec3(radius * c.x, low + (upper ? 0.115 : 0.075), radius * c.y)));
    }
    return bowl;
}

} // namespace vkbake::scenes
