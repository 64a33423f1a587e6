#include "bench/rays/contest.hpp"

#include <algorithm>
#include <bit>
#include <memory>

#include "bench/common/affordable.hpp"
#include "bench/common/allocation_meter.hpp"
#include "bench/common/our_kernels.hpp"
#include "bench/rays/best_call.hpp"
#include "bench/rays/ray_making.hpp"

namespace vkbake::bench {
namespace {

constexpr std::size_t trial_rays = 60'000;
constexpr int trials = 3;
/// A pass of the thesis's clusters takes about this long, on as many rays as fit.
constexpr double slow_pass_seconds = 0.3;

struct EmbreeSide {
    std::unique_ptr<EmbreeScene> high;
    std::unique_ptr<EmbreeScene> medium;
    std::unique_ptr<Contender> asked;
    std::unique_ptr<Contender> made_and_asked;
    std::vector<WayFigures> tried;
};

EmbreeSide make_embree_side(const EmbreeDevice& device, const EmbreeTriangles& triangles, bool robust,
                            const RaySet& rays) {
    EmbreeSide side{
        .high = std::make_unique<EmbreeScene>(device, triangles, EmbreeQuality{robust, RTC_BUILD_QUALITY_HIGH}),
        .medium = std::make_unique<EmbreeScene>(device, triangles, EmbreeQuality{robust, RTC_BUILD_QUALITY_MEDIUM})};
    const RaySet sample = choose_rays(*rays.source, trial_rays);
    const auto best = [&](Pass pass) {
        const std::vector<TriedCall> tried = try_calls({side.high.get(), side.medium.get()}, sample, pass, trials);
        for (const TriedCall& way : tried) {
            side.tried.push_back({way.scene->quality().name() + ", " + name_of(way.call), pass,
                                  static_cast<double>(sample.ray_count) / way.seconds});
        }
        const TriedCall& won = tried.front();
        return make_embree_contender(*won.scene, won.call, rays, pass);
    };
    side.asked = best(Pass::ask);
    side.made_and_asked = best(Pass::make_and_ask);
    return side;
}

EntryFigures figures_of(const Entry& entry, const std::vector<Entry>& all) {
    EntryFigures figures{.who = entry.who,
                         .description = entry.contender->description(),
                         .pass = entry.pass,
                         .rays = entry.contender->rays().ray_count,
                         .seconds = entry.seconds};
    const auto ours = std::find_if(all.begin(), all.end(),
                                   [&](const Entry& other) { return other.who == "ours" && other.pass == entry.pass; });
    for (const auto& [threads, seconds] : entry.seconds) {
        figures.rays_per_second[threads] = entry.rays_per_second(threads);
        figures.ours_to_it[threads] = ratio(*ours, entry, threads);
    }
    figures.gain = gain(entry, entry.seconds.begin()->first, entry.seconds.rbegin()->first);
    return figures;
}

double occluded_share(const std::vector<BlockedRays>& answers, std::size_t rays) {
    std::size_t blocked = 0;
    for (const BlockedRays& block : answers) {
        for (const RayBlock::LaneBits bits : block) {
            blocked += static_cast<std::size_t>(std::popcount(bits));
        }
    }
    return static_cast<double>(blocked) / static_cast<double>(rays);
}

// Once with every tile and once with one: what threads and scratch take is the same in both.
std::int64_t allocations_while_tracing(Contender& ours) {
    const auto calls_of = [&](std::size_t tiles) {
        const std::int64_t before = allocations().calls;
        (void)timed_pass(1, tiles, [&] { return ours.ask(); });
        return allocations().calls - before;
    };
    return calls_of(ours.rays().tiles.size()) - calls_of(1);
}

} // namespace

Outcome run_contest(const Options& options) {
    const PreparedScene scene = prepare_scene(options.scene, options.settings, options.ground);
    const RaySource source(scene);
    const RaySet rays = choose_rays(source, options.max_rays);
    Outcome outcome{.scene = scene.name,
                    .triangles = scene.surface.triangle_count(),
                    .pages = scene.pages.size(),
                    .texels = source.texel_count(),
                    .tiles = source.tiles().size(),
                    .rays = rays.ray_count};
    outcome.lanes_used = static_cast<double>(rays.ray_count) / static_cast<double>(rays.blocks.size() * RayBlock::rays);
    outcome.builds = compare_builds(scene.surface, options.threads, options.build_budget);

    const TriangleAccelerator accelerator(scene.surface.positions, scene.surface.canonical_order, {});
    const TriangleAccelerator clusters(
        scene.surface.positions, scene.surface.canonical_order,
        {.kind = Accelerator::clusters, .test = TriangleTest::moller_trumbore, .cluster_splits = 4});
    const RaySet few_rays = affordable(
        rays, slow_pass_seconds, [&](const RaySet& some) { return std::make_unique<SingleRayKernel>(clusters, some); });
    const EmbreeTriangles triangles(scene.surface);
    const EmbreeDevice device(all_threads());
    const EmbreeSide robust = make_embree_side(device, triangles, true, rays);
    const EmbreeSide fast = make_embree_side(device, triangles, false, rays);
    BlockKernel asked(accelerator, rays);
    BlockKernel made_and_asked(accelerator, rays);
    SingleRayKernel single_asked(accelerator, rays);
    SingleRayKernel single_made_and_asked(accelerator, rays);
    SingleRayKernel thesis(clusters, few_rays);
    RayMaking making(rays);

    std::vector<Entry> entries{{"ours", &asked, Pass::ask, {}},
                               {"embree robust", robust.asked.get(), Pass::ask, {}},
                               {"embree fast", fast.asked.get(), Pass::ask, {}},
                               {"ours, single rays", &single_asked, Pass::ask, {}},
                               {"thesis's clusters", &thesis, Pass::ask, {}},
                               {"ours", &made_and_asked, Pass::make_and_ask, {}},
                               {"embree robust", robust.made_and_asked.get(), Pass::make_and_ask, {}},
                               {"embree fast", fast.made_and_asked.get(), Pass::make_and_ask, {}},
                               {"ours, single rays", &single_made_and_asked, Pass::make_and_ask, {}},
                               {"making rays alone", &making, Pass::make_and_ask, {}}};
    measure(entries, options.threads, options.repeats, options.clock);
    for (const Entry& entry : entries) {
        outcome.entries.push_back(figures_of(entry, entries));
    }

    for (const EmbreeSide* side : {&robust, &fast}) {
        outcome.embree_ways.insert(outcome.embree_ways.end(), side->tried.begin(), side->tried.end());
    }

    const std::vector<BlockedRays> ours = asked.answers();
    const std::vector<BlockedRays> embree = robust.asked->answers();
    outcome.occluded = occluded_share(ours, rays.ray_count);
    outcome.allocations = allocations_while_tracing(asked);
    outcome.differences = {.blocks_and_single_rays = count_differences(ours, single_asked.answers()),
                           .both_passes = count_differences(ours, made_and_asked.answers()),
                           .ours_and_embree_robust = count_differences(ours, embree),
                           .embree_fast_and_robust = count_differences(embree, fast.asked->answers())};
    outcome.verdict = verify(rays, ours, embree, options.verify, options.verify_brute);
    return outcome;
}

} // namespace vkbake::bench
