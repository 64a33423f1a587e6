#include "trace/tracer.hpp"

#include <algorithm>
#include <chrono>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "base/float_state.hpp"
#include "base/parallel.hpp"
#include "base/random.hpp"
#include "trace/adaptive.hpp"
#include "trace/cell_visibility.hpp"
#include "trace/check_settings.hpp"
#include "trace/gather_tracer.hpp"
#include "trace/lamp_set.hpp"
#include "trace/peak_cut.hpp"
#include "trace/resample_sky.hpp"
#include "trace/sampled_map.hpp"
#include "trace/sky_lookup.hpp"
#include "trace/sky_peaks.hpp"
#include "trace/texel_tiles.hpp"
#include "trace/tile_loop.hpp"
#include "trace/tile_rays.hpp"
#include "trace/tile_tracer.hpp"
#include "trace/visibility.hpp"
#include "vkbake/error.hpp"

namespace vkbake {

namespace {

const Settings& checked(const Settings& settings) {
    check_trace_settings(settings);
    return settings;
}

AcceleratorSettings accelerator_settings(const Settings& settings) {
    return {settings.accelerator, settings.triangle_test, settings.cluster_splits, settings.threads};
}

bool bakes_lamps(const Settings& settings) { return settings.mode == Mode::irradiance && settings.lamps == Switch::on; }

/// A sky without intensity is a black one, so that what it is multiplied with is never 0.
SkyLookup make_radiance(const Sky& sky, const Settings& settings) {
    if (settings.mode != Mode::irradiance) {
        return ConstantLookup{glm::vec3(1.0F)};
    }
    SkyLookup lookup = make_sky_lookup(sky);
    return sky.intensity == 0.0 ? SkyLookup(ConstantLookup{glm::vec3(0.0F)}) : std::move(lookup);
}

/// Where they are worth it and wanted.
std::optional<SkyPeaks> take_peaks(SkyLookup& radiance, const Settings& settings, std::vector<std::string>& notes) {
    if (settings.sun == Switch::off || settings.sampler != Sampler::cosine) {
        return std::nullopt;
    }
    const PeakCut cut = find_peaks(radiance);
    if (cut.worthwhile()) {
        notes.push_back("sky: " + describe(cut) + "; it is sampled on its own");
    }
    return cut.worthwhile() ? std::optional<SkyPeaks>(std::in_place, radiance, cut.threshold) : std::nullopt;
}

double intensity_of(const Sky& sky, const Settings& settings) {
    return settings.mode != Mode::irradiance || sky.intensity == 0.0 ? 1.0 : sky.intensity;
}

using TileTracers = std::vector<std::unique_ptr<TileTracer>>;

template<class Worker>
Samplers samplers_of(const std::vector<std::unique_ptr<Worker>>& workers) {
    Samplers samplers;
    std::ranges::transform(workers, std::back_inserter(samplers), [](const auto& worker) { return worker.get(); });
    return samplers;
}

RayCounts sum_of(const Samplers& samplers) {
    RayCounts total;
    for (const TileSampler* const sampler : samplers) {
        total += sampler->counts();
    }
    return total;
}

/// Tells how much of the work is done, which begins and ends at a share of all; throws where it is to stop, but not
/// when there was nothing to do.
std::function<bool(std::size_t)> report_of(std::size_t tiles, const Samplers& samplers, const TraceProgress& progress,
                                           double begin = 0.0, double end = 1.0) {
    if (!progress) {
        return {};
    }
    return [&, tiles, begin, end](std::size_t done) {
        const double share = tiles == 0 ? 1.0 : static_cast<double>(done) / static_cast<double>(tiles);
        if (!progress(begin + share * (end - begin), sum_of(samplers).all(), 0.0) && tiles > 0) {
            throw Error(ErrorKind::interrupted, "interrupted");
        }
        return true;
    };
}

/// The same number of rays for all, nothing kept of them but their sum: E/π is `scale` times that.
template<class Worker>
void trace_plain(const std::vector<TexelTile>& tiles, const std::vector<std::unique_ptr<Worker>>& workers,
                 const RayPlan& plan, double scale, const TraceProgress& progress, LightMap& map) {
    const auto store = [&](std::uint32_t texel, const glm::dvec3& sum) {
        map.image.texels[texel] = glm::vec4(glm::vec3(sum * scale), 1.0F);
        map.image.coverage[texel] = 1.0F;
    };
    const Samplers samplers = samplers_of(workers);
    const TileLoop loop{.count = tiles.size(),
                        .rays_a_job = std::uint64_t{plan.samples()} * RayBlock::lanes,
                        .threads = plan.settings().threads,
                        .report = report_of(tiles.size(), samplers, progress)};
    run(loop, [&](std::size_t tile, std::size_t worker) { workers[worker]->trace(tiles[tile], store); });
}

/// Makes maps of samples, and hands them to the filter, if there is one.
class MapWriter {
public:
    explicit MapWriter(const MapFilter& filter) : m_filter(filter) {}

