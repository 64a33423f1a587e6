#include "trace/directional_map.hpp"

#include <chrono>
#include <memory>

#include "base/float_state.hpp"
#include "base/parallel.hpp"
#include "base/random.hpp"
#include "trace/directional_tracer.hpp"
#include "trace/tile_loop.hpp"
#include "vkbake/error.hpp"

namespace vkbake {

namespace {

using DirectionalWorkers = std::vector<std::unique_ptr<DirectionalTracer>>;

/// Directions that neither the light map's rays nor the bounces' have.
Settings directional_settings(Settings settings) {
    constexpr std::uint64_t of_directions = 0x64697265;
    settings.sampler = Sampler::cosine;
    settings.rays = settings.directional_rays;
    settings.seed = mix64(settings.seed ^ of_directions);
    return settings;
}

std::uint64_t ray_sum(const DirectionalWorkers& workers) {
    std::uint64_t rays = 0;
    for (const auto& worker : workers) {
        rays += worker->rays();
    }
    return rays;
}

} // namespace

DirectionalMap trace_directional(const Tracer& tracer, const GeometryImage& geometry, const SurfaceLight* light,
                                 const EmitterSet* emitters, const TraceProgress& progress) {
    const DefaultFloatState float_state;
    const auto start = std::chrono::steady_clock::now();
    const TracedScene scene = tracer.scene();
    const std::vector<TexelTile> tiles = make_tiles(geometry, scene.surface->triangle_count());
    const RayPlan plan(directional_settings(*scene.settings), std::numeric_limits<float>::infinity());
    DirectionalWorkers workers(worker_count(scene.settings->threads));
    for (auto& worker : workers) {
        worker = std::make_unique<DirectionalTracer>(scene, geometry, plan, light, emitters);
    }
    DirectionalMap map;
    map.coefficients.assign(directional_coefficients,
                            {.width = geometry.width,
                             .height = geometry.height,
                             .texels = std::vector<glm::vec4>(geometry.texel_count(), glm::vec4(0.0F)),
                             .coverage = {}});
    const TileLoop loop{.count = tiles.size(),
                        .rays_a_job = std::uint64_t{plan.samples()} * RayBlock::lanes,
                        .threads = scene.settings->threads,
                        .report = [&](std::size_t done) {
                            const double share =
                                tiles.empty() ? 1.0 : static_cast<double>(done) / static_cast<double>(tiles.size());
                            if (progress && !progress(share, ray_sum(workers), 0.0) && !tiles.empty()) {
                                throw Error(ErrorKind::interrupted, "interrupted");
                            }
                            return true;
                        }};
    run(loop, [&](std::size_t tile, std::size_t number) {
        DirectionalTracer& worker = *workers[number];
        worker.trace(tiles[tile], [&](std::uint32_t texel, std::uint32_t lane) {
            for (std::size_t i = 0; i < directional_coefficients; ++i) {
                map.coefficients[i].texels[texel] = glm::vec4(glm::vec3(worker.coefficient(i, lane)), 1.0F);
            }
        });
    });
    map.rays = ray_sum(workers);
    map.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return map;
}

} // namespace vkbake
