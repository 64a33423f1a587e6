// What the kinds of accelerator have in common.
#pragma once

#include <span>

#include "bvh/accelerator.hpp"
#include "bvh/prepared_ray.hpp"
#include "bvh/triangle_test.hpp"

namespace vkbake {

/// For each lane of a block what ShearedRay::ignored_rank is for a ray.
using IgnoredRanks = std::array<std::uint32_t, RayBlock::lanes>;

/// Shows a filter what is met, by rank.
struct RankedFilter {
    std::span<const std::uint32_t> numbers; ///< by rank: TriangleList::numbers
    CrossingFilter& filter;

    /// Of a hit.
    [[nodiscard]] bool ends(const TriangleHit& hit, std::uint32_t rank, bool counts) const {
        return filter.ends({{numbers[rank], hit.distance, hit.back_side}, rank, counts});
    }
};

/// Shows the triangle where it is met.
[[nodiscard]] inline bool filter_triangle(TriangleTest test, const PreparedRay& ray, const Triangle& triangle,
                                          std::uint32_t rank, const RankedFilter& filter) {
    const TriangleHit hit = test_triangle(test, ray, triangle);
    return hit.hit && filter.ends(hit, rank, test != TriangleTest::watertight || counts(ray, triangle));
}

/// Answers prepared, valid rays by ranks.
class RayCaster {
public:
    RayCaster() = default;
    virtual ~RayCaster() = default;
    RayCaster(const RayCaster&) = delete;
    RayCaster& operator=(const RayCaster&) = delete;

    [[nodiscard]] virtual bool occluded(const PreparedRay& ray) const = 0;
    [[nodiscard]] virtual NearestHit nearest(const PreparedRay& ray) const = 0;
    [[nodiscard]] virtual bool filter(const PreparedRay& ray, const RankedFilter& filter) const = 0;
    /// Each ray of the block, of triangles that lie in `bounds`; one after the other unless a caster knows better.
    [[nodiscard]] virtual BlockedRays blocked(const RayBlock& block, const IgnoredRanks& ignored, const Box& bounds,
                                              BlockScratch& scratch) const;
    [[nodiscard]] virtual BlockScratch make_scratch() const { return {}; }
    /// `triangles` is not set.
    [[nodiscard]] virtual AcceleratorStatistics statistics() const = 0;
};

} // namespace vkbake
