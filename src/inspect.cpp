// What a scene has and what a bake of it would make: the stages that need no device.
#include "atlas/make_atlas.hpp"
#include "base/boundary.hpp"
#include "foretell.hpp"
#include "material/surface_colors.hpp"
#include "memory_plan.hpp"
#include "surface/make_surface.hpp"
#include "surface/resolution.hpp"
#include "vkbake/vkbake.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace vkbake {
namespace {

void measure_surface(const Surface& surface, Inspection& inspection) {
    inspection.triangles = surface.triangle_count();
    if (surface.positions.empty()) {
        return;
    }
    inspection.box_low = inspection.box_high = surface.frame.to_world(surface.positions.front());
    double area = 0.0;
    for (std::size_t triangle = 0; triangle < surface.triangle_count(); ++triangle) {
        const glm::dvec3 a(surface.positions[3 * triangle]);
        const glm::dvec3 b(surface.positions[3 * triangle + 1]);
        const glm::dvec3 c(surface.positions[3 * triangle + 2]);
        area += 0.5 * glm::length(glm::cross(b - a, c - a));
    }
    for (const glm::vec3& position : surface.positions) {
        const glm::dvec3 world = surface.frame.to_world(position);
        inspection.box_low = glm::min(inspection.box_low, world);
        inspection.box_high = glm::max(inspection.box_high, world);
    }
    inspection.area = area / (surface.frame.scale() * surface.frame.scale());
}

/// An edge of a chart in its page: both ends in texels, the lesser end first.
using Edge = std::tuple<float, float, float, float>;

/// How many closed texel squares the charts of a page meet: a convex figure of area A and extents W × H, placed at
/// random, meets A + W + H + 1 of them on average; Σ |dx| + |dy| over its outline is 2 (W + H).
double expected_coverage(const Atlas& atlas, std::uint32_t page) {
    const glm::dvec2 size(atlas.pages[page].width, atlas.pages[page].height);
    double area = 0.0;
    std::map<std::pair<std::uint32_t, Edge>, int> edges;
    std::set<std::uint32_t> charts;
    for (std::size_t triangle = 0; triangle < atlas.page.size(); ++triangle) {
        if (atlas.page[triangle] != page) {
            continue;
        }
        charts.insert(atlas.chart[triangle]);
        const glm::vec2* uv = &atlas.uvs[3 * triangle];
        const glm::dvec2 ab = glm::dvec2(uv[1] - uv[0]) * size;
        const glm::dvec2 ac = glm::dvec2(uv[2] - uv[0]) * size;
        area += 0.5 * std::abs(ab.x * ac.y - ab.y * ac.x);
        for (int corner = 0; corner < 3; ++corner) {
            glm::vec2 from = uv[corner];
            glm::vec2 to = uv[(corner + 1) % 3];
            if (std::tie(to.x, to.y) < std::tie(from.x, from.y)) {
                std::swap(from, to);
            }
            ++edges[{atlas.chart[triangle], Edge{from.x, from.y, to.x, to.y}}];
        }
    }
    double outline = 0.0;
    for (const auto& [key, count] : edges) {
        if (count == 1) {
            const auto& [x0, y0, x1, y1] = key.second;
            outline += std::abs(double{x1} - double{x0}) * size.x + std::abs(double{y1} - double{y0}) * size.y;
        }
    }
    return std::min(area + 0.5 * outline + static_cast<double>(charts.size()), size.x * size.y);
}

/// A texel, at the most.
std::uint64_t rays_to_lamps(const Scene& scene, const Settings& settings, std::uint64_t rays_a_soft_one) {
    if (settings.mode != Mode::irradiance || settings.lamps == Switch::off) {
        return 0;
    }
    std::uint64_t rays = 0;
    for (const Lamp& lamp : scene.lamps) {
        rays += lamp.is_soft() ? rays_a_soft_one : 1;
    }
    return rays;
}

/// Of bounces and of directional maps, a texel.
std::uint64_t later_rays(const Scene& scene, const Settings& settings, const Inspection& inspection) {
    const std::uint64_t bounce_rays = settings.sampler == Sampler::thesis ? 256 : settings.bounce_rays;
    std::uint64_t rays = reflects(scene) || emits(scene) ? settings.bounces * bounce_rays : 0;
    if (settings.directional == Switch::on) {
        const bool has_sun = std::ranges::any_of(
            inspection.plan, [](const PlanEntry& entry) { return entry.phenomenon == "sun" && entry.modelled; });
        rays +=
            (has_sun ? 2 : 1) * settings.directional_rays + rays_to_lamps(scene, settings, settings.directional_rays);
    }
    return rays;
}

/// `start`: when what a bake does before it traces began.
void foretell_rays(const Scene& scene, const Surface& surface, const Atlas& atlas, const Settings& settings,
                   const Sky& sky, std::chrono::steady_clock::time_point start, Inspection& inspection) {
    inspection.rays = inspection.covered_texels * later_rays(scene, settings, inspection);
    if (inspection.memory > inspection.memory_limit) {
        return;
    }
    Settings left = settings;
    if (settings.seconds) { // a bake takes as long for that, and for what needs the device
        constexpr double device_seconds = 0.5;
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        left.seconds = std::max(*settings.seconds - taken.count() - device_seconds, 0.1 * *settings.seconds);
    }
    try {
        const ForetoldTrace trace = foretell_trace(scene, surface, atlas, left, sky, inspection.covered_texels);
        inspection.rays += static_cast<std::uint64_t>(std::llround(trace.rays));
        inspection.trace_seconds = trace.seconds;
        inspection.error = trace.error;
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::bad_input) {
            throw;
        }
        inspection.notes.emplace_back(error.what()); // a bake says so too
    }
}

