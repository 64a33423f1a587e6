#include "make_scenes/furniture.hpp"

#include "make_scenes/shapes.hpp"

namespace vkbake::scenes {

Model make_barrel(int segments) {
    Model barrel{"barrel", {}};
    const double low = contact_gap;
    // The head lies a little below the staves' ends, at the top and underneath.
    barrel.add(lathe({{0.0, low + 0.03},
                      {0.235, low + 0.03},
                      {0.235, low},
                      {0.255, low},
                      {0.292, low + 0.20},
                      {0.305, low + 0.45},
                      {0.292, low + 0.70},
                      {0.255, low + 0.90},
                      {0.235, low + 0.90},
                      {0.235, low + 0.87},
                      {0.0, low + 0.87}},
                     segments, Paint::oak));
    const auto hoop = [&](double lower, double upper, double height) {
        barrel.add(
            lathe({{lower, height}, {lower + 0.007, height}, {upper + 0.007, height + 0.045}, {upper, height + 0.045}},
                  segments, Paint::iron, Ends::joined));
    };
    const double off = 0.003;
    hoop(0.2587 + off, 0.267 + off, low + 0.02);
    hoop(0.2938 + off, 0.2962 + off, low + 0.235);
    hoop(0.2962 + off, 0.2938 + off, low + 0.62);
    hoop(0.267 + off, 0.2587 + off, low + 0.835);
    return barrel;
}

Model make_crate(const glm::dvec3& size, Paint paint) {
    Model crate{"crate", {}};
    const double low = contact_gap;
    const double plank = 0.022;
    const glm::dvec3 half{size.x / 2, 0, size.z / 2};
    crate.add(grained(box({-half.x + plank, low + plank, -half.z + plank},
                          {half.x - plank, low + size.y - plank, half.z - plank}, paint),
                      {1, 0, 0}));
    // Corner posts stand out on all sides; rails between them on the front and the sides' tops.
    const double post = 0.07;
    const double g = contact_gap;
    for (const double side : {-1.0, 1.0}) {
        for (const double front : {-1.0, 1.0}) {
            // An angle of wood around the corner, as an L in plan.
            const auto at = [&](double along_x, double along_z) {
                return glm::dvec2{side * (half.x - along_x), front * (half.z - along_z)};
            };
            const double inner = plank - g;
            Solid corner =
                extrude({at(0, 0), at(post, 0), at(post, inner), at(inner, inner), at(inner, post), at(0, post)}, 0.0,
                        size.y, paint);
            corner = moved(std::move(corner), about_x(0.25)); // (x, y, z) → (x, −z, y)
            crate.add(grained(moved(std::move(corner), glm::dvec3{0, low + size.y, 0}), {0, 1, 0}));
        }
    }
    for (const double front : {-1.0, 1.0}) {
        for (const double base : {low + 0.03, low + size.y - 0.03 - post}) {
            const double inner = half.z - plank + g;
            const double outer = half.z - 0.004;
            crate.add(grained(box({-half.x + post + g, base, front > 0 ? inner : -outer},
                                  {half.x - post - g, base + post, front > 0 ? outer : -inner}, paint),
                              {1, 0, 0}));
            const double inner_x = half.x - plank + g;
            const double outer_x = half.x - 0.004;
            crate.add(grained(box({front > 0 ? inner_x : -outer_x, base, -half.z + post + g},
                                  {front > 0 ? outer_x : -inner_x, base + post, half.z - post - g}, paint),
                              {0, 0, 1}));
        }
    }
    return crate;
}

Model make_chest(const glm::dvec3& size, Paint paint) {
    Model chest{"chest", {}};
    const glm::dvec3 half{size.x / 2, 0, size.z / 2};
    const double lid = 0.08;
    chest.add(grained(bevelled_box({-half.x, contact_gap, -half.z}, {half.x, size.y - lid, half.z}, 0.012, paint),
                      {1, 0, 0}));
    chest.add(grained(bevelled_box({-half.x - 0.015, size.y - lid + contact_gap, -half.z - 0.015},
                                   {half.x + 0.015, size.y, half.z + 0.015}, 0.015, paint),
                      {1, 0, 0}));
    return chest;
}

Model make_shelf(double width, double depth, double height, int boards, Paint paint) {
    Model shelf{"shelf", {}};
    const double post = 0.05;
    const double board = 0.03;
    for (const double x : {-width / 2, width / 2 - post}) {
        for (const double z : {-depth / 2, depth / 2 - post}) {
            shelf.add(box({x, contact_gap, z}, {x + post, height, z + post}, paint));
        }
    }
    for (int k = 0; k < boards; ++k) {
        const double top = 0.18 + board + (height - 0.25) * k / boards;
        // Between the posts' pairs, resting on nothing but a hair of air: joints need no nails here.
        shelf.add(grained(box({-width / 2 + post + contact_gap, top - board, -depth / 2},
                              {width / 2 - post - contact_gap, top, depth / 2}, paint),
                          {1, 0, 0}));
    }
    return shelf;
}

Model make_jar(int segments, Paint paint) {
    Model jar{"jar", {}};
    const double low = contact_gap;
    jar.add(lathe({{0.0, low},
                   {0.060, low},
                   {0.095, low + 0.07},
                   {0.105, low + 0.14},
                   {0.085, low + 0.215},
                   {0.055, low + 0.25},
                   {0.068, low + 0.285},
                   {0.058, low + 0.285},
                   {0.046, low + 0.25},
                   {0.070, low + 0.20},
                   {0.0, low + 0.17}},
                  segments, paint));
    return jar;
}

Model make_sack(int segments) {
    Model sack{"sack", {}};
    const double low = contact_gap;
    Solid skin = lathe({{0.0, low},
                        {0.17, low},
                        {0.215, low + 0.05},
                        {0.225, low + 0.16},
                        {0.205, low + 0.30},
                        {0.140, low + 0.41},
                        {0.055, low + 0.465},
                        {0.085, low + 0.52},
                        {0.075, low + 0.545},
                        {0.0, low + 0.50}},
                       segments, Paint::linen);
    skin.crease_cosine = 0.35;
    sack.add(moved(std::move(skin), glm::dmat4{{1.0, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0.8, 0}, {0, 0, 0, 1}}));
    return sack;
}

} // namespace vkbake::scenes
