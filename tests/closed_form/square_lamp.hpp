// A square lamp over a floor, which it lights by Lambert's formula.
#pragma once

#include <utility>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "configuration_factors.hpp"
#include "host_bake.hpp"

namespace vkbake::test {

/// A black floor, 4 × 4.
inline Scene dark_floor() {
    Scene scene = scene_of(floor_of(2.0F));
    paint(scene, 0, {.base_color = glm::vec4(0, 0, 0, 1)});
    return scene;
}

inline Material glowing(float radiance) {
    Material material;
    material.base_color = glm::vec4(0, 0, 0, 1);
    material.emissive = glm::vec3(radiance);
    return material;
}

/// A square lamp that looks down.
inline void add_square_lamp(Scene& scene, double half, const glm::dvec3& at, const Material& material) {
    Primitive lamp = floor_of(static_cast<float>(half));
    for (std::size_t first = 0; first < lamp.indices.size(); first += 3) {
        std::swap(lamp.indices[first + 1], lamp.indices[first + 2]);
    }
    add_object(scene, "lamp", lamp, at);
    paint(scene, scene.meshes.size() - 1, material);
}

/// Configuration factor of such a lamp for a point of the floor.
inline double factor_of_lamp(double half, const glm::dvec3& lamp, const glm::dvec3& point) {
    const auto corner = [&](double x, double z) {
        return element_to_parallel_rectangle(lamp.x + x - point.x, lamp.z + z - point.z, lamp.y);
    };
    return corner(half, half) - corner(-half, half) - corner(half, -half) + corner(-half, -half);
}

} // namespace vkbake::test
