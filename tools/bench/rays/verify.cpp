#include "bench/rays/verify.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <mutex>

#include <fmt/format.h>

#include "base/parallel.hpp"

namespace vkbake::bench {
namespace {

constexpr std::size_t most_listed = 1000;

struct Asked {
    Ray ray;
    bool ours = false;
    bool embree = false;
};

std::vector<Asked> rays_to_judge(const RaySet& rays, const std::vector<BlockedRays>& ours,
                                 const std::vector<BlockedRays>& embree, std::size_t count) {
    std::vector<Asked> asked;
    count = std::min(count, rays.ray_count);
    std::size_t seen = 0;
    for (std::size_t b = 0; b < rays.blocks.size(); ++b) {
        const RayBlock& block = rays.blocks[b];
        for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
            const auto& [x, y, z] = block.direction[stratum];
            for (unsigned left = block.active[stratum]; left != 0; left &= left - 1) {
                const auto lane = static_cast<std::size_t>(std::countr_zero(left));
                const bool a = (ours[b][stratum] >> lane & 1U) != 0;
                const bool e = (embree[b][stratum] >> lane & 1U) != 0;
                const bool chosen = seen * count / rays.ray_count != (seen + 1) * count / rays.ray_count;
                ++seen;
                if (chosen || a != e) {
                    asked.push_back({{{block.origin[0][lane], block.origin[1][lane], block.origin[2][lane]},
                                      {x[lane], y[lane], z[lane]},
                                      block.max_distance,
                                      block.ignored_triangle[lane]},
                                     a,
                                     e});
                }
            }
        }
    }
    return asked;
}

} // namespace

bool Disagreement::excusable() const { return std::abs(slack.length) <= excusable_roundings * rounding_unit; }

std::string Disagreement::note() const {
    const auto word = [](bool blocked) { return blocked ? "blocked" : "free"; };
    return fmt::format("origin {} {} {} direction {} {} {}: ours {}, embree {}, double {}: {} triangle {} by {:.2f} "
                       "roundings{}",
                       ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y, ray.direction.z,
                       word(ours), word(embree), word(reference), reference ? "meets" : "misses", slack.triangle,
                       std::abs(slack.length) / rounding_unit, excusable() ? "" : " NOT EXCUSABLE");
}

Verdict verify(const RaySet& rays, const std::vector<BlockedRays>& ours, const std::vector<BlockedRays>& embree,
               std::size_t count, std::size_t brute) {
    const DoubleReference reference(rays.source->scene().surface);
    const std::vector<Asked> asked = rays_to_judge(rays, ours, embree, count);
    Verdict verdict{.rays = asked.size(), .brute_rays = std::min(brute, asked.size())};
    std::mutex mutex;
    parallel_ranges(asked.size(), 256, 0, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const bool blocked = reference.occluded(asked[i].ray);
            if (blocked == asked[i].ours && blocked == asked[i].embree) {
                continue;
            }
            const Slack slack = reference.surest(asked[i].ray);
            const std::lock_guard lock(mutex);
            verdict.ours_wrong += blocked != asked[i].ours ? 1 : 0;
            verdict.embree_wrong += blocked != asked[i].embree ? 1 : 0;
            if (verdict.disagreements.size() < most_listed) {
                verdict.disagreements.push_back({asked[i].ray, asked[i].ours, asked[i].embree, blocked, slack});
            }
        }
    });
    parallel_ranges(verdict.brute_rays, 1, 0, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Ray& ray = asked[i * asked.size() / verdict.brute_rays].ray;
            if (reference.occluded(ray) != reference.occluded_by_any(ray)) {
                const std::lock_guard lock(mutex);
                ++verdict.brute_differences;
            }
        }
    });
    return verdict;
}

} // namespace vkbake::bench
