// Every accelerator must answer every ray as brute force does, bit for bit.
#include <bit>

#include <gtest/gtest.h>

#include "unit/bvh/ray_scenes.hpp"

namespace vkbake::test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float denormal = std::numeric_limits<float>::denorm_min();

std::vector<Triangles> scenes() {
    std::vector<Triangles> all{soup(400, 0.2F, 1),
                               soup(60, 1.0F, 2),
                               needles(200, 3),
                               duplicates(60, 4),
                               sheet(6, 0, 0.25F),
                               sheet(6, 1, -1.0F),
                               sheet(6, 2, 0.0F),
                               sphere(2, 0.9F, {0.01F, -0.02F, 0.03F}),
                               needle_fan(60),
                               make_triangles("one", {{-1, -1, 0}, {1, -1, 0.5F}, {0, 1, -0.5F}}),
                               make_triangles("none", {})};
    all.push_back(join("walls", {sheet(3, 0, -1.0F), sheet(3, 0, 1.0F), sheet(3, 1, -1.0F), sheet(3, 2, 1.0F)}));
    std::vector<glm::vec3> small = soup_positions(100, 0.2F, 5);
    std::vector<glm::vec3> far = small;
    std::transform(small.begin(), small.end(), small.begin(), [](const glm::vec3& p) { return p * 0x1p-40F; });
    std::transform(far.begin(), far.end(), far.begin(), [](const glm::vec3& p) { return p + glm::vec3(1000.0F); });
    all.push_back(make_triangles("tiny", std::move(small)));
    all.push_back(make_triangles("far from the origin", std::move(far)));
    return all;
}

glm::vec3 any_corner(Random& random, const Triangles& triangles) {
    return triangles.positions.empty() ? glm::vec3(0.0F)
                                       : triangles.positions[random.below(triangles.positions.size())];
}

/// On a corner, an edge, or inside a triangle.
glm::vec3 any_point(Random& random, const Triangles& triangles) {
    if (triangles.count() == 0) {
        return random.point();
    }
    const auto [a, b, c] = triangles.corners(random.below(triangles.count()));
    const float s = random.between(0.0F, 1.0F);
    const float t = random.between(0.0F, 1.0F - s);
    switch (random.below(3)) {
    case 0:
        return a;
    case 1:
        return a + s * (b - a);
    default:
        return a + s * (b - a) + t * (c - a);
    }
}

glm::vec3 axis_direction(Random& random) {
    glm::vec3 direction(0.0F);
    for (int axis = 0; axis < 3; ++axis) {
        direction[axis] = random.below(2) == 0 ? 0.0F : -0.0F;
    }
    direction[static_cast<int>(random.below(3))] = random.below(2) == 0 ? 1.0F : -1.0F;
    return direction;
}

Ray any_ray(Random& random, const Triangles& triangles) {
    const float scale = std::max(glm::length(any_corner(random, triangles)), 0x1p-45F);
    glm::vec3 origin = any_corner(random, triangles) + random.point(scale);
    if (random.below(3) == 0) { // in the planes of boxes
        const glm::vec3 corner = any_corner(random, triangles);
        const std::size_t axes = random.below(7) + 1;
        for (int axis = 0; axis < 3; ++axis) {
            origin[axis] = ((axes >> static_cast<unsigned>(axis)) & 1U) != 0 ? corner[axis] : origin[axis];
        }
    }
    Ray ray{origin, random.direction(), infinity};
    switch (random.below(8)) {
    case 0:
        ray.direction = axis_direction(random);
        break;
    case 1: // nearly parallel to an axis
        ray.direction = axis_direction(random) + random.point(random.below(2) == 0 ? 1e-7F : 1e-30F);
        break;
    case 2:
        ray.direction[static_cast<int>(random.below(3))] = random.below(2) == 0 ? denormal : -1000.0F * denormal;
        break;
    case 3: // in a plane
        ray.direction[static_cast<int>(random.below(3))] = random.below(2) == 0 ? 0.0F : -0.0F;
        break;
    case 4:
    case 5:
        ray.direction = any_point(random, triangles) - origin;
        break;
    case 6: // along an edge, or nearly
        ray.direction = any_corner(random, triangles) - any_corner(random, triangles);
        break;
    default:
        ray.direction *= random.below(2) == 0 ? 0x1p-59F : 0x1p59F;
        break;
    }
    return ray;
}

