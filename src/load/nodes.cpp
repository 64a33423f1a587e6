#include "load/nodes.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "load/lamps.hpp"

namespace vkbake::gltf {

namespace {

struct Transform {
    glm::dmat3 linear{1.0};
    glm::dvec3 translation{0.0};
};

Transform local_transform(const tinygltf::Node& node) {
    Transform local;
    if (node.matrix.size() == 16) {
        const auto entry = [&](glm::length_t column, glm::length_t row) {
            return node.matrix[4 * static_cast<std::size_t>(column) + static_cast<std::size_t>(row)];
        };
        for (glm::length_t column = 0; column < 3; ++column) {
            for (glm::length_t row = 0; row < 3; ++row) {
                local.linear[column][row] = entry(column, row);
            }
            local.translation[column] = entry(3, column);
        }
        return local;
    }
    if (node.translation.size() == 3) {
        local.translation = {node.translation[0], node.translation[1], node.translation[2]};
    }
    if (node.rotation.size() == 4) {
        // Scaled by the largest part first, so that no square can overflow or vanish; 2/|q|² then makes it a rotation.
        double largest = 0.0;
        for (const double part : node.rotation) {
            largest = std::max(largest, std::abs(part));
        }
        const double x = node.rotation[0] / largest;
        const double y = node.rotation[1] / largest;
        const double z = node.rotation[2] / largest;
        const double w = node.rotation[3] / largest;
        const double s = 2.0 / (x * x + y * y + z * z + w * w);
        local.linear = glm::dmat3(1.0 - s * (y * y + z * z), s * (x * y + z * w), s * (x * z - y * w), //
                                  s * (x * y - z * w), 1.0 - s * (x * x + z * z), s * (y * z + x * w), //
                                  s * (x * z + y * w), s * (y * z - x * w), 1.0 - s * (x * x + y * y));
    }
    if (node.scale.size() == 3) {
        for (glm::length_t column = 0; column < 3; ++column) {
            local.linear[column] *= node.scale[static_cast<std::size_t>(column)];
        }
    }
    return local;
}

bool is_finite(const Transform& transform) {
    for (glm::length_t i = 0; i < 3; ++i) {
        for (glm::length_t j = 0; j < 3; ++j) {
            if (!std::isfinite(transform.linear[i][j])) {
                return false;
            }
        }
        if (!std::isfinite(transform.translation[i])) {
            return false;
        }
    }
    return true;
}

class NodeWalk {
public:
    NodeWalk(Context& context, const Model& model, const std::map<std::uint32_t, Lamp>& lamps)
        : m_context(context), m_data(model.data), m_lamps(lamps) {}

    PlacedNodes place() {
        check_tree();
        struct Visit {
            int node;
            Transform parent;
        };
        // A stack of our own: a chain of nodes may be longer than the thread's stack is deep.
        std::vector<Visit> visits;
        const std::vector<int> roots = scene_roots();
        for (auto root = roots.rbegin(); root != roots.rend(); ++root) {
            visits.push_back({*root, {}});
        }
        while (!visits.empty()) {
            const Visit visit = visits.back();
            visits.pop_back();
            const tinygltf::Node& node = m_data.nodes.at(static_cast<std::size_t>(visit.node));
            const Transform local = local_transform(node);
            const Transform world{.linear = visit.parent.linear * local.linear,
                                  .translation = visit.parent.linear * local.translation + visit.parent.translation};
            if (!is_finite(world)) {
                m_context.fail("the transform, with those of its parents, is not finite (" + named(visit.node) + ')');
            }
            place(visit.node, node, world);
            for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) {
                visits.push_back({*child, world});
            }
        }
        return std::move(m_placed);
    }

private:
    [[nodiscard]] std::string named(int index) const {
        const auto i = static_cast<std::size_t>(index);
        return describe("node", i, m_data.nodes.at(i).name);
    }

    /// Every node has one parent at most and is reached from a node that has none: then there is no cycle.
    void check_tree() {
        const std::size_t count = m_data.nodes.size();
        m_has_parent.assign(count, false);
        for (std::size_t i = 0; i < count; ++i) {
            for (const int child : m_data.nodes[i].children) {
                if (m_has_parent.at(static_cast<std::size_t>(child))) {
                    m_context.fail("it is the child of more than one node, or twice of the same (" + named(child) +
                                   ')');
                }
                m_has_parent[static_cast<std::size_t>(child)] = true;
            }
        }
        std::vector<bool> reached(count, false);
        std::vector<int> open;
        for (std::size_t i = 0; i < count; ++i) {
            if (!m_has_parent[i]) {
                open.push_back(static_cast<int>(i));
            }
        }
        while (!open.empty()) {
            const auto node = static_cast<std::size_t>(open.back());
            open.pop_back();
            reached[node] = true;
            open.insert(open.end(), m_data.nodes[node].children.begin(), m_data.nodes[node].children.end());
        }
        const auto lost = std::find(reached.begin(), reached.end(), false);
        if (lost != reached.end()) {
            m_context.fail("it is in or under a cycle of nodes (" + named(static_cast<int>(lost - reached.begin())) +
                           ')');
        }
    }