    void write(const SampledMap& sampled, LightMap& map) {
        sampled.write_to(map);
        if (m_filter) {
            const auto start = std::chrono::steady_clock::now();
            m_filter(map, sampled.variances(map.image.texels.size()));
            m_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        }
    }

    [[nodiscard]] bool filters() const { return static_cast<bool>(m_filter); }
    [[nodiscard]] double seconds() const { return m_seconds; } ///< that the filter took

private:
    const MapFilter& m_filter;
    double m_seconds = 0.0;
};

/// Over which numbers of samples `rays` are reached: where visibility is reused each step spares what those before it
/// tell.
std::vector<std::uint32_t> steps_to(std::uint32_t rays, bool reused) {
    std::vector<std::uint32_t> steps;
    for (std::uint64_t step = KnownCells::least_samples; reused && step < rays; step *= 4) {
        steps.push_back(static_cast<std::uint32_t>(step));
    }
    steps.push_back(rays);
    return steps;
}

void trace_estimated(SampledMap& sampled, const Samplers& samplers, const Settings& settings,
                     const TraceProgress& progress, MapWriter& writer, LightMap& map) {
    double begin = 0.0;
    for (const std::uint32_t step : steps_to(settings.rays, reuses_visibility(settings))) {
        std::vector<TileOrder> orders;
        for (std::size_t tile = 0; tile < sampled.tiles().size(); ++tile) {
            orders.push_back({static_cast<std::uint32_t>(tile), step});
        }
        const double end = static_cast<double>(step) / settings.rays;
        sampled.extend(orders, samplers, report_of(orders.size(), samplers, progress, begin, end));
        begin = end;
    }
    writer.write(sampled, map);
}

void trace_adaptively(SampledMap& sampled, const Samplers& samplers, AdaptiveGoal goal, const TraceProgress& progress,
                      MapWriter& writer, LightMap& map) {
    if (writer.filters()) {
        goal.left = [&] {
            writer.write(sampled, map);
            return map.error->relative_rmse;
        };
    }
    const AdaptiveResult result = sample_adaptively(sampled, samplers, goal, [&](double share, double error) {
        if (progress && !progress(share, sum_of(samplers).all(), error) && sampled.texel_count() > 0) {
            throw Error(ErrorKind::interrupted, "interrupted");
        }
    });
    if (!result.judged) {
        writer.write(sampled, map);
    }
    const auto texels = static_cast<double>(std::max<std::size_t>(sampled.texel_count(), 1));
    map.error->target_reached = !goal.error || map.error->relative_rmse <= *goal.error;
    map.error->mean_rays = (result.samples - static_cast<double>(sum_of(samplers).spared_rays)) / texels;
    map.error->best_mean_rays = result.best_samples / texels;
    map.error->uniform_rays = static_cast<double>(result.uniform);
}

bool is_estimated(const Settings& settings) {
    return settings.target_error || settings.seconds || settings.estimate_error || settings.denoise == Switch::on;
}

/// Whether what its samples meet is to be remembered of each texel.
bool is_sampled(const Settings& settings) {
    return is_estimated(settings) || (reuses_visibility(settings) && settings.rays > KnownCells::least_samples);
}

/// LightMapStatistics::lamps_reached.
std::vector<std::uint64_t> reached(const TileTracers& workers) {
    std::vector<std::uint64_t> total;
    for (const auto& worker : workers) {
        if (worker->lamps()) {
            const std::vector<std::uint64_t>& some = worker->lamps()->reached();
            total.resize(some.size(), 0);
            std::transform(some.begin(), some.end(), total.begin(), total.begin(), std::plus<>());
        }
    }
    return total;
}

Image empty_image(const GeometryImage& geometry) {
    return {.width = geometry.width,
            .height = geometry.height,
            .texels = std::vector<glm::vec4>(geometry.texel_count(), glm::vec4(0.0F)),
            .coverage = std::vector<float>(geometry.texel_count(), 0.0F)};
}

} // namespace

struct Tracer::State {
    State(const Surface& traced, const Sky& sky, const Settings& asked, std::span<const Lamp> given,
          const SurfaceOpacity* opacity_of_it)
        : surface(&traced), opacity(opacity_of_it), threads(checked(asked).threads),
          radiance(make_radiance(sky, asked)), intensity(intensity_of(sky, asked)),
          peaks(take_peaks(radiance, asked, notes)),
          lamps(bakes_lamps(asked) ? make_lamp_set(given, traced.frame, intensity) : LampSet()),
          plan(asked, asked.ao_distance ? static_cast<float>(*asked.ao_distance * traced.frame.scale())
                                        : std::numeric_limits<float>::infinity()),
          visibility(traced, accelerator_settings(asked), opacity_of_it, asked.ao_falloff) {
        resample(radiance, threads);
    }

