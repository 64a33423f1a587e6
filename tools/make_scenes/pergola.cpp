// A terrace whose roof is leaves, with a screen of coloured glass and a curtain: what lets light through.
#include <array>
#include <cmath>

#include "make_scenes/document.hpp"
#include "make_scenes/files.hpp"
#include "make_scenes/furniture.hpp"
#include "make_scenes/shapes.hpp"
#include "make_scenes/stage.hpp"
#include "make_scenes/textures.hpp"
#include "make_scenes/turn.hpp"

namespace vkbake::scenes {
namespace {

/// A flat four-sided sheet around `centre`; `right` and `up` reach from its middle to its edges.
void add_sheet(Patch& patch, const glm::dvec3& centre, const glm::dvec3& right, const glm::dvec3& up) {
    const auto first = static_cast<std::uint32_t>(patch.positions.size());
    const glm::dvec3 normal = unit(glm::cross(right, up));
    for (const glm::dvec2& corner : {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1)}) {
        patch.positions.emplace_back(centre + corner.x * right + corner.y * up);
        patch.normals.emplace_back(normal);
        if (paint_info(patch.paint).texture != Texture::none) {
            patch.tex_coords_0.emplace_back(0.5 + 0.5 * corner.x, 0.5 - 0.5 * corner.y);
        }
    }
    for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) {
        patch.indices.push_back(first + corner);
    }
}

Model timber() {
    Model model{"timber", {}};
    const auto beam = [&](const glm::dvec3& low, const glm::dvec3& high, const glm::dvec3& grain) {
        model.add(grained(bevelled_box(low, high, 0.008, Paint::oak), grain));
    };
    for (const double x : {-1.85, 1.75}) {
        beam({x, contact_gap, 1.25}, {x + 0.1, 2.15, 1.35}, {0, 1, 0});
    }
    beam({-2.0, 2.15 + contact_gap, 1.24}, {2.0, 2.3, 1.36}, {1, 0, 0});
    for (int k = 0; k < 8; ++k) {
        const double x = -1.84 + 0.52 * k;
        beam({x, 2.3 + 2.0 * contact_gap, -1.5 + contact_gap}, {x + 0.06, 2.42, 1.6}, {0, 0, 1});
    }
    return model;
}

/// The frame that stands to the right and holds three panes.
Model screen() {
    Model model{"screen", {}};
    const auto bar = [&](const glm::dvec3& low, const glm::dvec3& high, const glm::dvec3& grain) {
        model.add(grained(front_bevelled_box(low, high, 0.005, Paint::walnut), grain));
    };
    bar({1.6, contact_gap, -1.10}, {1.66, 0.5, 0.62}, {0, 0, 1});
    bar({1.6, 1.85, -1.10}, {1.66, 1.93, 0.62}, {0, 0, 1});
    for (int k = 0; k < 4; ++k) {
        const double z = -1.10 + 0.56 * k;
        bar({1.6, 0.5 + contact_gap, z}, {1.66, 1.85 - contact_gap, z + 0.04}, {0, 1, 0});
    }
    return model;
}

std::vector<Patch> panes() {
    std::vector<Patch> patches;
    constexpr std::array glass{Paint::red_glass, Paint::amber_glass, Paint::blue_glass};
    for (std::size_t k = 0; k < glass.size(); ++k) {
        patches.push_back({.paint = glass[k]});
        add_sheet(patches.back(), {1.63, 1.175, -0.80 + 0.56 * static_cast<double>(k)}, {0.0, 0.0, -0.255},
                  {0.0, 0.67, 0.0});
    }
    return patches;
}

