// One texel's light: its rays in order, summed in order.
#pragma once

#include <cstdint>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "bvh/accelerator.hpp"
#include "vkbake/lightmap.hpp"

namespace vkbake {

/// What was seen while tracing; sums of these do not depend on their order.
struct RayCounts {
    std::uint64_t rays = 0;
    std::uint64_t occluded_rays = 0;
    std::uint64_t skipped_directions = 0;
    std::uint64_t probed_hits = 0;
    std::uint64_t back_side_hits = 0;

    RayCounts& operator+=(const RayCounts& other) {
        rays += other.rays;
        occluded_rays += other.occluded_rays;
        skipped_directions += other.skipped_directions;
        probed_hits += other.probed_hits;
        back_side_hits += other.back_side_hits;
        return *this;
    }
};

/// Every 16th sample asks for its nearest hit, to see whether it is a back side. By the sample's number, so that the
/// count is the same for every schedule; these samples share one sixteenth of one of the square's axes, which the
/// scramble chooses for each texel, so they are even over a map but not within a texel.
inline constexpr std::uint32_t probe_interval = 16;

/// Whether the ray is blocked; of a hit that was probed, whether it met a back side is counted.
[[nodiscard]] inline bool probe(const TriangleAccelerator& accelerator, const Ray& ray, RayCounts& counts) {
    const std::optional<Hit> hit = accelerator.nearest(ray);
    if (!hit) {
        return false;
    }
    ++counts.probed_hits;
    counts.back_side_hits += hit->back_side ? 1 : 0;
    return true;
}

/// The weighted sum of the radiance that arrives, not yet scaled. `directions`: one texel's samples
/// (trace/sampler.hpp); `radiance`: a sky's look-up. In double: the sum's rounding stays far below a float's for any
/// number of rays.
template<typename Directions, typename Radiance>
[[nodiscard]] glm::dvec3 gather(const TriangleAccelerator& accelerator, const glm::vec3& origin,
                                const glm::vec3& geometric_normal, const Directions& directions, std::uint32_t count,
                                const Radiance& radiance, float max_distance, RayCounts& counts) {
    glm::dvec3 sum(0.0);
    for (std::uint32_t index = 0; index < count; ++index) {
        const auto sample = directions.sample(index);
        if (!(glm::dot(sample.direction, geometric_normal) > 0.0F)) {
            ++counts.skipped_directions;
            continue;
        }
        const Ray ray{origin, sample.direction, max_distance};
        ++counts.rays;
        const bool blocked = index % probe_interval == 0 ? probe(accelerator, ray, counts) : accelerator.occluded(ray);
        if (blocked) {
            ++counts.occluded_rays;
        } else {
            sum += sample.weight * glm::dvec3(radiance(sample.direction));
        }
    }
    return sum;
}

} // namespace vkbake
