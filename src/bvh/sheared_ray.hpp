// A ray with what the watertight triangle test computes once for it.
#pragma once

#include <glm/vec3.hpp>

#include "bvh/accelerator.hpp"

namespace vkbake {

/// Shear after Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection" (2013).
struct ShearedRay {
    glm::vec3 origin;
    glm::vec3 direction;
    float max_distance;
    std::uint32_t ignored_rank = no_triangle; ///< the triangle that is never met, by rank (see TriangleList)

    bool valid = false; ///< false: meets nothing, and the members below mean nothing

    int x_axis = 0, y_axis = 1,
        z_axis = 2; ///< z: of the largest component of the direction; x and y so that winding is kept
    float shear_x = 0.0F, shear_y = 0.0F; ///< slopes along z: x · (1 / z) and y · (1 / z)

    explicit ShearedRay(const Ray& ray);
    /// Of a valid ray whose axes and slopes are known; no triangle is ignored.
    ShearedRay(const Ray& ray, int x, int y, int z, float slope_x, float slope_y)
        : origin(ray.origin), direction(ray.direction), max_distance(ray.max_distance), valid(true), x_axis(x),
          y_axis(y), z_axis(z), shear_x(slope_x), shear_y(slope_y) {}
};

} // namespace vkbake