/// Sprigs that lie on the rafters, row after row, each turned and tilted as it happens.
Patch foliage() {
    Patch leaves{.paint = Paint::leaves};
    std::uint32_t number = 0;
    const auto draw = [&](double low, double high) { return low + (high - low) * random_of(900 + number++); };
    for (int row = 0; row < 6; ++row) {
        for (int column = 0; column < 6; ++column) {
            const glm::dvec3 centre(-0.95 + 0.46 * column + draw(-0.16, 0.16), draw(2.5, 2.66),
                                    -1.0 + 0.44 * row + draw(-0.16, 0.16));
            const glm::dvec2 turn = on_circle(draw(0.0, 1.0));
            const double size = draw(0.25, 0.36);
            const glm::dvec3 right = size * unit(glm::dvec3(turn.x, draw(-0.25, 0.25), turn.y));
            const glm::dvec3 up = size * unit(glm::cross(glm::dvec3(draw(-0.2, 0.2), 1.0, draw(-0.2, 0.2)), right));
            if (draw(0.0, 1.0) < 0.8) {
                add_sheet(leaves, centre, right, up);
            }
        }
    }
    return leaves;
}

/// A curtain in soft folds, hung from the beam.
Patch curtain() {
    Patch gauze{.paint = Paint::gauze};
    constexpr std::uint32_t folds = 40;
    for (std::uint32_t k = 0; k <= folds; ++k) {
        const double along = static_cast<double>(k) / folds;
        const glm::dvec2 fold = on_circle(4.0 * along);
        const glm::dvec2 next = on_circle(4.0 * along + 0.25);
        const glm::dvec3 normal = unit(glm::dvec3(-0.035 * 4.0 * 6.28 * next.x, 0.0, 0.8));
        for (const double y : {0.12, 2.14}) {
            gauze.positions.emplace_back(-1.72 + 0.8 * along, y, 1.30 + 0.035 * fold.x);
            gauze.normals.emplace_back(normal);
        }
        if (k < folds) {
            for (const std::uint32_t corner : {0U, 2U, 3U, 0U, 3U, 1U}) {
                gauze.indices.push_back(2 * k + corner);
            }
        }
    }
    return gauze;
}

} // namespace

File make_pergola_file() {
    Document document;
    Stage stage(document);
    const Cuts cuts{{-2.4, 2.4}, {-0.1, 0.0, 2.75}, {-1.62, -1.5, 2.2}};
    const auto filled = [](const glm::dvec3& p) { return p.y < 0.0 || p.z < -1.5; };
    const auto paint = [](const glm::dvec3& p, const glm::dvec3& normal) {
        return p.y < 0.01 && normal.y > 0.5 ? Paint::stone_warm : Paint::plaster;
    };
    Model terrace{"terrace", {}};
    terrace.add(blocks(cuts, filled, paint));
    stage.place("terrace", stage.mesh(terrace), glm::dvec3(0.0));
    stage.place("timber", stage.mesh(timber()), glm::dvec3(0.0));
    stage.place("screen", stage.mesh(screen()), glm::dvec3(0.0));
    stage.place("panes", document.add_mesh("panes", panes()), glm::dvec3(0.0));
    stage.place("leaves", document.add_mesh("leaves", {foliage()}), glm::dvec3(0.0));
    stage.place("curtain", document.add_mesh("curtain", {curtain()}), glm::dvec3(0.0));
    stage.place("crate", stage.mesh(make_crate({0.5, 0.42, 0.42}, Paint::pine)), {-0.85, 0, -1.05}, 0.03);
    stage.place("jar", stage.mesh(make_jar(28, Paint::white)), {-0.9, 0.42 + contact_gap, -1.05});
    stage.place("large jar", stage.mesh(make_jar(32, Paint::terracotta)), {-0.15, 0, -0.95}, 0.1, 1.9);

    Node sun;
    sun.name = "sun";
    sun.light = document.add_light({{"name", "sun"},
                                    {"type", "directional"},
                                    {"color", {1.0, 0.9, 0.74}},
                                    {"intensity", 9.0},
                                    {"extras", {{"vkbake", {{"angularDiameter", 0.53}}}}}});
    sun.rotation = rotation_towards({1.8, 3.1, 1.4}, glm::dvec3(0.0));
    document.add_node(sun);
    document.add_main_camera({-0.5, 1.75, 5.5}, {0.0, 1.3, -0.4}, 0.62);
    return {"pergola.glb", document.to_glb()};
}

} // namespace vkbake::scenes
