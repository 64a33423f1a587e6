// The scenes that only benchmarks use.
#include <algorithm>
#include <limits>

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
    const char* name;
    glm::ivec2 cells; ///< one tree and two bushes each
};

// 2664 triangles a cell: a tree 1644, two bushes 366 each, and ground 288.
constexpr Forest forests[] = {{"5k", {2, 1}},     {"20k", {4, 2}},  {"80k", {6, 5}},
                              {"320k", {12, 10}}, {"1m", {20, 19}}, {"2m", {28, 27}}};

/// The denser the same everywhere, the larger the more triangles: what a ray meets near it is alike in all of them.
File forest(const Forest& kind) {
    constexpr double cell = 6.0;
    constexpr std::uint32_t trees = 4;
    constexpr std::uint32_t bushes = 3;
    const PlantShape bush{
        .height = 0.7, .radius = 0.03, .stem_rings = 2, .branches = 3, .reach = 0.8, .leaves = 120, .leaf_length = 0.2};
    Document document;
    Stage stage(document);
    std::vector<std::size_t> meshes;
    for (std::uint32_t k = 0; k < trees + bushes; ++k) {
        meshes.push_back(k < trees ? document.add_mesh("tree", make_plant({}, k))
                                   : document.add_mesh("bush", make_plant(bush, k)));
    }
    const glm::dvec2 size = cell * glm::dvec2(kind.cells);
    stage.place("terrain", document.add_mesh("terrain", {make_terrain(12 * kind.cells, size)}), glm::dvec3(0.0));
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
    return {std::string("forest-") + kind.name + ".glb", document.to_glb()};
}

} // namespace

std::vector<File> make_benchmark_files() {
    std::vector<File> files;
    files.push_back(thesis_objects());
    files.push_back({"furnished-apartment.glb", make_furnished_apartment().to_glb()});
    for (const Forest& kind : forests) {
        files.push_back(forest(kind));
    }
    return files;
}

} // namespace vkbake::scenes