void foretell_bake(const Scene& scene, const Surface& surface, const Settings& settings, const Sky& sky,
                   std::chrono::steady_clock::time_point start, Inspection& inspection) {
    if (surface.triangle_count() == 0) {
        inspection.notes.emplace_back("there is nothing to bake: no node shows a triangle");
        return;
    }
    const auto add_notes = [&](const std::vector<std::string>& notes) {
        inspection.notes.insert(inspection.notes.end(), notes.begin(), notes.end());
    };
    add_notes(check_resolution(scene, surface));
    const Atlas atlas = make_atlas(scene, surface, settings);
    inspection.charts = atlas.chart_count;
    inspection.pages = atlas.pages.size();
    inspection.density = atlas.density;
    add_notes(atlas.notes);
    add_notes(note_small_texels(surface, atlas));
    for (std::uint32_t page = 0; page < atlas.pages.size(); ++page) {
        inspection.covered_texels += static_cast<std::uint64_t>(std::llround(expected_coverage(atlas, page)));
    }
    inspection.memory = peak_memory(memory_need(scene, sky, settings, &atlas));
    inspection.memory_limit = memory_limit(settings);
    foretell_rays(scene, surface, atlas, settings, sky, start, inspection);
}

Inspection inspect_scene(const Scene& scene, const Settings& settings, const Sky& sky) {
    Inspection inspection;
    inspection.meshes = scene.meshes.size();
    inspection.instances = scene.instances.size();
    inspection.materials = scene.materials.size();
    inspection.images = scene.images.size();
    inspection.cameras = scene.cameras.size();
    inspection.lamps = scene.lamps.size();
    inspection.plan = make_plan(scene, settings, sky);
    inspection.notes = scene.notes;
    for (const Instance& instance : scene.instances) {
        const auto& primitives = scene.meshes.at(instance.mesh).primitives;
        inspection.instances_with_uvs += std::all_of(primitives.begin(), primitives.end(),
                                                     [](const Primitive& part) { return !part.tex_coords[1].empty(); });
    }
    std::set<std::string> light_maps;
    for (const Material& material : scene.materials) {
        if (material.light_map && light_maps.insert(material.light_map->linear_file).second) {
            inspection.light_maps.push_back(material.light_map->linear_file);
        }
    }
    const auto start = std::chrono::steady_clock::now();
    const Surface surface = make_surface(scene);
    measure_surface(surface, inspection);
    foretell_bake(scene, surface, settings, sky, start, inspection);
    return inspection;
}

} // namespace

Inspection inspect(const Scene& scene, const Settings& settings, const Sky& sky) {
    return at_boundary([&] { return inspect_scene(scene, settings, sky); });
}

} // namespace vkbake
