#include "trace/light_probes.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>

#include "base/float_state.hpp"
#include "base/parallel.hpp"
#include "base/random.hpp"
#include "trace/directions.hpp"
#include "trace/incident_light.hpp"
#include "trace/sought_light.hpp"
#include "trace/tile_loop.hpp"
#include "vkbake/error.hpp"

namespace vkbake {

namespace {

/// Sixteen probes after the other, for one thread.
class ProbeTracer {
public:
    ProbeTracer(const TracedScene& scene, const RayPlan& plan, const SurfaceLight& light, const EmitterSet* emitters)
        : m_scene(&scene), m_plan(&plan), m_strata(&std::get<CosineStrata>(plan.directions())),
          m_incident(*scene.sky, scene.intensity, &light, *scene.visibility),
          m_sought(scene, plan, emitters, RaySpread::sphere) {
        m_lanes.tangent[0].fill(1.0F);
        m_lanes.bitangent[1].fill(1.0F);
        m_lanes.normal[2].fill(1.0F);
        m_lanes.geometric_normal[2].fill(1.0F);
        m_lanes.triangle.fill(no_triangle);
    }

    /// `places`: 1 … 16, as many as `probes`.
    void trace(std::span<const glm::vec3> places, std::span<ProbeLight> probes) {
        set_lanes_to(places);
        m_around.clear();
        m_sent.clear();
        m_ends = {};
        invert_scrambles(*m_strata, m_lanes, m_tables);
        for (std::size_t number = 0; number < m_strata->block_count(); ++number) {
            (void)set_directions(*m_strata, m_tables, m_lanes, m_strata->block(number), m_block);
            spread();
            for (const RayBlock::LaneBits active : m_block.active) {
                m_ray_count += static_cast<std::uint64_t>(std::popcount(active));
            }
            m_around.add(m_block, m_incident.along(m_block, m_lanes, m_sought.emitters(), &m_ends));
        }
        m_sought.add(m_lanes, m_around, m_sent);
        const double share = std::numbers::pi / m_plan->samples();
        for (std::size_t lane = 0; lane < places.size(); ++lane) {
            for (std::size_t i = 0; i < probe_coefficients; ++i) {
                probes[lane].coefficients[i] =
                    glm::vec3(share * (4.0 * m_around.sum(i, lane) + m_scene->intensity * m_sent.sum(i, lane)));
            }
            probes[lane].back_sides =
                static_cast<double>(m_ends.back_sides[lane]) / static_cast<double>(m_ends.rays[lane]);
        }
    }

    [[nodiscard]] std::uint64_t rays() const { return m_ray_count + m_sought.rays(); }

private:
    void set_lanes_to(std::span<const glm::vec3> places) {
        for (std::size_t lane = 0; lane < RayBlock::lanes; ++lane) {
            const glm::vec3& place = places[lane < places.size() ? lane : 0];
            std::uint64_t key = mix64(m_plan->settings().seed);
            for (int axis = 0; axis < 3; ++axis) {
                m_lanes.origin[static_cast<std::size_t>(axis)][lane] = place[axis];
                key = mix64(key ^ std::bit_cast<std::uint32_t>(place[axis]));
            }
            m_lanes.scrambles.set(lane, {key, {}});
        }
        m_lanes.covered = static_cast<RayBlock::LaneBits>((1U << places.size()) - 1U);
        m_block.origin = m_lanes.origin;
        m_block.ignored_triangle = m_lanes.triangle;
    }

    /// From cosine-weighted directions about +Z to even ones: at twice the angle from it (both take the squared radius
    /// of the disc for what is uniform).
    void spread() {
        for (auto& [x, y, z] : m_block.direction) {
            for (std::size_t lane = 0; lane < RayBlock::lanes; ++lane) {
                const float twice = 2.0F * z[lane];
                x[lane] *= twice;
                y[lane] *= twice;
                z[lane] = twice * z[lane] - 1.0F;
            }
        }
    }

    const TracedScene* m_scene;   ///< never null
    const RayPlan* m_plan;        ///< never null
    const CosineStrata* m_strata; ///< never null
    IncidentLight m_incident;
    TileLanes m_lanes;
    StratumTables m_tables;
    RayBlock m_block;
    LaneEnds m_ends;
    SoughtLight m_sought;
    LaneHarmonics m_around{probe_coefficients};
    LaneHarmonics m_sent{probe_coefficients}; ///< by lamps and peaks
    std::uint64_t m_ray_count = 0;
};

/// Directions that nothing else has.
Settings probe_settings(Settings settings) {
    constexpr std::uint64_t of_probes = 0x70726F62;
    settings.sampler = Sampler::cosine;
    settings.rays = settings.probe_rays;
    settings.seed = mix64(settings.seed ^ of_probes);
    return settings;
}

} // namespace

TracedProbes trace_probes(const Tracer& tracer, std::span<const glm::vec3> places, const SurfaceLight& light,
                          const TraceProgress& progress) {
    const DefaultFloatState float_state;
    const TracedScene scene = tracer.scene();
    const RayPlan plan(probe_settings(*scene.settings), std::numeric_limits<float>::infinity());
    const std::optional<EmitterSet> emitters = tracer.find_emitters(light);
    std::vector<std::unique_ptr<ProbeTracer>> workers(worker_count(scene.settings->threads));
    for (auto& worker : workers) {
        worker = std::make_unique<ProbeTracer>(scene, plan, light, emitters ? &*emitters : nullptr);
    }
    TracedProbes traced;
    traced.probes.resize(places.size());
    const auto ray_count = [&] {
        std::uint64_t rays = 0;
        for (const auto& worker : workers) {
            rays += worker->rays();
        }
        return rays;
    };
    const std::size_t jobs = (places.size() + RayBlock::lanes - 1) / RayBlock::lanes;
    const TileLoop loop{.count = jobs,
                        .rays_a_job = std::uint64_t{plan.samples()} * RayBlock::lanes,
                        .threads = scene.settings->threads,
                        .report = [&](std::size_t done) {
                            const double share =
                                static_cast<double>(done) / static_cast<double>(std::max<std::size_t>(jobs, 1));
                            if (progress && !progress(share, ray_count(), 0.0)) {
                                throw Error(ErrorKind::interrupted, "interrupted");
                            }
                            return true;
                        }};
    run(loop, [&](std::size_t job, std::size_t worker) {
        const std::size_t first = job * RayBlock::lanes;
        const std::size_t count = std::min(RayBlock::lanes, places.size() - first);
        workers[worker]->trace(places.subspan(first, count), std::span(traced.probes).subspan(first, count));
    });
    traced.rays = ray_count();
    return traced;
}

} // namespace vkbake
