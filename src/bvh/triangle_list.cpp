#include "bvh/triangle_list.hpp"

#include <glm/geometric.hpp>

#include "vkbake/error.hpp"

namespace vkbake {
namespace {

// Differences of floats and products of two equal real numbers round alike in double, so exactly collinear corners give
// exactly zero (unless their exponents are more than 29 apart).
bool has_area(const Triangle& triangle) {
    const glm::dvec3 origin(triangle.corners[0]);
    const glm::dvec3 normal =
        glm::cross(glm::dvec3(triangle.corners[1]) - origin, glm::dvec3(triangle.corners[2]) - origin);
    return normal != glm::dvec3(0.0);
}

} // namespace

TriangleList list_triangles(std::span<const glm::vec3> positions, std::span<const std::uint32_t> canonical_order) {
    if (positions.size() != 3 * canonical_order.size()) {
        throw Error(ErrorKind::bake_failed,
                    "accelerator: the canonical order and the positions differ in length; report this");
    }
    TriangleList list;
    list.triangles.reserve(canonical_order.size());
    list.numbers.reserve(canonical_order.size());
    for (const std::uint32_t number : canonical_order) {
        if (number >= canonical_order.size()) {
            throw Error(ErrorKind::bake_failed,
                        "accelerator: the canonical order names a missing triangle; report this");
        }
        const std::size_t first = 3 * static_cast<std::size_t>(number);
        const Triangle triangle{{positions[first], positions[first + 1], positions[first + 2]}};
        if (has_area(triangle)) {
            list.triangles.push_back(triangle);
            list.numbers.push_back(number);
            list.bounds.add(triangle.bounds());
        }
    }
    return list;
}

} // namespace vkbake
