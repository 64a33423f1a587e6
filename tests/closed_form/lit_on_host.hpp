// A bake with bounces, without a device.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "bounces.hpp"
#include "host_bake.hpp"
#include "probes.hpp"
#include "stage_clock.hpp"

namespace vkbake::test {

/// The light maps before dilation.
inline Bake bounced(const Scene& scene, const Settings& settings, const Sky& sky) {
    Bake bake{.settings = settings};
    bake.surface = make_surface(scene);
    bake.atlas = make_atlas(scene, bake.surface, settings);
    const std::optional<SurfaceOpacity> opacity = make_opacity(scene, bake.surface, settings);
    const Tracer tracer(bake.surface, sky, settings, scene.lamps, opacity ? &*opacity : nullptr);
    std::vector<GeometryImage> geometry;
    for (std::uint32_t page = 0; page < bake.atlas.pages.size(); ++page) {
        geometry.push_back(reference_geometry_image(bake.surface, bake.atlas, page));
        bake.light_maps.push_back(tracer.trace(geometry.back()));
    }
    const Progress silent;
    StageClock clock(silent);
    const auto draw = [&](std::size_t page) -> const GeometryImage& { return geometry[page]; };
    const SentLight sent = add_bounces(scene, tracer, draw, clock, bake);
    if (settings.directional == Switch::on) {
        add_directional(tracer, sent, draw, clock, bake);
    }
    if (has_probes(scene, settings)) {
        add_probes(scene, tracer, draw, clock, bake);
    }
    return bake;
}

/// Under a sky of one colour.
inline Bake bounced(const Scene& scene, const Settings& settings, const glm::vec3& sky = glm::vec3(0.0F)) {
    return bounced(scene, settings, constant_sky(sky));
}

} // namespace vkbake::test
