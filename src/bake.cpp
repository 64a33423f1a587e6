// The pipeline: its stages in order, and nothing else.
#include <algorithm>
#include <vector>

#include "atlas/make_atlas.hpp"
#include "base/boundary.hpp"
#include "bounces.hpp"
#include "finish/blend_creases.hpp"
#include "finish/denoise.hpp"
#include "finish/dilate.hpp"
#include "geometry_image/draw.hpp"
#include "lamp_notes.hpp"
#include "memory_plan.hpp"
#include "opacity.hpp"
#include "probes.hpp"
#include "stage_clock.hpp"
#include "surface/make_surface.hpp"
#include "surface/resolution.hpp"
#include "trace/tracer.hpp"
#include "vkbake/vkbake.hpp"

namespace vkbake {
namespace {

/// Mixes light across creases and pads; `creases`: of each page.
void finish_maps(const Device& device, const std::vector<std::vector<CreaseTexel>>& creases, StageClock& clock,
                 Bake& bake) {
    const std::size_t pages = bake.light_maps.size();
    for (std::size_t page = 0; page < pages; ++page) {
        clock.begin_page(page, pages);
        LightMap& map = bake.light_maps[page];
        const auto pad = [&](Image& image) {
            return dilate(device.context(), image, {.rounds = bake.settings.padding});
        };
        map.statistics.filled_texels = clock.run("finish", [&] {
            blend_creases(creases[page], map);
            std::ranges::for_each(map.directional, pad);
            return pad(map.image);
        });
    }
}

Bake run_stages(const Scene& scene, const Sky& sky, const Settings& settings, const Device& device,
                const Progress& progress) {
    Bake bake{.settings = settings, .device = device.name(), .sky = sky.name, .notes = scene.notes};
    bake.notes.insert(bake.notes.end(), sky.notes.begin(), sky.notes.end());
    StageClock clock(progress, settings.seconds);

    check_least_memory(memory_need(scene, sky, settings), settings);
    bake.surface = clock.run("surface", [&] { return make_surface(scene); });
    if (bake.surface.triangle_count() == 0) {
        throw Error(ErrorKind::bad_input,
                    scene.name + ": there is nothing to bake, no node shows a triangle; check the scene");
    }
    const auto add_notes = [&](const std::vector<std::string>& notes) {
        bake.notes.insert(bake.notes.end(), notes.begin(), notes.end());
    };
    add_notes(check_resolution(scene, bake.surface));
    bake.atlas = clock.run("atlas", [&] { return make_atlas(scene, bake.surface, settings); });
    add_notes(bake.atlas.notes);
    add_notes(note_small_texels(bake.surface, bake.atlas));
    check_memory(memory_need(scene, sky, settings, &bake.atlas), settings);
    std::optional<SurfaceOpacity> opacity;
    const Tracer tracer = clock.run("accelerator", [&] {
        opacity = make_opacity(scene, bake.surface, settings);
        return Tracer(bake.surface, sky, settings, scene.lamps, opacity ? &*opacity : nullptr);
    });

    const bool denoised = settings.denoise == Switch::on;
    const double passes = denoised ? 3.0 : 1.0; // dilation takes about what the geometry image does, denoising twice
    const std::size_t pages = bake.atlas.pages.size();
    std::vector<std::vector<CreaseTexel>> creases(pages);
    GeometryImage geometry;
    std::size_t drawn = pages; // the page that it is of
    const auto draw = [&](std::size_t page) -> const GeometryImage& {
        if (drawn != page) {
            geometry =
                draw_geometry_image(device.context(), bake.surface, bake.atlas, static_cast<std::uint32_t>(page));
            drawn = page;
        }
        return geometry;
    };
    for (std::size_t page = 0; page < pages; ++page) {
        clock.begin_page(page, pages);
        clock.run("geometry image", [&] { return draw(page).texel_count(); });
        const auto take_noise = [&](LightMap& map, const std::vector<float>& variance) {
            map.statistics.denoised_texels = clock.run("denoise", [&] {
                return denoise(device.context(), map, {geometry, bake.atlas.chart, variance});
            });
        };
        LightMap map = clock.run("trace", [&] {
            return tracer.trace(geometry, clock.trace_progress(), clock.trace_deadline(passes),
                                denoised ? MapFilter(take_noise) : MapFilter());
        });
        map.name = bake.atlas.pages[page].name;
        bake.light_maps.push_back(std::move(map));
        if (settings.blend_creases == Switch::on) {
            creases[page] = clock.run("creases", [&] {
                return find_crease_texels(bake.surface, bake.atlas, geometry, static_cast<std::uint32_t>(page));
            });
        }
    }
    add_notes(tracer.notes());
    add_notes(note_lamps(scene, bake));
    SentLight sent;
    if (settings.bounces > 0) {
        sent = add_bounces(scene, tracer, draw, clock, bake);
    }
    if (settings.directional == Switch::on) {
        add_directional(tracer, sent, draw, clock, bake);
    }
    sent = {};
    if (has_probes(scene, settings)) {
        add_probes(scene, tracer, draw, clock, bake);
    }
    geometry = {}; // two thirds of the page's memory, which the next steps need
    finish_maps(device, creases, clock, bake);
    bake.stages = clock.seconds();
    return bake;
}

} // namespace

Bake bake(const Scene& scene, const Sky& sky, const Settings& settings, const Device& device,
          const Progress& progress) {
    return at_boundary([&] { return run_stages(scene, sky, settings, device, progress); });
}

} // namespace vkbake
