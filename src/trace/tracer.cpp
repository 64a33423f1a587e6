#include "trace/tracer.hpp"

#include <algorithm>
#include <chrono>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "base/float_state.hpp"
#include "base/parallel.hpp"
#include "base/random.hpp"
#include "trace/check_settings.hpp"
#include "trace/gather.hpp"
#include "trace/ray_origin.hpp"
#include "trace/sampler.hpp"
#include "trace/sky_lookup.hpp"
#include "trace/texel_order.hpp"
#include "vkbake/error.hpp"

namespace vkbake {

namespace {

using AnySampler = std::variant<CosineSampler, ThesisSampler>;
using TexelChunk = std::span<const std::uint32_t>;
using ChunkTracer = std::function<RayCounts(TexelChunk)>;

const Settings& checked(const Settings& settings) {
    check_trace_settings(settings);
    return settings;
}

AnySampler make_sampler(const Settings& settings) {
    if (settings.sampler == Sampler::thesis) {
        return ThesisSampler();
    }
    return CosineSampler(settings.rays);
}

TriangleAccelerator make_accelerator(const Surface& surface, const Settings& settings) {
    return {surface.positions,
            surface.canonical_order,
            {settings.accelerator, settings.triangle_test, settings.cluster_splits, settings.threads}};
}

/// Traces the texels in chunks, and says how far it is some ten times a second. Reports come between bands of chunks,
/// so that they come from this thread; the sizes of chunks and bands change no result.
RayCounts trace_chunks(std::span<const std::uint32_t> texels, std::uint64_t rays_a_texel, int threads,
                       const ChunkTracer& trace_chunk, const TraceProgress& progress) {
    // Below this, handing work to a thread costs more than a per cent of it.
    constexpr std::uint64_t worthwhile_rays = 4096;
    constexpr std::uint64_t first_band_rays = 1U << 18U;
    const std::size_t chunk_size = rays_a_texel < worthwhile_rays ? 16 : 1;
    const std::size_t grain = static_cast<std::size_t>(worthwhile_rays / (rays_a_texel * chunk_size)) + 1;
    const std::size_t chunk_count = (texels.size() + chunk_size - 1) / chunk_size;

    RayCounts total;
    if (chunk_count == 0 && progress) {
        (void)progress(1.0, 0); // nothing is left to stop
    }
    std::size_t band = static_cast<std::size_t>(first_band_rays / (rays_a_texel * chunk_size)) + 2;
    for (std::size_t first = 0; first < chunk_count;) {
        const auto start = std::chrono::steady_clock::now();
        const std::size_t count = std::min(band, chunk_count - first);
        std::vector<RayCounts> counts(count);
        parallel_ranges(count, grain, threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t chunk = begin; chunk < end; ++chunk) {
                const std::size_t texel = (first + chunk) * chunk_size;
                counts[chunk] = trace_chunk(texels.subspan(texel, std::min(chunk_size, texels.size() - texel)));
            }
        });
        for (const RayCounts& chunk : counts) {
            total += chunk;
        }
        first += count;
        if (progress && !progress(static_cast<double>(first) / static_cast<double>(chunk_count), total.rays)) {
            throw Error(ErrorKind::interrupted, "interrupted");
        }
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        band = seconds < 0.06 ? band * 2 : (seconds > 0.15 ? std::max<std::size_t>(band / 2, 1) : band);
    }
    return total;
}

} // namespace

struct Tracer::State {
    State(const Surface& traced, const Sky& sky, const Settings& asked)
        : surface(&traced), settings(checked(asked)), sampler(make_sampler(asked)),
          radiance(asked.mode == Mode::ao ? SkyLookup(ConstantLookup(glm::vec3(1.0F))) : make_sky_lookup(sky)),
          intensity(asked.mode == Mode::ao ? 1.0 : sky.intensity),
          max_distance(asked.ao_distance ? static_cast<float>(*asked.ao_distance * traced.frame.scale())
                                         : std::numeric_limits<float>::infinity()),
          accelerator(make_accelerator(traced, asked)) {}

    [[nodiscard]] glm::vec3 origin(const GeometryImage& geometry, std::size_t texel, const glm::vec3& normal) const {
        const std::size_t corner = std::size_t{3} * geometry.triangle[texel];
        return ray_origin({surface->positions[corner], surface->positions[corner + 1], surface->positions[corner + 2]},
                          geometry.position[texel], normal);
    }

    /// A function that traces a chunk of texels into `image`, made for one kind of sampler and of sky.
    template<typename AsSampler, typename Radiance>
    [[nodiscard]] ChunkTracer chunk_tracer(const AsSampler& as_sampler, const Radiance& from_sky,
                                           const GeometryImage& geometry, Image& image) const;

    const Surface* surface; ///< never null
    Settings settings;
    AnySampler sampler;
    SkyLookup radiance;
    double intensity;
    float max_distance; ///< bake frame
    TriangleAccelerator accelerator;
};

template<typename AsSampler, typename Radiance>
ChunkTracer Tracer::State::chunk_tracer(const AsSampler& as_sampler, const Radiance& from_sky,
                                        const GeometryImage& geometry, Image& image) const {
    return [this, &as_sampler, &from_sky, &geometry, &image](TexelChunk texels) {
        RayCounts counts;
        const double scale = as_sampler.scale() * intensity;
        const auto width = static_cast<std::uint32_t>(geometry.width);
        for (const std::uint32_t texel : texels) {
            // A triangle without area has no geometric normal; its shading normal is all there is to go by.
            const glm::vec3& shading_normal = geometry.shading_normal[texel];
            const bool flat = geometry.geometric_normal[texel] == glm::vec3(0.0F);
            const glm::vec3& geometric_normal = flat ? shading_normal : geometry.geometric_normal[texel];
            const auto directions =
                as_sampler.at(texel_key(settings.seed, texel % width, texel / width), shading_normal);
            const glm::dvec3 sum = gather(accelerator, origin(geometry, texel, geometric_normal), geometric_normal,
                                          directions, as_sampler.count(), from_sky, max_distance, counts);
            image.texels[texel] = glm::vec4(glm::vec3(sum * scale), 1.0F);
            image.coverage[texel] = 1.0F;
        }
        return counts;
    };
}

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
    const std::vector<std::uint32_t> texels = covered_texels_in_tiles(geometry, m_state->surface->triangle_count());

    LightMap map;
    map.image.width = geometry.width;
    map.image.height = geometry.height;
    map.image.texels.assign(geometry.texel_count(), glm::vec4(0.0F));
    map.image.coverage.assign(geometry.texel_count(), 0.0F);
    const RayCounts counts = std::visit(
        [&](const auto& sampler, const auto& radiance) {
            return trace_chunks(texels, sampler.count(), m_state->settings.threads,
                                m_state->chunk_tracer(sampler, radiance, geometry, map.image), progress);
        },
        m_state->sampler, m_state->radiance);

    map.statistics.covered_texels = texels.size();
    map.statistics.rays = counts.rays;
    map.statistics.occluded_rays = counts.occluded_rays;
    map.statistics.skipped_directions = counts.skipped_directions;
    map.statistics.probed_hits = counts.probed_hits;
    map.statistics.back_side_hits = counts.back_side_hits;
    map.statistics.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return map;
}

} // namespace vkbake
