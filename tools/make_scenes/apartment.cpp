#include <cmath>

#include "make_scenes/objects.hpp"
#include "make_scenes/shapes.hpp"

namespace vkbake::scenes {
namespace {

// Two rooms and a bath on 8 m × 6 m, walls 2.5 m high: outer ones 0.25 m thick, inner ones 0.12 m.
bool between(double v, double low, double high) { return v > low && v < high; }

bool is_built(const glm::dvec3& p) {
    const bool outer = std::fabs(p.x) > 3.75 || std::fabs(p.z) > 2.75;
    const bool middle = between(p.x, 0.6, 0.72);
    const bool bath = p.x > 0.72 && between(p.z, 0.5, 0.62);
    if (!outer && !middle && !bath) {
        return false;
    }
    const bool below_lintel = p.y < 2.1;
    const bool glass_doors =
        below_lintel && ((p.z < -2.75 && between(p.x, -2.6, -0.6)) || (p.x > 3.75 && between(p.z, -0.9, 0.0)));
    const bool front_door = p.z > 2.75 && between(p.x, -0.6, 0.6) && p.y < 2.1;
    const bool inner_doors = p.y < 2.1 && ((middle && (between(p.z, -0.9, 0.0) || between(p.z, 0.62, 1.6))));
    return !glass_doors && !front_door && !inner_doors;
}

Paint paint_of(const glm::dvec3& p, const glm::dvec3& normal) {
    const bool inside = std::fabs(p.x) < 3.76 && std::fabs(p.z) < 2.76 && p.y > -0.01;
    if (!inside || normal.y > 0.5) {
        return Paint::plaster;
    }
    return p.x > 0.66 ? (p.z < 0.56 ? Paint::cream_plaster : Paint::white) : Paint::white;
}

void add_table(Model& apartment, const glm::dvec3& at) {
    apartment.add(grained(moved(box({-0.8, 0.71, -0.45}, {0.8, 0.75, 0.45}, Paint::oak), at), {1, 0, 0}));
    for (const double x : {-0.70, 0.64}) { // a panel at each end
        apartment.add(moved(box({x, contact_gap, -0.36}, {x + 0.06, 0.71 - contact_gap, 0.36}, Paint::oak), at));
    }
}

void add_bed(Model& apartment, const glm::dvec3& at) {
    const double g = contact_gap;
    apartment.add(moved(box({-0.8, g, -1.0}, {0.8, 0.30, 1.0}, Paint::walnut), at));
    apartment.add(moved(box({-0.78, 0.30 + g, -0.98}, {0.78, 0.50, 0.98}, Paint::linen), at));
}

void add_sofa(Model& apartment, const glm::dvec3& at) {
    // Seen from the side and drawn out: seat and back are one piece.
    Solid sofa = extrude({{0, 0.08}, {0.85, 0.08}, {0.85, 0.42}, {0.25, 0.42}, {0.18, 0.85}, {0, 0.85}}, -0.95, 0.95,
                         Paint::blue_enamel);
    apartment.add(moved(std::move(sofa), at));
    for (const double z : {-1.1, 0.95 + contact_gap}) {
        apartment.add(moved(box({0, 0.08, z}, {0.85, 0.60, z + 0.15 - contact_gap}, Paint::blue_enamel), at));
    }
}

} // namespace

Model make_apartment() {
    Model apartment{"apartment", {}};
    const Cuts cuts{{-4.0, -3.75, -2.6, -0.6, 0.6, 0.72, 3.75, 4.0},
                    {0.0, 2.1, 2.5},
                    {-3.0, -2.75, -0.9, 0.0, 0.5, 0.62, 1.6, 2.75, 3.0}};
    apartment.add(grained(box({-4.1, -0.2, -3.1}, {4.1, -contact_gap, 3.1}, Paint::pine), {1, 0, 0}));
    apartment.add(blocks(cuts, is_built, paint_of));
    add_table(apartment, {-1.6, 0.0, 1.2});
    add_bed(apartment, {2.2, 0.0, -1.73});
    add_sofa(apartment, {-3.75 + contact_gap, 0.0, -1.0});
    refine_model_to(apartment, 0, 504);
    return apartment;
}

} // namespace vkbake::scenes
