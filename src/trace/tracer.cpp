#include "trace/tracer.hpp"

#include <algorithm>
#include <chrono>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "base/float_state.hpp"
#include "base/parallel.hpp"
#include "base/random.hpp"
#include "trace/check_settings.hpp"
#include "trace/gather_tracer.hpp"
#include "trace/sky_lookup.hpp"
#include "trace/texel_tiles.hpp"
#include "trace/tile_loop.hpp"
#include "trace/tile_rays.hpp"
#include "trace/tile_tracer.hpp"
#include "vkbake/error.hpp"

namespace vkbake {

namespace {

const Settings& checked(const Settings& settings) {
    check_trace_settings(settings);
    return settings;
}

TriangleAccelerator make_accelerator(const Surface& surface, const Settings& settings) {
    return {surface.positions,
            surface.canonical_order,
            {settings.accelerator, settings.triangle_test, settings.cluster_splits, settings.threads}};
}

/// One a worker, each for itself in memory: what they write while tracing shares no cache line.
using Workers = std::vector<std::unique_ptr<TileTracer>>;

RayCounts sum_of(const Workers& workers) {
    RayCounts total;
    for (const auto& worker : workers) {
        total += worker->counts();
    }
    return total;
}

/// Calls trace(tile, worker) for all tiles, and says how far it is some ten times a second. Reports come between bands
/// of tiles, so that they come from this thread; the sizes of bands and tasks change no result.
void trace_tiles(std::span<const TexelTile> tiles, std::uint64_t rays_a_texel, int threads, const Workers& workers,
                 const std::function<void(const TexelTile&, TileTracer&)>& trace, const TraceProgress& progress) {
    // Below this, handing work to a thread costs more than a per cent of it.
    constexpr std::uint64_t worthwhile_rays = 4096;
    constexpr std::uint64_t first_band_rays = 1U << 18U;
    const std::uint64_t rays_a_tile = rays_a_texel * RayBlock::lanes;
    const auto grain = static_cast<std::size_t>((worthwhile_rays + rays_a_tile - 1) / rays_a_tile);
    if (tiles.empty() && progress) {
        (void)progress(1.0, 0); // nothing is left to stop
    }
    std::size_t band = static_cast<std::size_t>(first_band_rays / rays_a_tile) + 2;
    for (std::size_t first = 0; first < tiles.size();) {
        const auto start = std::chrono::steady_clock::now();
        const std::size_t count = std::min(band, tiles.size() - first);
        parallel_ranges_by_worker(count, grain, threads, [&](std::size_t begin, std::size_t end, std::size_t worker) {
            for (std::size_t tile = begin; tile < end; ++tile) {
                trace(tiles[first + tile], *workers[worker]);
            }
        });
        first += count;
        if (progress &&
            !progress(static_cast<double>(first) / static_cast<double>(tiles.size()), sum_of(workers).rays)) {
            throw Error(ErrorKind::interrupted, "interrupted");
        }
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        band = seconds < 0.06 ? band * 2 : (seconds > 0.15 ? std::max<std::size_t>(band / 2, 1) : band);
    }
}

Image empty_image(const GeometryImage& geometry) {
    return {.width = geometry.width,
            .height = geometry.height,
            .texels = std::vector<glm::vec4>(geometry.texel_count(), glm::vec4(0.0F)),
            .coverage = std::vector<float>(geometry.texel_count(), 0.0F)};
}

} // namespace

struct Tracer::State {
    State(const Surface& traced, const Sky& sky, const Settings& asked)
        : surface(&traced), threads(checked(asked).threads),
          radiance(asked.mode == Mode::ao ? SkyLookup(ConstantLookup{glm::vec3(1.0F)}) : make_sky_lookup(sky)),
          intensity(asked.mode == Mode::ao ? 1.0 : sky.intensity),
          plan(asked, asked.ao_distance ? static_cast<float>(*asked.ao_distance * traced.frame.scale())
                                        : std::numeric_limits<float>::infinity()),
          accelerator(make_accelerator(traced, asked)) {}

