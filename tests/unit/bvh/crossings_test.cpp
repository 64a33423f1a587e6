// All that a ray meets, shown to a filter.
#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "amount.hpp"
#include "highway_targets.hpp"
#include "unit/bvh/ray_scenes.hpp"

namespace vkbake::test {
namespace {

constexpr std::array kinds{Accelerator::brute, Accelerator::clusters, Accelerator::bvh};

class Collector final : public CrossingFilter {
public:
    explicit Collector(std::size_t most = 1000000) : m_most(most) {}
    [[nodiscard]] bool ends(const Crossing& crossing) override {
        m_crossings.push_back(crossing);
        return m_crossings.size() == m_most;
    }
    [[nodiscard]] const std::vector<Crossing>& crossings() const { return m_crossings; }
    [[nodiscard]] std::ptrdiff_t counted() const {
        return std::ranges::count_if(m_crossings, [](const Crossing& crossing) { return crossing.counts; });
    }

private:
    std::size_t m_most;
    std::vector<Crossing> m_crossings;
};

using Seen = std::tuple<std::uint32_t, std::uint32_t, float, bool, bool>;

std::vector<Seen> all_along(const TriangleAccelerator& accelerator, const Ray& ray) {
    Collector collector;
    EXPECT_FALSE(accelerator.filter(ray, collector));
    std::vector<Seen> seen;
    for (const Crossing& crossing : collector.crossings()) {
        seen.emplace_back(crossing.rank, crossing.hit.triangle, crossing.hit.distance, crossing.hit.back_side,
                          crossing.counts);
    }
    std::ranges::sort(seen);
    return seen;
}

TEST(Crossings, EveryAcceleratorShowsTheSame) {
    const Triangles triangles = make_triangles("soup", soup_positions(amount<std::size_t>(3000, 500), 0.5F, 5));
    const TriangleAccelerator oracle = accelerate(triangles, Accelerator::brute);
    for_every_target([&] {
        const TriangleAccelerator clusters = accelerate(triangles, Accelerator::clusters);
        const TriangleAccelerator hierarchy = accelerate(triangles, Accelerator::bvh);
        Random random(7);
        std::size_t crossings = 0;
        for (int i = 0; i < 300; ++i) {
            Ray ray{random.point(), random.direction()};
            ray.max_distance = i % 2 == 0 ? 0.75F : ray.max_distance;
            ray.ignored_triangle = static_cast<std::uint32_t>(random.below(triangles.count()));
            const std::vector<Seen> expected = all_along(oracle, ray);
            crossings += expected.size();
            EXPECT_EQ(all_along(clusters, ray), expected);
            EXPECT_EQ(all_along(hierarchy, ray), expected);
            EXPECT_EQ(hierarchy.occluded(ray), !expected.empty());
        }
        EXPECT_GT(crossings, 100U);
    });
}

TEST(Crossings, TheFilterEndsTheRay) {
    const Triangles triangles = make_triangles("soup", soup_positions(500, 1.0F, 5));
    for (const Accelerator kind : kinds) {
        const TriangleAccelerator accelerator = accelerate(triangles, kind);
        Random random(9);
        for (int i = 0; i < 50; ++i) {
            const Ray ray{random.point(), random.direction()};
            const std::size_t all = all_along(accelerator, ray).size();
            Collector two(2);
            EXPECT_EQ(accelerator.filter(ray, two), all >= 2);
            EXPECT_EQ(two.crossings().size(), std::min<std::size_t>(all, 2));
        }
    }
}

TEST(Crossings, OfTrianglesThatShareAnEdgeOneCounts) {
    // From within a closed mesh a ray crosses it once, also where it leaves through what triangles share.
    for (const Triangles& mesh : {cube(6), sphere(3, 1.0F, glm::vec3(0.0F)), needle_fan(60)}) {
        SCOPED_TRACE(mesh.name);
        std::size_t met_by_several = 0;
        for (const Accelerator kind : kinds) {
            const TriangleAccelerator accelerator = accelerate(mesh, kind);
            Random random(31);
            for (int i = 0; i < amount(2000, 300); ++i) {
                const glm::vec3 origin = i % 2 == 0 ? glm::vec3(0.0F) : random.point(0.02F);
                Collector collector;
                accelerator.filter({origin, shared_point(random, mesh) - origin}, collector);
                ASSERT_EQ(collector.counted(), 1) << i;
                met_by_several += collector.crossings().size() > 1 ? 1 : 0;
            }
        }
        EXPECT_GT(met_by_several, 100U);
    }
}

TEST(Crossings, ASilhouetteCountsTwiceOrNotAtAll) {
    // Rays along z past the edges and corners of a closed box, from outside: as often in as out.
    const Triangles mesh = cube(4);
    const TriangleAccelerator accelerator = accelerate(mesh, Accelerator::bvh);
    for (int x = -6; x <= 6; ++x) {
        for (int y = -6; y <= 6; ++y) {
            const Ray ray{{static_cast<float>(x) * 0.25F, static_cast<float>(y) * 0.25F, -3.0F}, {0.0F, 0.0F, 1.0F}};
            Collector collector;
            accelerator.filter(ray, collector);
            const int edge = std::max(std::abs(x), std::abs(y));
            const std::ptrdiff_t counted = collector.counted();
            EXPECT_TRUE(edge == 4 ? counted == 0 || counted == 2 : counted == (edge < 4 ? 2 : 0)) << x << " " << y;
        }
    }
}

TEST(Crossings, ASetOfSomeTrianglesMeetsThoseAlone) {
    const Triangles triangles = make_triangles("soup", soup_positions(400, 0.5F, 5));
    std::vector<std::uint32_t> some;
    std::ranges::copy_if(triangles.order, std::back_inserter(some), [](std::uint32_t n) { return n % 3 == 0; });
    for (const Accelerator kind : kinds) {
        const TriangleAccelerator all = accelerate(triangles, kind);
        const TriangleAccelerator part(triangles.positions, some, {kind, TriangleTest::watertight, 4, 0});
        EXPECT_EQ(part.statistics().triangles, some.size());
        Random random(3);
        for (int i = 0; i < 100; ++i) {
            const Ray ray{random.point(), random.direction(), std::numeric_limits<float>::infinity(), some[0]};
            std::vector<std::uint32_t> expected;
            for (const Seen& seen : all_along(all, ray)) {
                if (std::get<1>(seen) % 3 == 0) {
                    expected.push_back(std::get<1>(seen));
                }
            }
            std::vector<std::uint32_t> found;
            for (const Seen& seen : all_along(part, ray)) {
                found.push_back(std::get<1>(seen));
            }
            EXPECT_EQ(found, expected);
        }
    }
}

} // namespace
} // namespace vkbake::test
