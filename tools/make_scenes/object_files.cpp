#include "make_scenes/document.hpp"
#include "make_scenes/files.hpp"
#include "make_scenes/objects.hpp"

namespace vkbake::scenes {
namespace {

struct View {
    glm::dvec3 eye;
    glm::dvec3 target;
};

File object_file(const std::string& stem, const Model& model, const View& view,
                 const glm::dvec3& place = glm::dvec3(0.0)) {
    Document document;
    Node node;
    node.name = model.name;
    node.mesh = document.add_mesh(model);
    node.translation = place;
    document.add_node(node);
    document.add_main_camera(view.eye, view.target);
    return {"objects/" + stem + ".glb", document.to_glb()};
}

} // namespace

std::vector<File> make_object_files() {
    std::vector<File> files;
    files.push_back(object_file("wall", make_wall(), {{1.3, 1.5, 3.4}, {0.0, 0.88, 0.0}}));
    // Raised so that the barrel lies clear of y = 0.
    files.push_back(object_file("cannon", make_cannon(), {{1.9, 1.1, 1.7}, {0.0, 0.2, 0.05}}, {0.0, 0.1875, 0.0}));
    files.push_back(object_file("fire-hydrant", make_fire_hydrant(), {{0.75, 0.85, 1.05}, {0.0, 0.42, 0.0}}));
    files.push_back(object_file("storage-room", make_storage_room(), {{0.9, 1.6, 4.4}, {-0.1, 1.15, -0.4}}));
    files.push_back(object_file("apartment", make_apartment(), {{4.2, 8.5, 8.2}, {0.0, 0.6, 0.2}}));
    files.push_back(object_file("wheelbarrow", make_wheelbarrow(), {{1.5, 1.15, 1.3}, {0.0, 0.35, 0.0}}));
    files.push_back(object_file("cannon-mount", make_cannon_mount(), {{1.5, 1.2, 1.4}, {0.0, 0.3, -0.05}}));
    files.push_back(object_file("door", make_door(), {{1.2, 1.6, 3.8}, {0.0, 1.2, 0.0}}));
    return files;
}

} // namespace vkbake::scenes
