// The long form of tests/extremes: rays at the edges and corners of closed meshes. None may leave, and whoever answers
// must answer alike: blocks of rays in every instruction set, single rays, clusters and brute force.
#include <atomic>
#include <bit>
#include <chrono>
#include <cstdlib>
#include <exception>

#include <fmt/format.h>

#include "base/parallel.hpp"
// Before Highway.
#include "base/simd_targets.hpp"
#include "bvh/each_ray.hpp"

#include <hwy/highway.h>

#include "closed_meshes.hpp"

namespace vkbake::extremes {
namespace {

struct Counts {
    std::atomic<std::uint64_t> rays{0};
    std::atomic<std::uint64_t> leaks{0};
    std::atomic<std::uint64_t> compared{0};
    std::atomic<std::uint64_t> differences{0};
};

RayBlock make_block(test::Random& random, const ClosedMesh& mesh) {
    RayBlock block;
    for (std::size_t lane = 0; lane < RayBlock::lanes; ++lane) {
        const glm::vec3 origin = mesh.middle + (lane == 0 ? glm::vec3(0.0F) : random.point(mesh.inner));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            block.origin[axis][lane] = origin[static_cast<int>(axis)];
        }
        for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
            const glm::vec3 direction = test::shared_point(random, mesh.triangles) - origin;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                block.direction[stratum][axis][lane] = direction[static_cast<int>(axis)];
            }
        }
    }
    block.active.fill(0xFFFFU);
    return block;
}

std::uint64_t count(const BlockedRays& rays) {
    std::uint64_t sum = 0;
    for (const RayBlock::LaneBits bits : rays) {
        sum += static_cast<std::uint64_t>(std::popcount(bits));
    }
    return sum;
}

/// `blocks` of 256 rays by the instruction set in force; of every thousandth block each ray alone by all accelerators.
void trace(const ClosedMesh& mesh, std::uint64_t blocks, std::uint64_t seed, bool with_brute, Counts& counts) {
    const TriangleAccelerator bvh = accelerate(mesh.triangles, Accelerator::bvh);
    const TriangleAccelerator clusters = accelerate(mesh.triangles, Accelerator::clusters);
    const TriangleAccelerator brute = accelerate(mesh.triangles, Accelerator::brute);
    parallel_ranges(static_cast<std::size_t>(blocks), 256, 0, [&](std::size_t begin, std::size_t end) {
        BlockScratch scratch = bvh.make_scratch();
        for (std::size_t number = begin; number < end; ++number) {
            test::Random random(mix64(seed) ^ (number * 0x9E3779B97F4A7C15ULL));
            const RayBlock block = make_block(random, mesh);
            const BlockedRays blocked = bvh.blocked(block, scratch);
            counts.rays += RayBlock::rays;
            counts.leaks += RayBlock::rays - count(blocked);
            if (number % 1000 != 0) {
                continue;
            }
            for (std::size_t i = 0; i < RayBlock::rays; i += with_brute ? 1 : 61) {
                const std::size_t stratum = i / RayBlock::lanes;
                const std::size_t lane = i % RayBlock::lanes;
                const Ray ray = ray_of(block, stratum, lane);
                const bool expected = ((blocked[stratum] >> lane) & 1U) != 0;
                const auto nearest = bvh.nearest(ray);
                const auto same = [&](const std::optional<Hit>& hit) {
                    return hit.has_value() == expected &&
                           (!hit || (hit->triangle == nearest->triangle && hit->distance == nearest->distance));
                };
                ++counts.compared;
                counts.differences += bvh.occluded(ray) == expected && nearest.has_value() == expected &&
                                              same(clusters.nearest(ray)) && same(brute.nearest(ray))
                                          ? 0U
                                          : 1U;
            }
        }
    });
}

std::vector<std::int64_t> instruction_sets() {
    std::vector<std::int64_t> sets;
    hwy::SetSupportedTargetsForTest(0);
    for (std::int64_t rest = hwy::SupportedTargets() & HWY_TARGETS; rest != 0; rest &= rest - 1) {
        sets.push_back(rest & -rest);
    }
    return sets;
}

int run(std::uint64_t rays) {
    const std::vector<ClosedMesh> meshes = closed_meshes();
    const std::vector<std::int64_t> sets = instruction_sets();
    const std::uint64_t blocks = rays / RayBlock::rays / meshes.size() / sets.size() + 1;
    fmt::print("| mesh | triangles | instruction set | rays | leaks | compared | differences | seconds |\n"
               "|---|---|---|---|---|---|---|---|\n");
    std::uint64_t faults = 0;
    std::uint64_t all = 0;
    for (const ClosedMesh& mesh : meshes) {
        for (const std::int64_t set : sets) {
            hwy::SetSupportedTargetsForTest(set);
            hwy::GetChosenTarget().Update(hwy::SupportedTargets());
            const auto start = std::chrono::steady_clock::now();
            Counts counts;
            trace(mesh, blocks, 1, mesh.triangles.count() < 1000, counts);
            const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            fmt::print("| {} | {} | {} | {} | {} | {} | {} | {:.1f} |\n", mesh.triangles.name, mesh.triangles.count(),
                       hwy::TargetName(set), counts.rays.load(), counts.leaks.load(), counts.compared.load(),
                       counts.differences.load(), seconds);
            std::fflush(stdout);
            faults += counts.leaks + counts.differences;
            all += counts.rays;
        }
    }
    fmt::print("\n{} rays, {} faults\n", all, faults);
    return faults == 0 ? 0 : 1;
}

} // namespace
} // namespace vkbake::extremes

int main(int argument_count, char** arguments) {
    try {
        const std::uint64_t rays = argument_count == 2 ? std::strtoull(arguments[1], nullptr, 10) : 0;
        if (rays > 0) {
            return vkbake::extremes::run(rays);
        }
        fmt::print(stderr, "usage: vkbake_extremes RAYS\n");
        return 2;
    } catch (const std::exception& error) {
        fmt::print(stderr, "vkbake_extremes: {}\n", error.what());
        return 1;
    }
}
