// Puts things into a document.
#pragma once

#include <string>

#include "make_scenes/document.hpp"

namespace vkbake::scenes {

/// A model becomes a mesh once, however often it is placed.
class Stage {
public:
    explicit Stage(Document& document) : m_document(&document) {}

    [[nodiscard]] std::size_t mesh(const Model& model) { return m_document->add_mesh(model); }

    void place(const std::string& name, std::size_t mesh_index, const glm::dvec3& at, double turns = 0.0,
               double scale = 1.0) {
        Node node;
        node.name = name;
        node.mesh = mesh_index;
        node.translation = at;
        if (turns != 0.0) {
            node.rotation = rotation_about_y(turns);
        }
        node.scale = glm::dvec3(scale);
        m_document->add_node(node);
    }

private:
    Document* m_document; ///< never null
};

} // namespace vkbake::scenes
