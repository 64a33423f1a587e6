#include "bench/rays/builds.hpp"

#include <algorithm>
#include <chrono>

#include "bench/common/allocation_meter.hpp"
#include "bench/rays/embree_scene.hpp"
#include "bvh/accelerator.hpp"

namespace vkbake::bench {
namespace {

constexpr std::size_t least_repetitions = 3;
constexpr std::size_t most_repetitions = 15;

double since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void build_ours(const Surface& surface, BuildFigures& figures) {
    const std::int64_t before = allocations().bytes;
    reset_peak();
    const auto start = std::chrono::steady_clock::now();
    const TriangleAccelerator built(surface.positions, surface.canonical_order, {.threads = figures.threads});
    figures.seconds.push_back(since(start));
    figures.bytes = static_cast<std::int64_t>(built.statistics().bytes);
    figures.peak_bytes = std::max(figures.peak_bytes, allocations().peak - before);
}

void build_embree(const EmbreeTriangles& triangles, bool robust, BuildFigures& figures) {
    const EmbreeDevice device(figures.threads); // each on its own, so that none reuses another's memory
    const EmbreeScene scene(device, triangles, {robust, RTC_BUILD_QUALITY_HIGH});
    figures.seconds.push_back(scene.build_seconds());
    figures.bytes = device.bytes();
    figures.peak_bytes = std::max(figures.peak_bytes, device.peak_bytes());
}

} // namespace

std::vector<BuildFigures> compare_builds(const Surface& surface, const std::vector<int>& threads, double budget) {
    const EmbreeTriangles triangles(surface);
    std::vector<BuildFigures> all;
    for (const int count : threads) {
        BuildFigures ours{.who = "ours", .threads = count};
        BuildFigures robust{.who = "embree robust, high", .threads = count};
        BuildFigures fast{.who = "embree fast, high", .threads = count};
        const auto start = std::chrono::steady_clock::now();
        while (ours.seconds.size() < least_repetitions ||
               (since(start) < budget && ours.seconds.size() < most_repetitions)) {
            build_ours(surface, ours);
            build_embree(triangles, true, robust);
            build_embree(triangles, false, fast);
        }
        all.insert(all.end(), {ours, robust, fast});
    }
    return all;
}

} // namespace vkbake::bench
