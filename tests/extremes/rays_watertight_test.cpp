// No ray leaves a closed mesh through an edge or a corner that triangles share.
#include <gtest/gtest.h>

#include "amount.hpp"
#include "unit/bvh/ray_scenes.hpp"

namespace vkbake::test {
namespace {

constexpr int many = amount(100000, 10000);
constexpr int some = amount(10000, 2000);

int escapes(const Triangles& mesh, Accelerator kind, int rays, float inner, const glm::vec3& middle = {}) {
    const TriangleAccelerator accelerator = accelerate(mesh, kind);
    Random random(31);
    int escaped = 0;
    for (int i = 0; i < rays; ++i) {
        const glm::vec3 origin = i % 8 == 0 ? middle : middle + random.point(inner);
        const Ray ray{origin, shared_point(random, mesh) - origin};
        escaped += accelerator.occluded(ray) && accelerator.nearest(ray) ? 0 : 1;
    }
    return escaped;
}

TEST(RaysWatertight, NoneLeavesASphere) {
    EXPECT_EQ(escapes(sphere(4, 1.0F, glm::vec3(0.0F)), Accelerator::bvh, many, 0.5F), 0);
    EXPECT_EQ(escapes(sphere(5, 0.9F, {0.03F, 0.05F, -0.07F}), Accelerator::bvh, many, 0.5F), 0);
    EXPECT_EQ(escapes(sphere(2, 1.0F, glm::vec3(0.0F)), Accelerator::brute, some, 0.5F), 0);
    EXPECT_EQ(escapes(sphere(2, 1.0F, glm::vec3(0.0F)), Accelerator::clusters, some, 0.5F), 0);
}

TEST(RaysWatertight, NoneLeavesAFanOfNeedles) {
    EXPECT_EQ(escapes(needle_fan(300), Accelerator::bvh, many, 0.02F), 0);
    EXPECT_EQ(escapes(needle_fan(100), Accelerator::clusters, some, 0.02F), 0);
}

TEST(RaysWatertight, NoneLeavesNeedlesOfOneToTenMillion) {
    EXPECT_EQ(escapes(needle_pairs(100), Accelerator::bvh, some, 0.02F), 0);
    EXPECT_EQ(escapes(needle_pairs(20), Accelerator::clusters, some, 0.02F), 0);
}

TEST(RaysWatertight, NoneLeavesASphereAfterARandomAffineMap) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const MappedSphere mapped = mapped_sphere(4, seed);
        EXPECT_EQ(escapes(mapped.triangles, Accelerator::bvh, some, 1e-5F, mapped.middle), 0) << seed;
    }
}

TEST(RaysWatertight, NoneLeavesACubeThroughItsDiagonalsAndEdges) {
    // from 0 the coordinates are exact, so many edge functions are exactly 0
    EXPECT_EQ(escapes(cube(8), Accelerator::bvh, many, 0.9F), 0);
    EXPECT_EQ(escapes(cube(8), Accelerator::bvh, some, 0.0F), 0);
    EXPECT_EQ(escapes(cube(2), Accelerator::clusters, some, 0.9F), 0);
}

TEST(RaysWatertight, TinyAndFarAway) {
    std::vector<glm::vec3> tiny = sphere(4, 1.0F, glm::vec3(0.0F)).positions;
    for (glm::vec3& position : tiny) {
        position *= 0x1p-50F;
    }
    EXPECT_EQ(escapes(make_triangles("tiny", std::move(tiny)), Accelerator::bvh, many, 0x1p-51F), 0);

    const glm::vec3 far(100.0F);
    EXPECT_EQ(escapes(sphere(4, 1.0F, far), Accelerator::bvh, many, 0.5F, far), 0);
}

} // namespace
} // namespace vkbake::test
