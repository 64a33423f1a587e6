// The scenes that only benchmarks use.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/common.hpp>

#include "make_scenes/files.hpp"
#include "make_scenes/furnished_apartment.hpp"
#include "make_scenes/objects.hpp"
#include "make_scenes/shapes.hpp"
#include "make_scenes/stage.hpp"
#include "make_scenes/textures.hpp"
#include "make_scenes/vegetation.hpp"

namespace vkbake::scenes {
namespace {

double lowest(const Model& model) {
    double low = std::numeric_limits<double>::infinity();
    for (const Solid& solid : model.solids) {
        for (const glm::dvec3& point : solid.points) {
            low = std::min(low, point.y);
        }
    }
    return low;
}

/// The eight objects of the thesis's table, each standing on one ground.
File thesis_objects() {
    Document document;
    Stage stage(document);
    Model ground{"ground", {}};
    ground.add(box({-11.0, -0.2, -7.0}, {11.0, 0.0, 7.0}, Paint::earth));
    stage.place("ground", stage.mesh(ground), glm::dvec3(0.0));
    const auto stand = [&](const Model& model, double x, double z, double turns = 0.0) {
        stage.place(model.name, stage.mesh(model), {x, contact_gap - lowest(model), z}, turns);
    };
    stand(make_apartment(), -5.5, -2.8);
    stand(make_storage_room(), 3.5, -3.5);
    stand(make_wall(), 8.0, -3.0, 0.1);
    stand(make_door(), 0.0, 1.5);
    stand(make_fire_hydrant(), 2.2, 2.2, 0.2);
    stand(make_wheelbarrow(), -3.0, 3.6, 0.15);
    stand(make_cannon_mount(), 5.0, 2.8, -0.1);
    stand(make_cannon(), 7.5, 3.2, 0.3);
    document.add_main_camera({9.0, 8.0, 15.0}, {0.0, 0.5, 0.0});
    return {"thesis-objects.glb", document.to_glb()};
}

struct Forest {
    std::string name;
    glm::ivec2 cells{1}; ///< one tree and two bushes each
    int ground = 12;     ///< cells of the terrain along a side of one of these
    std::uint32_t trees = 4;
    std::uint32_t bushes = 3;
    PlantShape tree;
    PlantShape bush{
        .height = 0.7, .radius = 0.03, .stem_rings = 2, .branches = 3, .reach = 0.8, .leaves = 120, .leaf_length = 0.2};
};

/// As dense everywhere, and the larger the more triangles: 2664 a cell (a tree 1644, two bushes 366 each, ground 288).
std::vector<Forest> forests_that_grow() {
    return {{"forest-5k", {2, 1}},     {"forest-20k", {4, 2}},  {"forest-80k", {6, 5}},
            {"forest-320k", {12, 10}}, {"forest-1m", {20, 19}}, {"forest-2m", {28, 27}}};
}

/// The same place and trees, and the same area of leaves, cut into ever more of them.
std::vector<Forest> groves_that_get_finer() {
    constexpr int cells = 6;
    std::vector<Forest> groves;
    const auto add = [&](const char* name, int triangles) {
        Forest grove{.name = name, .cells = {3, 2}, .ground = 4, .trees = 2, .bushes = 2};
        grove.tree.stem_rings = 4;
        grove.tree.branches = 6;
        grove.bush.branches = 2;
        constexpr int wood_and_ground = 264 + 2 * 96 + 32; // triangles a cell
        // A bush has a fifth of a tree's leaves.
        grove.tree.leaves = (triangles / cells - wood_and_ground) * 5 / 14;
        grove.bush.leaves = grove.tree.leaves / 5;
        grove.tree.leaf_length *= std::sqrt(600.0 / grove.tree.leaves);
        grove.bush.leaf_length *= std::sqrt(120.0 / grove.bush.leaves);
        groves.push_back(grove);
    };
    add("grove-5k", 5'000);
    add("grove-20k", 20'000);
    add("grove-80k", 80'000);
    add("grove-320k", 320'000);
    add("grove-1m", 1'000'000);
    add("grove-2m", 2'000'000);
    return groves;
}

/// Trees whose leaves are cards: of the rays that the ground sends up, most meet one.
Forest cut_outs() {
    Forest forest{.name = "cut-outs", .cells = {5, 4}};
    forest.tree.foliage = Paint::leaves;
    forest.tree.leaves = 240;
    forest.tree.leaf_length = 0.8;
    forest.bush.foliage = Paint::leaves;
    forest.bush.leaves = 40;
    forest.bush.leaf_length = 0.5;
    return forest;
}

File forest(const Forest& kind) {
    constexpr double cell = 6.0;
    const std::uint32_t trees = kind.trees;
    const std::uint32_t bushes = kind.bushes;
    Document document;
    Stage stage(document);
    std::vector<std::size_t> meshes;
    for (std::uint32_t k = 0; k < trees + bushes; ++k) {
        meshes.push_back(k < trees ? document.add_mesh("tree", make_plant(kind.tree, k))
                                   : document.add_mesh("bush", make_plant(kind.bush, k)));
    }
    const glm::dvec2 size = cell * glm::dvec2(kind.cells);
    stage.place("terrain", document.add_mesh("terrain", {make_terrain(kind.ground * kind.cells, size)}),
                glm::dvec3(0.0));
    std::uint32_t draw = 1;
    for (int row = 0; row < kind.cells.y; ++row) {
        for (int column = 0; column < kind.cells.x; ++column) {
            for (int plant = 0; plant < 3; ++plant) {
                const glm::dvec2 place = cell * (glm::dvec2(column, row) + glm::dvec2(0.1 + 0.8 * random_of(draw),
                                                                                      0.1 + 0.8 * random_of(draw + 1)));
                const std::size_t mesh = plant == 0 ? meshes[draw / 7 % trees] : meshes[trees + draw / 5 % bushes];
                stage.place(plant == 0 ? "tree" : "bush", mesh, {place.x, terrain_height(place) - 0.05, place.y},
                            random_of(draw + 2), 0.8 + 0.4 * random_of(draw + 3));
                draw += 4;
            }
        }
    }
    document.add_main_camera({-0.1 * size.x - 4.0, 7.0, -0.1 * size.y - 6.0}, {0.4 * size.x, 0.0, 0.4 * size.y});
    return {kind.name + ".glb", document.to_glb()};
}

} // namespace

std::vector<File> make_benchmark_files() {
    std::vector<File> files;
    files.push_back(thesis_objects());
    files.push_back({"furnished-apartment.glb", make_furnished_apartment().to_glb()});
    for (const auto& family : {forests_that_grow(), groves_that_get_finer()}) {
        for (const Forest& kind : family) {
            files.push_back(forest(kind));
        }
    }
    files.push_back(forest(cut_outs()));
    for (File& file : make_unwrap_files()) {
        files.push_back(std::move(file));
    }
    return files;
}

} // namespace vkbake::scenes
