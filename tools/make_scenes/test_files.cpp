// Small scenes, each to prove one thing; scenes/README.md says which.
#include <utility>

#include "make_scenes/document.hpp"
#include "make_scenes/files.hpp"
#include "make_scenes/shapes.hpp"

namespace vkbake::scenes {
namespace {

Model single(const std::string& name, Solid solid) {
    Model model{name, {}};
    model.add(std::move(solid));
    return model;
}

File file_of(const std::string& stem, Document& document, const glm::dvec3& eye, const glm::dvec3& target) {
    document.add_main_camera(eye, target);
    return {"test/" + stem + ".glb", document.to_glb()};
}

Node node_of(const std::string& name, std::size_t mesh, const glm::dvec3& translation = glm::dvec3(0.0)) {
    Node node;
    node.name = name;
    node.mesh = mesh;
    node.translation = translation;
    return node;
}

File plane() {
    Document document;
    Patch patch;
    patch.positions = {{-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}};
    patch.normals.assign(4, {0, 1, 0});
    patch.indices = {0, 1, 2, 0, 2, 3};
    document.add_node(node_of("plane", document.add_mesh("plane", {patch})));
    return file_of("plane", document, {1.5, 2.0, 3.0}, {0, 0, 0});
}

// The cube's six faces one after another; `place` gives the k-th face's corner of the light map and its side.
template<class Place>
Patch cube_patch(Place place) {
    Patch patch;
    for (std::uint32_t face = 0; face < 6; ++face) {
        const auto axis = static_cast<int>(face / 2);
        const float side = face % 2 == 0 ? 1.0F : -1.0F;
        glm::vec3 normal(0.0F);
        glm::vec3 u(0.0F);
        glm::vec3 v(0.0F);
        normal[axis] = side;
        u[(axis + 1) % 3] = side;
        v[(axis + 2) % 3] = 1.0F;
        const auto [corner, size] = place(face);
        for (const glm::vec2& s : {glm::vec2{0, 0}, glm::vec2{1, 0}, glm::vec2{1, 1}, glm::vec2{0, 1}}) {
            patch.positions.push_back(0.5F * normal + (s.x - 0.5F) * u + (s.y - 0.5F) * v + glm::vec3(0, 0.5F, 0));
            patch.normals.push_back(normal);
            patch.tex_coords_1.push_back(corner + size * s);
        }
        for (const std::uint32_t k : {0U, 1U, 2U, 0U, 2U, 3U}) {
            patch.indices.push_back(face * 4 + k);
        }
    }
    return patch;
}

File cube() {
    // Each face in a cell of its own of a 3 × 2 grid, an eighth of a unit from its neighbours.
    Document document;
    const Patch patch = cube_patch([](std::uint32_t face) {
        const std::uint32_t row = face / 3;
        const glm::vec2 cell{0.0625F + 0.3125F * static_cast<float>(face % 3),
                             0.125F + 0.4375F * static_cast<float>(row)};
        return std::pair{cell, 0.25F};
    });
    document.add_node(node_of("cube", document.add_mesh("cube", {patch})));
    return file_of("cube", document, {1.4, 1.5, 2.2}, {0, 0.5, 0});
}

File overlapping_uv() {
    Document document;
    const Patch patch = cube_patch([](std::uint32_t) { return std::pair{glm::vec2(0.0F), 1.0F}; });
    document.add_node(node_of("cube", document.add_mesh("cube", {patch})));
    return file_of("overlapping-uv", document, {1.4, 1.5, 2.2}, {0, 0.5, 0});
}

// An L: no mirror plane but that of its own thickness, so a mirrored one cannot be taken for another turned.
Solid letter() {
    return extrude({{0, 0}, {0.6, 0}, {0.6, 0.25}, {0.25, 0.25}, {0.25, 1.0}, {0, 1.0}}, 0.0, 0.3, Paint::white);
}

File mirrored_instances() {
    Document document;
    const std::size_t mesh = document.add_mesh(single("letter", letter()));
    document.add_node(node_of("as it is", mesh, {0.25, 0, 0}));
    Node mirrored = node_of("mirrored", mesh, {-0.25, 0, 0});
    mirrored.scale = {-1, 1, 1};
    document.add_node(mirrored);
    Node through_a_point = node_of("mirrored on three axes, stretched", mesh, {2.0, 1.5, 0.3});
    through_a_point.scale = {-1, -1.5, -0.5};
    document.add_node(through_a_point);
    return file_of("mirrored-instances", document, {0.9, 1.6, 4.0}, {0.5, 0.6, 0});
}

File nested_transforms() {
    Document document;
    const std::size_t mesh = document.add_mesh(single("letter", letter()));
    Node far_away;
    far_away.name = "far away";
    far_away.translation = {4096, 0, -8192};
    const std::size_t root = document.add_node(far_away);
    Node turned = node_of("turned", mesh);
    turned.parent = root;
    turned.rotation = rotation_about_y(0.125);
    const std::size_t arm = document.add_node(turned);
    Node stretched = node_of("stretched", mesh, {1.5, 0, 0});
    stretched.parent = arm;
    stretched.scale = {2, 0.5, 1};
    const std::size_t forearm = document.add_node(stretched);
    // A turn under a stretch makes shear: a chain of rotations and scales alone could not say it.
    Node sheared = node_of("sheared", mesh, {0.8, 0, 0.2});
    sheared.parent = forearm;
    sheared.rotation = rotation_about_y(0.125);
    document.add_node(sheared);
    return file_of("nested-transforms", document, {4098, 2.5, -8187}, {4097.3, 0.4, -8192.5});
}

File closed_box() {
    Model model{"closed box", {}};
    model.add(box({-1, 0, -1}, {1, 2, 1}, Paint::white));
    Solid hollow = box({-0.9, 0.1, -0.9}, {0.9, 1.9, 0.9}, Paint::white);
    for (Triangle& t : hollow.triangles) {
        std::swap(t.corners[1], t.corners[2]);
    }
    model.add(std::move(hollow));
    Document document;
    document.add_node(node_of("closed box", document.add_mesh(model)));
    return file_of("closed-box", document, {3, 2.5, 4.5}, {0, 1, 0});
}

File corner() {
    // A floor and two walls, 0.1 m thick, as one piece, and a cube close to both walls.
    const Cuts cuts{{-0.1, 0, 2}, {-0.1, 0, 2}, {-0.1, 0, 2}};
    const auto filled = [](const glm::dvec3& p) { return p.x < 0 || p.y < 0 || p.z < 0; };
    const auto paint = [](const glm::dvec3& p, const glm::dvec3& normal) {
        const bool inside = p.x > -0.01 && p.y > -0.01 && p.z > -0.01;
        return inside && normal.y > 0.5 ? Paint::oak : Paint::white;
    };
    Document document;
    document.add_node(node_of("corner", document.add_mesh(single("corner", blocks(cuts, filled, paint)))));
    const double g = contact_gap;
    const Solid cube = box({g, g, g}, {0.6, 0.6, 0.6}, Paint::blue_enamel);
    document.add_node(node_of("cube", document.add_mesh(single("cube", cube))));
    return file_of("corner", document, {3.4, 2.6, 4.2}, {0.8, 0.7, 0.6});
}

} // namespace

std::vector<File> make_test_files() {
    std::vector<File> files;
    for (File (*make)() :
         {&plane, &cube, &overlapping_uv, &mirrored_instances, &nested_transforms, &closed_box, &corner}) {
        files.push_back(make());
    }
    return files;
}

} // namespace vkbake::scenes