    std::vector<int> scene_roots() {
        if (m_data.scenes.empty()) {
            std::vector<int> roots;
            for (std::size_t i = 0; i < m_data.nodes.size(); ++i) {
                if (!m_has_parent[i]) {
                    roots.push_back(static_cast<int>(i));
                }
            }
            if (!roots.empty()) {
                m_context.note("the document has no scene: all its nodes are taken");
            }
            return roots;
        }
        if (m_data.defaultScene < 0) {
            m_context.note("the document has no default scene: its first is taken");
        }
        const auto index = static_cast<std::size_t>(std::max(m_data.defaultScene, 0));
        const tinygltf::Scene& scene = m_data.scenes.at(index);
        std::vector<int> listed = scene.nodes;
        std::sort(listed.begin(), listed.end());
        const auto twice = std::adjacent_find(listed.begin(), listed.end());
        if (twice != listed.end()) {
            m_context.fail("the scene lists it twice (" + named(*twice) + ')');
        }
        for (const int node : listed) {
            if (m_has_parent.at(static_cast<std::size_t>(node))) {
                m_context.fail("the scene lists it, but it is no root node (" + named(node) + ')');
            }
        }
        return scene.nodes;
    }

    void place(int index, const tinygltf::Node& node, const Transform& world) {
        if (node.camera >= 0) {
            place_camera(index, node, world);
        }
        if (const auto lamp = m_lamps.find(static_cast<std::uint32_t>(index)); lamp != m_lamps.end()) {
            place(index, lamp->second, world);
        }
        if (wants_probe(node)) {
            m_placed.probes.push_back({.name = node.name.empty() ? "node " + std::to_string(index) : node.name,
                                       .position = world.translation,
                                       .source_node = static_cast<std::uint32_t>(index)});
        }
        if (node.mesh < 0) {
            return;
        }
        if (node.skin >= 0) {
            m_context.note(named(index) + " has a skin: its mesh is baked unskinned, where the node stands");
        }
        if (glm::determinant(world.linear) == 0.0) {
            m_context.note(named(index) + " is scaled to nothing in some direction");
        }
        m_placed.instances.push_back({.name = node.name.empty() ? "node " + std::to_string(index) : node.name,
                                      .mesh = static_cast<std::uint32_t>(node.mesh),
                                      .linear = world.linear,
                                      .translation = world.translation,
                                      .density = density_of(index, node),
                                      .source_node = static_cast<std::uint32_t>(index)});
    }

    static bool wants_probe(const tinygltf::Node& node) {
        if (!node.extras.Has("vkbake") || !node.extras.Get("vkbake").Has("probe")) {
            return false;
        }
        const tinygltf::Value& value = node.extras.Get("vkbake").Get("probe");
        return !value.IsBool() || value.Get<bool>();
    }

    /// What the node's extras.vkbake.density says, or else its mesh's.
    double density_of(int index, const tinygltf::Node& node) {
        for (const tinygltf::Value* extras :
             {&node.extras, &m_data.meshes.at(static_cast<std::size_t>(node.mesh)).extras}) {
            if (!extras->Has("vkbake") || !extras->Get("vkbake").Has("density")) {
                continue;
            }
            const tinygltf::Value& value = extras->Get("vkbake").Get("density");
            const double density = value.IsNumber() ? value.GetNumberAsDouble() : 0.0;
            if (density >= 1e-3 && density <= 1e3) {
                return density;
            }
            m_context.note("extras.vkbake.density of " + named(index) +
                           " or its mesh is no number from 0.001 to 1000: left out");
        }
        return 1.0;
    }

    void place(int index, Lamp lamp, const Transform& world) {
        if (place_lamp(lamp, world.linear, world.translation)) {
            m_placed.lamps.push_back(std::move(lamp));
        } else {
            m_context.note(named(index) + " holds a lamp that is scaled to nothing: left out");
        }
    }

    void place_camera(int index, const tinygltf::Node& node, const Transform& world) {
        const glm::dvec3 backward = world.linear[2];
        const glm::dvec3 right = glm::cross(world.linear[1], backward);
        const double width = glm::length(right);
        const double depth = glm::length(backward);
        if (!(width > 0.0 && depth > 0.0 && std::isfinite(width) && std::isfinite(depth))) {
            m_context.note(named(index) + " holds a camera that is scaled to nothing: left out");
            return;
        }
        const tinygltf::Camera& lens = m_data.cameras.at(static_cast<std::size_t>(node.camera));
        Camera camera;
        camera.name = !node.name.empty() ? node.name : lens.name;
        camera.orientation[0] = right / width;
        camera.orientation[2] = backward / depth;
        camera.orientation[1] = glm::cross(camera.orientation[2], camera.orientation[0]);
        camera.position = world.translation;
        if (lens.type == "orthographic") {
            camera.vertical_field_of_view = 0.0;
            camera.vertical_extent = 2.0 * std::abs(lens.orthographic.ymag);
            camera.near_plane = lens.orthographic.znear;
        } else {
            camera.vertical_field_of_view = lens.perspective.yfov;
            camera.near_plane = lens.perspective.znear;
        }
        m_placed.cameras.push_back(std::move(camera));
    }

    Context& m_context;
    const tinygltf::Model& m_data;
    const std::map<std::uint32_t, Lamp>& m_lamps;
    std::vector<bool> m_has_parent;
    PlacedNodes m_placed;
};

} // namespace

PlacedNodes place_nodes(Context& context, const Model& model, const std::map<std::uint32_t, Lamp>& lamps) {
    return NodeWalk(context, model, lamps).place();
}

} // namespace vkbake::gltf
