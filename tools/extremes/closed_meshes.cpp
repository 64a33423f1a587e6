#include "closed_meshes.hpp"

#include <utility>

namespace vkbake::extremes {

std::vector<ClosedMesh> closed_meshes() {
    std::vector<ClosedMesh> meshes;
    meshes.push_back({test::sphere(2, 1.0F, glm::vec3(0.0F)), glm::vec3(0.0F), 0.4F});
    meshes.push_back({test::sphere(9, 0.9F, {0.03F, 0.05F, -0.07F}), {0.03F, 0.05F, -0.07F}, 0.4F});
    // 200 pairs: as all meet in two corners, a ray there meets them all
    meshes.push_back({test::needle_pairs(200), glm::vec3(0.0F), 0.02F});
    meshes.push_back({test::cube(8), glm::vec3(0.0F), 0.9F});
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        test::MappedSphere mapped = test::mapped_sphere(5, seed);
        meshes.push_back({std::move(mapped.triangles), mapped.middle, 1e-5F});
    }
    return meshes;
}

} // namespace vkbake::extremes
