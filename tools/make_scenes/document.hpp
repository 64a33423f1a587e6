// A glTF file in the making.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "base/gltf_element.hpp"
#include "base/json.hpp"
#include "make_scenes/paint.hpp"
#include "make_scenes/solid.hpp"

namespace vkbake::scenes {

/// Triangles of one paint as glTF holds them.
struct Patch {
    Paint paint = Paint::white;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> tex_coords_0; ///< empty where the paint has no texture
    std::vector<glm::vec2> tex_coords_1; ///< empty, or light-map UVs
    std::vector<std::uint32_t> indices;
};

/// A model's triangles by paint: positions on a grid of 1/16384 m, normals smooth or sharp by each solid's crease,
/// texture coordinates by projection along the normal, in metres.
[[nodiscard]] std::vector<Patch> patches_of(const Model& model);

struct Node {
    std::string name;
    std::optional<std::size_t> mesh;
    std::optional<std::size_t> camera;
    std::optional<std::size_t> light;
    bool probe = false; ///< a light probe stands there
    glm::dvec3 translation{0.0};
    glm::dvec4 rotation{0.0, 0.0, 0.0, 1.0}; ///< unit quaternion x y z w
    glm::dvec3 scale{1.0};
    std::optional<std::size_t> parent;
};

/// A rotation about +Y by an angle in turns, as a quaternion.
[[nodiscard]] glm::dvec4 rotation_about_y(double turns);

/// What turns −Z from `eye` to `target` and leaves X level.
[[nodiscard]] glm::dvec4 rotation_towards(const glm::dvec3& eye, const glm::dvec3& target);

class Document {
public:
    [[nodiscard]] std::size_t add_mesh(const std::string& name, const std::vector<Patch>& patches);
    [[nodiscard]] std::size_t add_mesh(const Model& model) { return add_mesh(model.name, patches_of(model)); }
    std::size_t add_node(const Node& node);
    /// As KHR_lights_punctual has it.
    [[nodiscard]] std::size_t add_light(const Json& light);
    /// A node "main" with a 16:9 perspective camera at `eye` that looks at `target`.
    void add_main_camera(const glm::dvec3& eye, const glm::dvec3& target, double vertical_field_of_view = 0.7);
    [[nodiscard]] std::vector<std::byte> to_glb() const;

private:
    std::size_t add_view(const void* data, std::size_t size, gltf::ViewTarget target);
    template<class T>
    std::size_t add_accessor(const std::vector<T>& values, const char* type, bool with_bounds);
    std::size_t add_indices(const Patch& patch);
    std::size_t material(Paint paint);
    void use_extension(const char* name);
    std::size_t texture(Texture kind);

    Json m_json = Json::object();
    std::vector<std::byte> m_binary;
    std::map<Paint, std::size_t> m_materials;
    std::map<Texture, std::size_t> m_textures;
};

} // namespace vkbake::scenes
