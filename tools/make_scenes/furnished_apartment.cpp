// A flat full of things, for the benchmarks: rays in it meet something after a short way, and something small.
#include "make_scenes/furnished_apartment.hpp"

#include <cmath>

#include "make_scenes/furnishings.hpp"
#include "make_scenes/furniture.hpp"
#include "make_scenes/objects.hpp"
#include "make_scenes/shapes.hpp"
#include "make_scenes/soft_goods.hpp"
#include "make_scenes/stage.hpp"
#include "make_scenes/tableware.hpp"
#include "make_scenes/vegetation.hpp"

namespace vkbake::scenes {
namespace {

// Inside: x −6…6, z −4.5…4.5, y 0…2.7. Living room to the left and behind, kitchen to the right and behind; in front
// from the left bedroom, study, bath.
constexpr double ceiling = 2.7;

bool between(double v, double low, double high) { return v > low && v < high; }

bool is_window(const glm::dvec3& p) {
    if (!between(p.y, 0.8, 2.2)) {
        return false;
    }
    const bool back = p.z < -4.5 && (between(p.x, -5.0, -3.2) || between(p.x, -2.0, -0.2) || between(p.x, 2.4, 4.4));
    const bool front = p.z > 4.5 && (between(p.x, -4.4, -2.6) || between(p.x, 0.0, 1.6) || between(p.x, 3.8, 4.8));
    const bool left = p.x < -6.0 && between(p.z, -3.0, -1.0);
    return back || front || left;
}

bool is_inner_wall(const glm::dvec3& p) {
    const bool doorway = p.y < 2.1;
    if (between(p.z, 1.0, 1.12)) {
        return !(doorway && (between(p.x, -3.6, -2.6) || between(p.x, 0.0, 1.0) || between(p.x, 3.8, 4.8)));
    }
    if (between(p.x, 1.0, 1.12) && p.z < 1.0) {
        return !(doorway && between(p.z, -3.0, -1.0));
    }
    return p.z > 1.12 && (between(p.x, -1.0, -0.88) || between(p.x, 2.5, 2.62));
}

bool is_built(const glm::dvec3& p) {
    if (p.y < 0.0) {
        return true;
    }
    if (p.y >
        ceiling) { // over the front rooms alone, with a roof light in the bath's: from elsewhere one sees some sky
        return p.z > 1.0 && !(between(p.x, 3.8, 4.8) && between(p.z, 2.0, 3.0));
    }
    const bool outside = std::fabs(p.x) > 6.0 || std::fabs(p.z) > 4.5;
    const bool front_door = p.x > 6.0 && between(p.z, -1.0, 1.0) && p.y < 2.1;
    return outside ? !is_window(p) && !front_door : is_inner_wall(p);
}

Model make_shell() {
    Model shell{"walls", {}};
    const Cuts cuts{{-6.25, -6.0, -5.0, -4.4, -3.6, -3.2, -2.6, -2.0, -1.0, -0.88, -0.2, 0.0,
                     1.0,   1.12, 1.6,  2.4,  2.5,  2.62, 3.8,  4.4,  4.8,  6.0,   6.25},
                    {-0.2, 0.0, 0.8, 2.1, 2.2, ceiling, ceiling + 0.2},
                    {-4.75, -4.5, -3.0, -1.0, 1.0, 1.12, 2.0, 3.0, 4.5, 4.75}};
    shell.add(blocks(cuts, is_built, [](const glm::dvec3& p, const glm::dvec3& normal) {
        return p.y < 0.01 && normal.y > 0.5 ? Paint::pine : Paint::plaster;
    }));
    for (const double z : {-4.0, -2.9, -1.6, 0.0}) {
        shell.add(grained(
            bevelled_box({-6.2, ceiling + contact_gap, z - 0.07}, {6.2, ceiling + 0.2, z + 0.07}, 0.01, Paint::walnut),
            {1, 0, 0}));
    }
    return shell;
}

void furnish_living_room(Stage& stage, std::size_t chair, std::size_t lamp, const std::vector<std::size_t>& bookcases) {
    const std::size_t sofa = stage.mesh(make_sofa());
    stage.place("sofa", sofa, {-5.5, 0, -1.4}, 0.25);
    stage.place("sofa", sofa, {-2.6, 0, 0.52}, 0.5);
    stage.place("low table", stage.mesh(make_table({1.2, 0.45, 0.7}, Paint::walnut)), {-3.6, 0, -1.2}, 0.25);
    stage.place("fruit", stage.mesh(make_fruit_bowl()), {-3.6, 0.45, -1.3});
    for (std::size_t k = 0; k < 3; ++k) {
        stage.place("bookcase", bookcases[k], {-5.3 + 1.55 * static_cast<double>(k), 0, 0.80}, 0.5);
    }
    stage.place("bookcase", bookcases[3], {0.82, 0, 0.0}, -0.25);
    stage.place("table", stage.mesh(make_table({2.4, 0.75, 1.0}, Paint::oak)), {-1.2, 0, -2.9});
    const std::size_t setting = stage.mesh(make_place_setting());
    const std::size_t jug = stage.mesh(make_jug(Paint::terracotta));
    for (int k = 0; k < 4; ++k) {
        const double x = -2.1 + 0.6 * k;
        stage.place("place setting", setting, {x, 0.75, -2.60});
        stage.place("place setting", setting, {x, 0.75, -3.20}, 0.5);
        stage.place("chair", chair, {x, 0, -2.25}, 0.5 + 0.02 * (k - 1));
        stage.place("chair", chair, {x, 0, -3.55}, 0.02 * (k - 2));
    }
    stage.place("jug", jug, {-1.2, 0.75, -2.9}, 0.1);
    stage.place("jug", jug, {-0.5, 0.75, -2.88}, 0.6);
    const std::size_t chandelier = stage.mesh(make_chandelier(8));
    stage.place("chandelier", chandelier, {-1.2, ceiling - 0.002, -2.9});
    stage.place("chandelier", chandelier, {-3.6, ceiling - 0.002, 0.0}, 0.03);
    stage.place("floor lamp", lamp, {-5.6, 0, -3.9});
    stage.place("floor lamp", lamp, {0.6, 0, -4.1});
}

void furnish_kitchen(Stage& stage, std::size_t chair) {
    stage.place("cupboards", stage.mesh(make_cupboards(7, 0.86)), {3.6, 0, -4.15});
    stage.place("cupboards", stage.mesh(make_cupboards(4, 0.86)), {5.65, 0, -2.2}, -0.25);
    stage.place("kitchen table", stage.mesh(make_table({0.9, 0.75, 0.9}, Paint::pine)), {2.8, 0, -1.2});
    for (int k = 0; k < 3; ++k) {
        stage.place("chair", chair, {2.8 + 0.62 * (k - 1), 0, k == 1 ? -0.5 : -1.2}, k == 1 ? 0.5 : 0.25 * (1 - k));
    }
    const std::size_t bowl = stage.mesh(make_bowl(0.11, Paint::yellow_enamel));
    const std::size_t plate = stage.mesh(make_plate(0.12, Paint::white));
    const std::size_t jar = stage.mesh(make_jar(28, Paint::blue_enamel));
    const std::size_t bottles[] = {stage.mesh(make_bottle(0.30, Paint::green_enamel)),
                                   stage.mesh(make_bottle(0.26, Paint::bronze))};
    const std::size_t shelf = stage.mesh(make_shelf(1.5, 0.3, 1.5, 4, Paint::oak));
    for (const double x : {2.2, 4.2}) {
        stage.place("kitchen shelf", shelf, {x, 0.905, -4.33});
        for (int board = 0; board < 4; ++board) {
            const double top = 0.905 + 0.21 + 1.25 * board / 4.0;
            for (int k = 0; k < 9; ++k) {
                const double place = x - 0.6 + 0.15 * k;
                const std::size_t what = board == 0 ? plate : (board == 1 ? bowl : (board == 2 ? bottles[k % 2] : jar));
                const double apart = board == 0 || board == 1 || board == 3 ? 1.0 : 0.0;
                if (apart > 0.0 && k % 2 == 1) {
                    stage.place("on the shelf", what, {place - 0.15, top + (board < 2 ? 0.03 : 0.0), -4.31}, 0.1 * k,
                                board == 3 ? 0.6 : 0.98);
                } else {
                    stage.place("on the shelf", what, {place, top, -4.33}, 0.13 * k, board == 3 ? 0.6 : 1.0);
                }
            }
        }
    }
    stage.place("basket of jars", stage.mesh(make_crate({0.5, 0.3, 0.4}, Paint::pine)), {1.5, 0, -4.1});
}

void furnish_front_rooms(Stage& stage, std::size_t chair, std::size_t lamp, const std::vector<std::size_t>& bookcases) {
    stage.place("bed", stage.mesh(make_bed(1.8)), {-4.9, 0, 3.0}, 0.25);
    stage.place("chest", stage.mesh(make_chest({1.0, 0.5, 0.5}, Paint::blue_wood)), {-2.0, 0, 4.2}, 0.5);
    stage.place("bookcase", bookcases[0], {-1.18, 0, 2.2}, -0.25);
    stage.place("floor lamp", lamp, {-5.7, 0, 1.5});
    stage.place("desk", stage.mesh(make_table({1.5, 0.74, 0.7}, Paint::walnut)), {0.8, 0, 4.0});
    stage.place("chair", chair, {0.8, 0, 3.4});
    stage.place("globe",
                stage.mesh(Model{"globe", {moved(sphere(0.16, 40, 28, Paint::blue_enamel), glm::dvec3(0, 0.17, 0))}}),
                {1.3, 0.74, 4.05});
    for (std::size_t k = 0; k < 2; ++k) {
        stage.place("bookcase", bookcases[1 + k], {-0.68, 0, 2.1 + 1.6 * static_cast<double>(k)}, 0.25);
        stage.place("bookcase", bookcases[2 + k], {2.3, 0, 1.95 + 1.6 * static_cast<double>(k)}, -0.25);
    }
    stage.place("bathtub", stage.mesh(make_bathtub()), {5.5, 0, 3.2}, 0.25);
    stage.place("cupboards", stage.mesh(make_cupboards(2, 0.8)), {3.3, 0, 4.15}, 0.5);
    stage.place("barrel", stage.mesh(make_barrel(40)), {3.0, 0, 1.55});
    stage.place("front door", stage.mesh(make_door()), {6.12, 0.0, 0.0}, 0.25);
}

void hang_curtains(Stage& stage) {
    const std::size_t curtain = stage.mesh(make_curtain(0.75, 2.4, Paint::terracotta));
    const std::size_t linen = stage.mesh(make_curtain(0.6, 2.4, Paint::linen));
    for (const double x : {-5.2, -3.0, -2.2, 0.0}) {
        stage.place("curtain", curtain, {x, 0.02, -4.42});
    }
    for (const double x : {-4.6, -2.4, -0.2, 1.8}) {
        stage.place("curtain", linen, {x, 0.02, 4.42});
    }
    for (const double z : {-3.1, -0.9}) {
        stage.place("curtain", curtain, {-5.92, 0.02, z}, 0.25);
    }
}

void add_plants(Document& document, Stage& stage) {
    const PlantShape shape{.height = 1.1,
                           .radius = 0.02,
                           .stem_rings = 6,
                           .branches = 9,
                           .reach = 0.4,
                           .leaves = 260,
                           .leaf_length = 0.13};
    const std::size_t pot = stage.mesh(make_jar(32, Paint::terracotta));
    for (std::uint32_t k = 0; k < 2; ++k) {
        const std::size_t plant = document.add_mesh("plant", make_plant(shape, 40 + k));
        const std::vector<glm::dvec3> places =
            k == 0 ? std::vector<glm::dvec3>{{-5.5, 0, 0.1}, {0.55, 0, -3.4}, {5.5, 0, 0.6}}
                   : std::vector<glm::dvec3>{{-5.55, 0, -4.0}, {-1.4, 0, 4.0}, {2.2, 0, 4.2}};
        for (const glm::dvec3& place : places) {
            stage.place("pot", pot, place);
            stage.place("plant", plant, place + glm::dvec3(0, 0.18, 0), 0.3 * place.x);
        }
    }
}

} // namespace

Document make_furnished_apartment() {
    Document document;
    Stage stage(document);
    stage.place("walls", stage.mesh(make_shell()), glm::dvec3(0.0));
    const std::size_t chair = stage.mesh(make_chair());
    const std::size_t lamp = stage.mesh(make_floor_lamp());
    std::vector<std::size_t> bookcases;
    for (std::uint32_t k = 0; k < 4; ++k) {
        bookcases.push_back(stage.mesh(make_bookcase(1.5, k + 1)));
    }
    furnish_living_room(stage, chair, lamp, bookcases);
    furnish_kitchen(stage, chair);
    furnish_front_rooms(stage, chair, lamp, bookcases);
    hang_curtains(stage);
    add_plants(document, stage);
    document.add_main_camera({0.5, 1.9, -0.6}, {-3.2, 0.8, -2.6}, 1.0);
    return document;
}

} // namespace vkbake::scenes
