#include "probes.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <glm/common.hpp>

#include "bounces.hpp"
#include "trace/light_probes.hpp"
#include "vkbake/error.hpp"

namespace vkbake {

namespace {

/// The box of all that is baked, metres.
std::array<glm::dvec3, 2> box_of(const Surface& surface) {
    glm::vec3 low = surface.positions.front();
    glm::vec3 high = low;
    for (const glm::vec3& position : surface.positions) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    return {surface.frame.to_world(low), surface.frame.to_world(high)};
}

ProbeGrid make_grid(const Surface& surface, const std::array<std::uint32_t, 3>& counts, std::size_t first_probe) {
    const auto [low, high] = box_of(surface);
    ProbeGrid grid{.counts = counts, .first_probe = first_probe};
    grid.step = (high - low) / glm::dvec3(counts[0], counts[1], counts[2]);
    grid.first = low + 0.5 * grid.step;
    return grid;
}

void add_grid(const ProbeGrid& grid, std::vector<LightProbe>& probes) {
    for (std::uint32_t z = 0; z < grid.counts[2]; ++z) {
        for (std::uint32_t y = 0; y < grid.counts[1]; ++y) {
            for (std::uint32_t x = 0; x < grid.counts[0]; ++x) {
                probes.push_back({.position = grid.first + grid.step * glm::dvec3(x, y, z)});
            }
        }
    }
}

glm::vec3 in_frame(const BakeFrame& frame, const LightProbe& probe) {
    const glm::vec3 place(frame.scale() * (probe.position - frame.centre));
    // Beyond this, rays have no digits left for the scene.
    constexpr float farthest = 1024.0F;
    for (int axis = 0; axis < 3; ++axis) {
        if (!(std::abs(place[axis]) <= farthest)) {
            throw Error(ErrorKind::bad_input,
                        "light probe \"" + probe.name +
                            "\": lies more than 500 times the scene's size away from it; move it");
        }
    }
    return place;
}

} // namespace

bool has_probes(const Scene& scene, const Settings& settings) {
    return settings.mode == Mode::irradiance && (!scene.probes.empty() || settings.probe_grid);
}

void add_probes(const Scene& scene, const Tracer& tracer, const std::function<const GeometryImage&(std::size_t)>& draw,
                StageClock& clock, Bake& bake) {
    for (const ProbePlace& place : scene.probes) {
        bake.probes.push_back({.name = place.name, .position = place.position});
    }
    if (bake.settings.probe_grid) {
        bake.probe_grid = make_grid(bake.surface, *bake.settings.probe_grid, bake.probes.size());
        add_grid(*bake.probe_grid, bake.probes);
    }
    std::vector<glm::vec3> places;
    for (const LightProbe& probe : bake.probes) {
        places.push_back(in_frame(bake.surface.frame, probe));
    }
    clock.begin_page(0, 1);
    const SentLight sent = clock.run("surface colors", [&] { return light_from_maps(scene, draw, bake); });
    const SurfaceLight light(bake.surface, bake.atlas, sent.pages, sent.two_sided);
    const TracedProbes traced =
        clock.run("probes", [&] { return trace_probes(tracer, places, light, clock.trace_progress("probes")); });
    bake.probe_rays = traced.rays;
    for (std::size_t probe = 0; probe < places.size(); ++probe) {
        bake.probes[probe].coefficients = traced.probes[probe].coefficients;
        bake.probes[probe].back_sides = traced.probes[probe].back_sides;
    }
}

} // namespace vkbake
