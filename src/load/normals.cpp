#include "load/normals.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace vkbake::gltf {

namespace {

bool is_usable(const glm::vec3& normal) {
    return std::isfinite(normal.x) && std::isfinite(normal.y) && std::isfinite(normal.z) && normal != glm::vec3(0.0F);
}

/// For each vertex the sum of its triangles' cross products, which are twice their areas long.
std::vector<glm::dvec3> area_weighted_normals(const Primitive& primitive) {
    std::vector<glm::dvec3> sums(primitive.positions.size(), glm::dvec3(0.0));
    for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
        const glm::dvec3 a = primitive.positions[primitive.indices[i]];
        const glm::dvec3 b = primitive.positions[primitive.indices[i + 1]];
        const glm::dvec3 c = primitive.positions[primitive.indices[i + 2]];
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        for (std::size_t corner = 0; corner < 3; ++corner) {
            sums[primitive.indices[i + corner]] += normal;
        }
    }
    return sums;
}

} // namespace

void repair_normals(Context& context, const std::string& where, Primitive& primitive) {
    const auto unusable =
        static_cast<std::size_t>(std::count_if(primitive.normals.begin(), primitive.normals.end(),
                                               [](const glm::vec3& normal) { return !is_usable(normal); }));
    if (unusable == 0) {
        return;
    }
    const std::string count =
        std::to_string(unusable) + " of its " + std::to_string(primitive.normals.size()) + " normals";
    if (unusable > primitive.normals.size() / 2) {
        context.note(where + ": " + count + " are 0 or not finite; it gets flat ones");
        primitive.normals.clear();
        return;
    }
    context.note(where + ": " + count + " are 0 or not finite; their triangles' mean is taken");
    const std::vector<glm::dvec3> sums = area_weighted_normals(primitive);
    for (std::size_t i = 0; i < primitive.normals.size(); ++i) {
        if (is_usable(primitive.normals[i])) {
            continue;
        }
        // A vertex of no triangle that has an area: no ray will ever ask for its normal.
        const double largest = std::max({std::abs(sums[i].x), std::abs(sums[i].y), std::abs(sums[i].z)});
        primitive.normals[i] =
            largest > 0.0 ? glm::vec3(glm::normalize(sums[i] / largest)) : glm::vec3(0.0F, 1.0F, 0.0F);
    }
}

} // namespace vkbake::gltf
