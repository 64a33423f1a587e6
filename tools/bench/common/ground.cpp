#include "bench/common/ground.hpp"

#include <algorithm>
#include <limits>

#include <glm/common.hpp>

namespace vkbake::bench {
namespace {

struct Extent {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};
};

Extent extent_of(const Scene& scene) {
    Extent extent;
    for (const Instance& instance : scene.instances) {
        for (const Primitive& primitive : scene.meshes[instance.mesh].primitives) {
            for (const std::uint32_t index : primitive.indices) {
                const glm::dvec3 point =
                    instance.linear * glm::dvec3(primitive.positions[index]) + instance.translation;
                extent.low = glm::min(extent.low, point);
                extent.high = glm::max(extent.high, point);
            }
        }
    }
    return extent;
}

} // namespace

void add_ground(Scene& scene) {
    const Extent extent = extent_of(scene);
    const glm::dvec3 size = extent.high - extent.low;
    const double width = 3.0 * std::max(size.x, size.z);
    const auto half = static_cast<float>(width / 2.0);

    Primitive square;
    square.positions = {{-half, 0.0F, -half}, {-half, 0.0F, half}, {half, 0.0F, half}, {half, 0.0F, -half}};
    square.indices = {0, 1, 2, 0, 2, 3};
    Instance instance;
    instance.name = "ground";
    instance.mesh = static_cast<std::uint32_t>(scene.meshes.size());
    instance.translation = 0.5 * (extent.low + extent.high);
    instance.translation.y = extent.low.y - 0.001 * width;
    scene.meshes.push_back({.name = "ground", .primitives = {square}});
    scene.instances.push_back(instance);
    scene.source.reset(); // it does not know of the ground
}

} // namespace vkbake::bench