/// Compares the answers to a ray and to rays that end at, just before and just behind what it meets.
class Agreement {
public:
    Agreement(const Triangles& triangles, Accelerator kind, TriangleTest test, int splits = 4)
        : m_oracle(accelerate(triangles, Accelerator::brute, test)),
          m_subject(accelerate(triangles, kind, test, 0, splits)) {}

    void check(Ray ray) {
        const std::optional<Hit> hit = check_one(ray);
        if (!hit) {
            return;
        }
        ++m_hits;
        for (const float end :
             {hit->distance, std::nextafter(hit->distance, 0.0F), std::nextafter(hit->distance, infinity)}) {
            ray.max_distance = end;
            check_one(ray);
        }
    }
    [[nodiscard]] int hits() const { return m_hits; }
    [[nodiscard]] int differences() const { return m_differences; }

private:
    std::optional<Hit> check_one(const Ray& ray) {
        const std::optional<Hit> expected = m_oracle.nearest(ray);
        const std::optional<Hit> found = m_subject.nearest(ray);
        const bool same =
            found.has_value() == expected.has_value() &&
            (!found ||
             (found->triangle == expected->triangle && found->back_side == expected->back_side &&
              std::bit_cast<std::uint32_t>(found->distance) == std::bit_cast<std::uint32_t>(expected->distance)));
        const bool blocked = m_oracle.occluded(ray);
        if (!same || blocked != expected.has_value() || blocked != m_subject.occluded(ray)) {
            ++m_differences;
        }
        return expected;
    }

    TriangleAccelerator m_oracle;
    TriangleAccelerator m_subject;
    int m_hits = 0;
    int m_differences = 0;
};

void expect_agreement(Accelerator kind, TriangleTest test, int splits) {
    for (const Triangles& triangles : scenes()) {
        SCOPED_TRACE(triangles.name);
        Agreement agreement(triangles, kind, test, splits);
        Random random(7);
        constexpr int rays = 600;
        for (int i = 0; i < rays; ++i) {
            agreement.check(any_ray(random, triangles));
        }
        EXPECT_EQ(agreement.differences(), 0);
        if (triangles.count() > 0) {
            EXPECT_GT(agreement.hits(), rays / 20);
        }
    }
}

/// One triangle ten thousand times: neither found more than once nor at another place, and the first of them.
TEST(RaysAgreement, TenThousandInOnePlaceAreAsOne) {
    const std::vector<glm::vec3> corners{{-0.5F, 0.0F, 0.0F}, {0.5F, 0.0F, 0.0F}, {0.0F, 0.5F, 0.25F}};
    const Triangles one = make_triangles("one", corners);
    std::vector<glm::vec3> many;
    for (int copy = 0; copy < 10000; ++copy) {
        many.insert(many.end(), corners.begin(), corners.end());
    }
    const Triangles all = make_triangles("many", std::move(many));
    const TriangleAccelerator expected = accelerate(one, Accelerator::bvh);
    for (const Accelerator kind : {Accelerator::brute, Accelerator::clusters, Accelerator::bvh}) {
        const TriangleAccelerator found = accelerate(all, kind);
        Random random(9);
        for (int i = 0; i < 100; ++i) {
            const Ray ray = any_ray(random, one);
            const std::optional<Hit> hit = found.nearest(ray);
            const std::optional<Hit> single = expected.nearest(ray);
            ASSERT_EQ(hit.has_value(), single.has_value());
            ASSERT_TRUE(!hit || (hit->triangle == 0U && hit->distance == single->distance));
        }
    }
}

TEST(RaysAgreement, ClustersWatertight) { expect_agreement(Accelerator::clusters, TriangleTest::watertight, 4); }
TEST(RaysAgreement, ClustersWatertightFine) { expect_agreement(Accelerator::clusters, TriangleTest::watertight, 16); }
TEST(RaysAgreement, Hierarchy) { expect_agreement(Accelerator::bvh, TriangleTest::watertight, 4); }
TEST(RaysAgreement, HierarchyOfOneCluster) { expect_agreement(Accelerator::bvh, TriangleTest::watertight, 1); }
TEST(RaysAgreement, ClustersMollerTrumbore) {
    expect_agreement(Accelerator::clusters, TriangleTest::moller_trumbore, 8);
}

} // namespace
} // namespace vkbake::test
