#include "closed_meshes.hpp"

#include <glm/mat3x3.hpp>

namespace vkbake::extremes {

namespace {

/// Two apexes and a rim of pairs of corners so near each other that every second triangle is 10⁷ times as long as wide.
ClosedMesh needles() {
    constexpr int pairs = 200; // as all meet in two corners, a ray there meets them all
    const glm::vec3 top(0.03F, 0.9F, -0.02F);
    const glm::vec3 bottom(-0.01F, -0.9F, 0.04F);
    const auto rim = [&](int i) {
        const double turn = static_cast<double>(i / 2 % pairs) / pairs;
        const float angle = static_cast<float>(6.283185307179586 * turn);
        glm::vec3 point(0.8F * std::cos(angle), 0.1F * std::sin(3.0F * angle), 0.8F * std::sin(angle));
        if (i % 2 != 0) { // one or two last places on
            point.x = std::nextafter(point.x, 2.0F);
            point.z = std::nextafter(point.z, 2.0F);
        }
        return point;
    };
    std::vector<glm::vec3> positions;
    for (int i = 0; i < 2 * pairs; ++i) {
        positions.insert(positions.end(), {top, rim(i + 1), rim(i), bottom, rim(i), rim(i + 1)});
    }
    return {test::make_triangles("needles 1:10^7", std::move(positions)), glm::vec3(0.0F), 0.02F};
}

ClosedMesh mapped_sphere(std::uint64_t seed) {
    test::Random random(seed);
    glm::mat3 map(0.0F);
    do {
        for (int column = 0; column < 3; ++column) {
            map[column] = random.point(0.5F) * (column == 2 ? 1e-3F : 1.0F);
        }
    } while (std::abs(glm::dot(glm::cross(map[0], map[1]), map[2])) < 5e-5F);
    const glm::vec3 middle = random.point(0.4F);
    std::vector<glm::vec3> positions = test::sphere(5, 1.0F, glm::vec3(0.0F)).positions;
    for (glm::vec3& position : positions) {
        position = map * position + middle;
    }
    return {test::make_triangles("sphere, affine map " + std::to_string(seed), std::move(positions)), middle, 1e-5F};
}

} // namespace

std::vector<ClosedMesh> closed_meshes() {
    std::vector<ClosedMesh> meshes;
    meshes.push_back({test::sphere(2, 1.0F, glm::vec3(0.0F)), glm::vec3(0.0F), 0.4F});
    meshes.push_back({test::sphere(9, 0.9F, {0.03F, 0.05F, -0.07F}), {0.03F, 0.05F, -0.07F}, 0.4F});
    meshes.push_back(needles());
    meshes.push_back({test::cube(8), glm::vec3(0.0F), 0.9F});
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        meshes.push_back(mapped_sphere(seed));
    }
    return meshes;
}

} // namespace vkbake::extremes
