#include "bounces.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "bounce_error.hpp"
#include "imageio/decode.hpp"
#include "material/color_texture.hpp"
#include "material/surface_colors.hpp"
#include "trace/directional_map.hpp"
#include "trace/known_light.hpp"
#include "trace/surface_light.hpp"

namespace vkbake {

namespace {

std::vector<ColorTexture> decode_textures(const Scene& scene, Alpha alpha) {
    const std::vector<ColorUse> uses = color_uses(scene, alpha);
    std::vector<ColorTexture> textures(scene.images.size());
    for (std::size_t image = 0; image < textures.size(); ++image) {
        if (uses[image] != ColorUse::none) {
            const Rgba8Image decoded = decode_rgba8(scene.images[image]);
            textures[image] = make_color_texture(decoded.width, decoded.height, decoded.texels,
                                                 uses[image] == ColorUse::linear ? Encoding::linear : Encoding::srgb);
        }
    }
    return textures;
}

std::vector<std::uint8_t> two_sided_parts(const Scene& scene, const Surface& surface) {
    std::vector<std::uint8_t> two_sided;
    for (const SurfacePart& part : surface.parts) {
        const Instance& instance = scene.instances.at(surface.objects.at(part.object).instance);
        const auto& material = scene.meshes.at(instance.mesh).primitives.at(part.primitive).material;
        const bool shows_back =
            material && *material < scene.materials.size() && scene.materials[*material].double_sided;
        two_sided.push_back(shows_back ? 1 : 0);
    }
    return two_sided;
}

/// What leaves a page's texels of the light `map` that arrives at them, and of their own.
LeavingLight leaving(const Image& map, const SurfaceColors& colors, bool with_emission) {
    LeavingLight light{.width = map.width,
                       .height = map.height,
                       .radiance = std::vector<glm::vec3>(map.texels.size(), glm::vec3(0.0F)),
                       .covered = std::vector<std::uint8_t>(map.texels.size(), 0)};
    for (std::size_t texel = 0; texel < map.texels.size(); ++texel) {
        if (map.coverage[texel] == 0.0F) {
            continue;
        }
        light.covered[texel] = 1;
        light.radiance[texel] = colors.albedo[texel] * glm::vec3(map.texels[texel]);
        if (with_emission && !colors.emission.empty()) {
            light.radiance[texel] += colors.emission[texel];
        }
    }
    return light;
}

/// Adds light to what has been sent, of which there may be nothing yet.
void add(const std::vector<LeavingLight>& lights, std::vector<LeavingLight>& sent) {
    if (sent.empty()) {
        sent = lights;
        return;
    }
    for (std::size_t page = 0; page < lights.size(); ++page) {
        std::transform(lights[page].radiance.begin(), lights[page].radiance.end(), sent[page].radiance.begin(),
                       sent[page].radiance.begin(), std::plus<>());
    }
}

} // namespace

SentLight add_bounces(const Scene& scene, const Tracer& tracer,
                      const std::function<const GeometryImage&(std::size_t)>& draw, StageClock& clock, Bake& bake) {
    SentLight sent;
    if (!reflects(scene) && !emits(scene)) {
        bake.notes.push_back(scene.name + ": no surface reflects or emits light; nothing was traced for bounces");
        return sent;
    }
    const std::size_t pages = bake.light_maps.size();
    sent.two_sided = two_sided_parts(scene, bake.surface);
    std::vector<SurfaceColors> colors;
    std::vector<LeavingLight> lights;
    clock.run("surface colors", [&] {
        const std::vector<ColorTexture> textures = decode_textures(scene, bake.settings.alpha);
        for (std::size_t page = 0; page < pages; ++page) {
            colors.push_back(make_surface_colors(scene, bake.surface, draw(page), textures, bake.settings.alpha));
            lights.push_back(leaving(bake.light_maps[page].image, colors[page], true));
            lights[page].sought = std::move(colors[page].emission); // which is sent once
        }
        return 0;
    });
    for (std::uint32_t bounce = 1; bounce <= bake.settings.bounces; ++bounce) {
        if (bake.settings.directional == Switch::on) {
            add(lights, sent.pages);
        }
        const SurfaceLight light(bake.surface, bake.atlas, lights, sent.two_sided);
        const std::optional<EmitterSet> emitters = tracer.find_emitters(light);
        if (emitters && bounce == 1) {
            bake.notes.push_back(scene.name + ": " + std::to_string(emitters->count()) +
                                 " triangles are far brighter than the rest; rays seek them");
        }
        std::vector<LeavingLight> next;
        for (std::size_t page = 0; page < pages; ++page) {
            clock.begin_page((bounce - 1) * pages + page, bake.settings.bounces * pages);
            const LightMap gathered = clock.run("bounces", [&] {
                const GatherOptions options{emitters ? &*emitters : nullptr, known_light(bake.light_maps[page])};
                return tracer.gather(draw(page), light, bounce, options, clock.trace_progress("bounces"));
            });
            add_bounce(gathered, bake.light_maps[page]);
            next.push_back(leaving(gathered.image, colors[page], false));
            if (emitters) {
                next[page].sought = next[page].radiance; // what small lamps light beside them is small and bright too
            }
        }
        lights = std::move(next);
    }
    return sent;
}

SentLight light_from_maps(const Scene& scene, const std::function<const GeometryImage&(std::size_t)>& draw,
                          const Bake& bake) {
    SentLight sent{.pages = {}, .two_sided = two_sided_parts(scene, bake.surface)};
    const std::vector<ColorTexture> textures = decode_textures(scene, bake.settings.alpha);
    for (std::size_t page = 0; page < bake.light_maps.size(); ++page) {
        SurfaceColors colors = make_surface_colors(scene, bake.surface, draw(page), textures, bake.settings.alpha);
        sent.pages.push_back(leaving(bake.light_maps[page].image, colors, true));
        sent.pages[page].sought = std::move(colors.emission);
    }
    return sent;
}

void add_directional(const Tracer& tracer, const SentLight& sent,
                     const std::function<const GeometryImage&(std::size_t)>& draw, StageClock& clock, Bake& bake) {
    const std::size_t pages = bake.light_maps.size();
    std::optional<SurfaceLight> light;
    if (!sent.pages.empty()) {
        light.emplace(bake.surface, bake.atlas, sent.pages, sent.two_sided);
    }
    const std::optional<EmitterSet> emitters = light ? tracer.find_emitters(*light) : std::nullopt;
    for (std::size_t page = 0; page < pages; ++page) {
        clock.begin_page(page, pages);
        DirectionalMap map = clock.run("directional", [&] {
            return trace_directional(tracer, draw(page), light ? &*light : nullptr, emitters ? &*emitters : nullptr,
                                     clock.trace_progress("directional"));
        });
        LightMap& of = bake.light_maps[page];
        of.directional = std::move(map.coefficients);
        of.statistics.directional_rays = map.rays;
        of.statistics.seconds += map.seconds;
    }
}

} // namespace vkbake