    [[nodiscard]] Workers make_workers(const GeometryImage& geometry) const {
        Workers workers(worker_count(threads));
        for (auto& worker : workers) {
            worker = std::make_unique<TileTracer>(*surface, geometry, plan, radiance, accelerator);
        }
        return workers;
    }

    const Surface* surface; ///< never null
    int threads;
    SkyLookup radiance;
    double intensity;
    RayPlan plan;
    TriangleAccelerator accelerator;
};

Tracer::Tracer(const Surface& surface, const Sky& sky, const Settings& settings) {
    const DefaultFloatState float_state;
    m_state = std::make_unique<State>(surface, sky, settings);
}

Tracer::~Tracer() = default;
Tracer::Tracer(Tracer&&) noexcept = default;
Tracer& Tracer::operator=(Tracer&&) noexcept = default;

LightMap Tracer::trace(const GeometryImage& geometry, const TraceProgress& progress) const {
    const DefaultFloatState float_state;
    const auto start = std::chrono::steady_clock::now();
    const std::vector<TexelTile> tiles = make_tiles(geometry, m_state->surface->triangle_count());

    LightMap map{.name = {}, .image = empty_image(geometry), .statistics = {}};
    const double scale = m_state->plan.scale() * m_state->intensity;
    const auto store = [&](std::uint32_t texel, const glm::dvec3& sum) {
        map.image.texels[texel] = glm::vec4(glm::vec3(sum * scale), 1.0F);
        map.image.coverage[texel] = 1.0F;
    };
    const Workers workers = m_state->make_workers(geometry);
    trace_tiles(
        tiles, m_state->plan.samples(), m_state->threads, workers,
        [&](const TexelTile& tile, TileTracer& worker) { worker.trace(tile, store); }, progress);

    const RayCounts counts = sum_of(workers);
    for (const TexelTile& tile : tiles) {
        map.statistics.covered_texels += tile.count;
    }
    map.statistics.rays = counts.rays;
    map.statistics.occluded_rays = counts.occluded_rays;
    map.statistics.skipped_directions = counts.skipped_directions;
    map.statistics.probed_hits = counts.probed_hits;
    map.statistics.back_side_hits = counts.back_side_hits;
    map.statistics.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return map;
}

LightMap Tracer::gather(const GeometryImage& geometry, const SurfaceLight& light, std::uint32_t bounce,
                        const TraceProgress& progress) const {
    const DefaultFloatState float_state;
    const auto start = std::chrono::steady_clock::now();
    const std::vector<TexelTile> tiles = make_tiles(geometry, m_state->surface->triangle_count());
    Settings settings = m_state->plan.settings();
    settings.seed = mix64(settings.seed + bounce);
    settings.rays = settings.bounce_rays;
    const RayPlan plan(settings, m_state->plan.max_distance());
    std::vector<std::unique_ptr<GatherTracer>> workers(worker_count(m_state->threads));
    for (auto& worker : workers) {
        worker = std::make_unique<GatherTracer>(*m_state->surface, geometry, plan, light, m_state->accelerator);
    }
    const auto rays = [&] {
        RayCounts counts;
        for (const auto& worker : workers) {
            counts += worker->counts();
        }
        return counts.rays;
    };

    LightMap map{.name = {}, .image = empty_image(geometry), .statistics = {}};
    const TileLoop loop{.count = tiles.size(),
                        .rays_a_job = std::uint64_t{plan.samples()} * RayBlock::lanes,
                        .threads = m_state->threads,
                        .report = [&](std::size_t done) {
                            const auto all = static_cast<double>(std::max<std::size_t>(tiles.size(), 1));
                            return !progress || progress(static_cast<double>(done) / all, rays());
                        }};
    const std::size_t done = run(loop, [&](std::size_t tile, std::size_t worker) {
        workers[worker]->trace(tiles[tile], [&](std::uint32_t texel, const glm::dvec3& sum) {
            map.image.texels[texel] = glm::vec4(glm::vec3(sum * plan.scale()), 1.0F);
            map.image.coverage[texel] = 1.0F;
        });
    });
    if (done < tiles.size()) {
        throw Error(ErrorKind::interrupted, "interrupted");
    }
    map.statistics.bounce_rays = rays();
    map.statistics.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return map;
}

} // namespace vkbake
