// The scenes of the thesis's chapter 4 that are more than one object.
#include <cmath>
#include <map>

#include "make_scenes/files.hpp"
#include "make_scenes/furniture.hpp"
#include "make_scenes/objects.hpp"
#include "make_scenes/shapes.hpp"
#include "make_scenes/stage.hpp"

namespace vkbake::scenes {
namespace {

Model single(const std::string& name, Solid solid) {
    Model model{name, {}};
    model.add(std::move(solid));
    return model;
}

File storage_room_file() {
    Document document;
    Stage stage(document);
    // Ground from below the room's slab; the room stands on it. No larger than needed: it takes texels from the rest.
    stage.place("ground",
                stage.mesh(single("ground", box({-3.2, -0.3, -2.8}, {3.2, -0.12 - contact_gap, 3.0}, Paint::earth))),
                glm::dvec3(0.0));
    stage.place("storage room", stage.mesh(make_store()), glm::dvec3(0.0));
    const std::size_t barrel = stage.mesh(make_barrel(24));
    stage.place("barrel in the corner", barrel, {-1.69, 0, -1.28}, 0.02);
    stage.place("barrel beside it", barrel, {-1.685, 0, -0.63}, 0.13);
    const std::size_t crate = stage.mesh(make_crate({0.5, 0.42, 0.42}, Paint::pine));
    stage.place("crate on the crate", crate, {1.66, 0.55 + contact_gap, -1.36}, 0.015);
    const std::size_t sack = stage.mesh(make_sack(20));
    stage.place("sack", sack, {0.72, 0, -1.30}, 0.04);
    stage.place("sack leaning out", sack, {1.02, 0, -0.86}, 0.21);
    const std::size_t jar = stage.mesh(make_jar(20, Paint::terracotta));
    const std::size_t blue_jar = stage.mesh(make_jar(20, Paint::blue_enamel));
    // The boards' tops: 0.21 + k (1.9 − 0.25) / 4.
    const auto board = [](int k) { return 0.18 + 0.03 + 1.65 * k / 4.0; };
    stage.place("jar", jar, {-1.05, board(1), -1.38});
    stage.place("jar", jar, {-0.75, board(1), -1.40}, 0.1);
    stage.place("blue jar", blue_jar, {-0.30, board(1), -1.37}, 0.2);
    stage.place("blue jar", blue_jar, {-1.00, board(2), -1.39}, 0.3);
    stage.place("jar", jar, {-0.10, board(2), -1.38}, 0.4);
    const std::size_t small_crate = stage.mesh(make_crate({0.40, 0.26, 0.32}, Paint::green_wood));
    stage.place("small crate", small_crate, {-0.57, board(2), -1.39}, 0.0);
    stage.place("small crate", small_crate, {-0.85, board(0), -1.38}, 0.0);
    stage.place("small crate", small_crate, {-0.25, board(3), -1.38}, 0.0);
    stage.place("blue jar", blue_jar, {-0.90, board(3), -1.38}, 0.6);
    document.add_main_camera({0.62, 1.52, 4.0}, {-0.06, 1.07, -0.9}, 0.62);
    return {"storage-room.glb", document.to_glb()};
}

// A gun platform: flagstones behind a parapet with an opening before each gun.
Model make_battery() {
    constexpr double spacing = 2.4;
    Cuts cuts{{-5.2}, {-0.3, 0.0, 0.44, 1.25}, {-3.2, -1.9, -0.6, 0.6, 1.15, 1.75}};
    for (int k = 0; k < 4; ++k) {
        const double centre = (k - 1.5) * spacing;
        cuts.x.push_back(centre - 0.4);
        cuts.x.push_back(centre + 0.4);
    }
    cuts.x.push_back(5.2);
    const auto filled = [&](const glm::dvec3& p) {
        if (p.y < 0.0) {
            return true;
        }
        const double from_gun = std::fabs(p.x - (std::floor(p.x / spacing) + 0.5) * spacing);
        return p.z > 1.15 && (p.y < 0.44 || from_gun > 0.4 || std::fabs(p.x) > 2.0 * spacing);
    };
    Solid stone = blocks(cuts, filled, [](const glm::dvec3& p, const glm::dvec3& normal) {
        return p.y < 0.01 && normal.y > 0.5 ? Paint::concrete : Paint::stone_warm;
    });
    return single("battery", std::move(stone));
}

// Four shot in a pyramid: three on the ground and one on top, all a hair apart.
Model make_shot_pile() {
    Model pile{"shot", {}};
    const double radius = 0.09;
    const double apart = 2.0 * radius + 0.002;
    const double row = apart * 0.8660254037844386;
    const double top = apart * 0.8164965809277260;
    const glm::dvec3 first{0.0, radius + contact_gap, 0.0};
    for (const glm::dvec3& offset : {glm::dvec3{0, 0, 0}, glm::dvec3{apart, 0, 0}, glm::dvec3{apart / 2, 0, row},
                                     glm::dvec3{apart / 2, top, row / 3}}) {
        pile.add(moved(sphere(radius, 12, 8, Paint::iron), first + offset));
    }
    return pile;
}

File four_cannons_file() {
    Document document;
    Stage stage(document);
    stage.place("battery", stage.mesh(make_battery()), glm::dvec3(0.0));
    const std::size_t cannon = stage.mesh(make_cannon());
    const std::size_t mount = stage.mesh(make_cannon_mount());
    const std::size_t shot = stage.mesh(make_shot_pile());
    const std::size_t barrel = stage.mesh(make_barrel(20));
    for (int k = 0; k < 4; ++k) {
        const glm::dvec3 at{(k - 1.5) * 2.4, contact_gap, 0.2};
        stage.place("mount", mount, at);
        stage.place("cannon", cannon, at + cannon_on_mount);
        stage.place("shot", shot, at + glm::dvec3{0.95, 0.0, 0.55});
    }
    stage.place("powder", barrel, {4.75, 0, -1.0});
    stage.place("powder", barrel, {4.70, 0, -0.3}, 0.1);
    document.add_main_camera({-5.6, 2.6, -4.6}, {-0.3, 0.35, 0.4}, 0.62);
    return {"four-cannons.glb", document.to_glb()};
}

} // namespace

std::vector<File> make_chapter_files() {
    std::vector<File> files;
    files.push_back(storage_room_file());
    files.push_back(four_cannons_file());
    return files;
}

} // namespace vkbake::scenes
