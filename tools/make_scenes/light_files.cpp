// Scenes that show kinds of light.
#include "make_scenes/files.hpp"
#include "make_scenes/furniture.hpp"
#include "make_scenes/shapes.hpp"
#include "make_scenes/stage.hpp"

namespace vkbake::scenes {
namespace {

Model whole(const std::string& name, Solid solid) {
    Model model{name, {}};
    model.add(std::move(solid));
    return model;
}

void add_lamp(Document& document, const std::string& name, const glm::dvec3& at, const glm::dvec3& target, Json light) {
    light["name"] = name;
    Node node;
    node.name = name;
    node.light = document.add_light(light);
    node.translation = at;
    node.rotation = rotation_towards(at, target);
    document.add_node(node);
}

// A floor and two walls at night: a hanging lamp, whose light is soft and comes from under a shade, and a spotlight.
File lamps_file() {
    Document document;
    Stage stage(document);
    const Cuts cuts{{-2.1, -2.0, 2.6}, {-0.1, 0.0, 2.6}, {-1.6, -1.5, 1.6}};
    const auto filled = [](const glm::dvec3& p) { return p.x < -2.0 || p.y < 0.0 || p.z < -1.5; };
    const auto paint = [](const glm::dvec3& p, const glm::dvec3& normal) {
        return p.y < 0.01 && normal.y > 0.5 ? Paint::terracotta : Paint::plaster;
    };
    stage.place("room", stage.mesh(whole("room", blocks(cuts, filled, paint))), glm::dvec3(0.0));

    const glm::dvec3 bulb{-0.85, 1.6, -0.55};
    const Profile shade{{0.37, 0.05}, {0.12, 0.22}, {0.02, 0.25}, {0.02, 0.24}, {0.115, 0.21}, {0.36, 0.05}};
    stage.place("shade", stage.mesh(whole("shade", lathe(shade, 32, Paint::rubber, Ends::joined))), bulb);
    add_lamp(document, "hanging lamp", bulb, bulb - glm::dvec3(0.0, 0.0, 1.0),
             {{"type", "point"},
              {"color", {1.0, 0.72, 0.42}},
              {"intensity", 9.0},
              {"extras", {{"vkbake", {{"radius", 0.07}}}}}});

    const std::size_t crate = stage.mesh(make_crate({0.5, 0.42, 0.42}, Paint::pine));
    stage.place("crate", crate, {-0.85, 0, -0.75}, 0.04);
    const std::size_t jar = stage.mesh(make_jar(24, Paint::blue_enamel));
    stage.place("jar on the crate", jar, {-0.95, 0.42 + contact_gap, -0.75});
    stage.place("sack", stage.mesh(make_sack(20)), {-1.55, 0, -1.0}, 0.1);
    stage.place("barrel", stage.mesh(make_barrel(24)), {-0.05, 0, -1.05}, 0.1);

    stage.place(
        "plinth",
        stage.mesh(whole("plinth", bevelled_box({-0.2, contact_gap, -0.2}, {0.2, 0.8, 0.2}, 0.01, Paint::white))),
        {1.05, 0, -0.75});
    stage.place("jar on the plinth", stage.mesh(make_jar(32, Paint::terracotta)), {1.05, 0.8, -0.75}, 0.1, 1.4);
    add_lamp(document, "spotlight", {0.1, 2.3, 1.3}, {1.1, 1.0, -0.75},
             {{"type", "spot"},
              {"color", {0.75, 0.86, 1.0}},
              {"intensity", 42.0},
              {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.3}}}});
    document.add_main_camera({0.45, 1.45, 4.0}, {0.0, 0.98, -0.8}, 0.6);
    return {"lamps.glb", document.to_glb()};
}

void add_probe(Document& document, const std::string& name, const glm::dvec3& at) {
    Node node;
    node.name = name;
    node.probe = true;
    node.translation = at;
    document.add_node(node);
}

Model lantern() {
    Model model{"lantern", {}};
    model.add(cylinder(0.10, 0.04, 16, Paint::bronze));
    model.add(moved(cylinder(0.03, 1.45, 12, Paint::bronze), {0.0, 0.04 + contact_gap, 0.0}));
    model.add(moved(sphere(0.07, 16, 8, Paint::glow), {0.0, 1.62, 0.0}));
    const Profile hat{{0.13, 1.71}, {0.02, 1.80}, {0.02, 1.79}, {0.125, 1.705}};
    model.add(lathe(hat, 16, Paint::bronze, Ends::joined));
    return model;
}

// A corner of a yard at night: what emits small and bright, what has a normal map, and light probes.
File courtyard_file() {
    Document document;
    Stage stage(document);
    const Cuts cuts{{-2.4, -2.3, 2.4}, {-0.1, 0.0, 1.9}, {-1.9, -1.8, 1.8}};
    const auto filled = [](const glm::dvec3& p) { return p.x < -2.3 || p.y < 0.0 || p.z < -1.8; };
    const auto paint = [](const glm::dvec3& p, const glm::dvec3& normal) {
        return p.y < 0.01 && normal.y > 0.5 ? Paint::cobbles : Paint::cream_plaster;
    };
    Model yard{"yard", {}};
    yard.add(blocks(cuts, filled, paint));
    stage.place("yard", stage.mesh(yard), glm::dvec3(0.0));

    const std::size_t lamp = stage.mesh(lantern());
    stage.place("lantern in the corner", lamp, {-1.75, contact_gap, -1.25});
    stage.place("lantern by the barrel", lamp, {1.35, contact_gap, -0.55});
    stage.place("barrel", stage.mesh(make_barrel(24)), {0.55, contact_gap, -1.2}, 0.1);
    stage.place("crate", stage.mesh(make_crate({0.5, 0.42, 0.42}, Paint::pine)), {-0.75, contact_gap, -1.35}, 0.04);
    stage.place("jar", stage.mesh(make_jar(24, Paint::blue_enamel)), {-0.75, 0.42 + 2.0 * contact_gap, -1.35});

    add_probe(document, "by the corner", {-1.5, 0.35, -0.3});
    add_probe(document, "in the middle", {-0.2, 0.35, -0.1});
    add_probe(document, "by the barrel", {1.2, 0.35, 0.3});
    document.add_main_camera({0.6, 1.75, 3.6}, {-0.15, 0.55, -0.7}, 0.62);
    return {"courtyard.glb", document.to_glb()};
}

} // namespace

std::vector<File> make_light_files() {
    std::vector<File> files;
    files.push_back(lamps_file());
    files.push_back(make_pergola_file());
    files.push_back(courtyard_file());
    return files;
}

} // namespace vkbake::scenes
