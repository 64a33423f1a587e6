// Reads the made files back with as little code as will do: what the tests expect must not come from the loader they
// serve.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/json.hpp"

namespace vkbake::test {

struct Corner {
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec2 light_map_uv;
};

using Face = std::array<Corner, 3>; ///< counter-clockwise from the front

struct Glb {
    Json json;
    std::string binary;
};

[[nodiscard]] std::string read_bytes(const std::string& path);
[[nodiscard]] Glb parse_glb(const std::string& bytes);

/// The triangles of one mesh over all its primitives, in its own space.
[[nodiscard]] std::vector<Face> faces_of_mesh(const Glb& glb, std::size_t mesh);

/// The triangles of all nodes, in the world.
[[nodiscard]] std::vector<Face> faces_of_scene(const Glb& glb);

} // namespace vkbake::test
