// Plants of many loose leaves, and ground for them. Open surfaces, all with light-map UVs.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "make_scenes/document.hpp"

namespace vkbake::scenes {

struct PlantShape {
    double height = 5.0;  ///< of the stem, metres
    double radius = 0.14; ///< of the stem at its foot
    int stem_rings = 6;   ///< segments along the stem
    int branches = 10;    ///< from its upper part
    double reach = 1.9;   ///< length of a branch
    int leaves = 600;     ///< two triangles each
    double leaf_length = 0.30;
    Paint foliage = Paint::grass; ///< Paint::leaves: each leaf is a card with a sprig cut out of it
};

/// Stands on y = 0 at the origin; `number` varies it, but not its number of triangles.
[[nodiscard]] std::vector<Patch> make_plant(const PlantShape& shape, std::uint32_t number);

/// A gentle hill's height at a place, metres.
[[nodiscard]] double terrain_height(const glm::dvec2& place);

/// Ground of `cells` × `cells_z` cells, two triangles each, from the origin to `size` along X and Z.
[[nodiscard]] Patch make_terrain(const glm::ivec2& cells, const glm::dvec2& size);

} // namespace vkbake::scenes
