// Accessors → vectors of floats and indices.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "load/model.hpp"

namespace vkbake::gltf {

/// They read accessor `index` (checked to fit its view) as vectors of 2, 3 or 4 numbers; normalised integers by the
/// rules of glTF 2.0 §3.6.2.2 (2/127 for a byte of 2; never below −1), others as they are. Without a view: zeros.
[[nodiscard]] std::vector<glm::vec2> read_vec2(const Model& model, std::size_t index);
[[nodiscard]] std::vector<glm::vec3> read_vec3(const Model& model, std::size_t index);
[[nodiscard]] std::vector<glm::vec4> read_vec4(const Model& model, std::size_t index);

/// Unsigned integers of 8, 16 or 32 bits.
[[nodiscard]] std::vector<std::uint32_t> read_indices(const Model& model, std::size_t index);

} // namespace vkbake::gltf