    [[nodiscard]] TileTracers make_workers(const GeometryImage& geometry) const {
        TileTracers workers(worker_count(threads));
        for (auto& worker : workers) {
            worker = std::make_unique<TileTracer>(
                *surface, geometry, plan, radiance, visibility,
                LightSources{.lamps = lamps.empty() ? nullptr : &lamps, .peaks = peaks ? &*peaks : nullptr});
        }
        return workers;
    }

    const Surface* surface; ///< never null
    const SurfaceOpacity* opacity;
    int threads;
    std::vector<std::string> notes;
    SkyLookup radiance;
    double intensity;              ///< > 0
    std::optional<SkyPeaks> peaks; ///< which `radiance` then lacks
    LampSet lamps;
    RayPlan plan;
    Visibility visibility;
};

Tracer::Tracer(const Surface& surface, const Sky& sky, const Settings& settings, std::span<const Lamp> lamps,
               const SurfaceOpacity* opacity) {
    const DefaultFloatState float_state;
    m_state = std::make_unique<State>(surface, sky, settings, lamps, opacity);
}

std::vector<std::string> Tracer::notes() const { return m_state->notes; }

TracedScene Tracer::scene() const {
    return {.surface = m_state->surface,
            .visibility = &m_state->visibility,
            .settings = &m_state->plan.settings(),
            .sky = &m_state->radiance,
            .peaks = m_state->peaks ? &*m_state->peaks : nullptr,
            .lamps = m_state->lamps.empty() ? nullptr : &m_state->lamps,
            .intensity = m_state->intensity};
}

Tracer::~Tracer() = default;
Tracer::Tracer(Tracer&&) noexcept = default;
Tracer& Tracer::operator=(Tracer&&) noexcept = default;

LightMap Tracer::trace(const GeometryImage& geometry, const TraceProgress& progress,
                       std::optional<std::chrono::steady_clock::time_point> deadline, const MapFilter& filter) const {
    const DefaultFloatState float_state;
    const auto start = std::chrono::steady_clock::now();
    const std::vector<TexelTile> tiles = make_tiles(geometry, m_state->surface->triangle_count());
    const TileTracers workers = m_state->make_workers(geometry);
    const Samplers samplers = samplers_of(workers);

    LightMap map{.image = empty_image(geometry)};
    const RayPlan& plan = m_state->plan;
    const Settings& settings = plan.settings();
    MapWriter writer(filter);
    if (is_sampled(settings) || deadline) {
        SampledMap sampled(tiles, settings, plan.max_distance(), m_state->intensity);
        if (settings.target_error || deadline) {
            trace_adaptively(sampled, samplers, {settings.target_error, deadline}, progress, writer, map);
        } else {
            trace_estimated(sampled, samplers, plan.settings(), progress, writer, map);
        }
        if (!is_estimated(settings) && !deadline) { // what reuse alone needed
            map.error.reset();
            map.standard_error.clear();
            map.texel_rays.clear();
        }
    } else {
        trace_plain(tiles, workers, plan, plan.scale() * m_state->intensity, progress, map);
    }

    for (const TexelTile& tile : tiles) {
        map.statistics.covered_texels += tile.count;
    }
    const RayCounts counts = sum_of(samplers);
    map.statistics.rays = counts.rays;
    map.statistics.occluded_rays = counts.occluded_rays;
    map.statistics.filtered_rays = counts.filtered_rays;
    map.statistics.skipped_directions = counts.skipped_directions;
    map.statistics.spared_rays = counts.spared_rays;
    map.statistics.probed_hits = counts.probed_hits;
    map.statistics.back_side_hits = counts.back_side_hits;
    map.statistics.lamp_rays = counts.lamp_rays;
    map.statistics.peak_rays = counts.peak_rays;
    map.statistics.lamps_reached = reached(workers);
    map.statistics.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() - writer.seconds();
    return map;
}

std::optional<EmitterSet> Tracer::find_emitters(const SurfaceLight& light) const {
    if (m_state->plan.settings().sampler != Sampler::cosine || !light.is_sought()) {
        return std::nullopt;
    }
    EmitterSet emitters(*m_state->surface, light, m_state->opacity);
    return emitters.empty() ? std::nullopt : std::optional(std::move(emitters));
}

LightMap Tracer::gather(const GeometryImage& geometry, const SurfaceLight& light, std::uint32_t bounce,
                        const GatherOptions& options, const TraceProgress& progress) const {
    const DefaultFloatState float_state;
    const auto start = std::chrono::steady_clock::now();
    const std::vector<TexelTile> tiles = make_tiles(geometry, m_state->surface->triangle_count());
    Settings settings = m_state->plan.settings();
    settings.seed = mix64(settings.seed + bounce);
    settings.rays = settings.bounce_rays;
    settings.reuse = Switch::off; // what a ray meets is another surface for each
    const RayPlan plan(settings, m_state->plan.max_distance());
    std::vector<std::unique_ptr<GatherTracer>> workers(worker_count(m_state->threads));
    for (auto& worker : workers) {
        worker = std::make_unique<GatherTracer>(*m_state->surface, geometry, plan, light, m_state->visibility,
                                                options.emitters);
    }
    const Samplers samplers = samplers_of(workers);
    LightMap map{.image = empty_image(geometry)};
    if (options.before) {
        const MapFilter unfiltered;
        MapWriter writer(unfiltered);
        SampledMap sampled(tiles, settings, plan.max_distance(), 1.0, *options.before);
        if (settings.target_error) {
            trace_adaptively(sampled, samplers, {settings.target_error, {}}, progress, writer, map);
        } else {
            trace_estimated(sampled, samplers, plan.settings(), progress, writer, map);
        }
    } else {
        trace_plain(tiles, workers, plan, plan.scale(), progress, map);
    }
    map.statistics.bounce_rays = sum_of(samplers).all();
    map.statistics.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return map;
}

} // namespace vkbake
