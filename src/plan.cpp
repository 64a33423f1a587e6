#include "vkbake/plan.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <system_error>

#include "base/boundary.hpp"
#include "material/surface_colors.hpp"
#include "trace/peak_cut.hpp"
#include "trace/surface_opacity.hpp"
#include "vkbake/names.hpp"

namespace vkbake {

namespace {

std::size_t count_materials(const Scene& scene, const std::function<bool(const Material&)>& property) {
    return static_cast<std::size_t>(std::ranges::count_if(scene.materials, property));
}

std::string of_materials(std::size_t count, const Scene& scene) {
    return std::to_string(count) + " of " + std::to_string(scene.materials.size()) + " materials";
}

std::string rays_text(std::uint32_t rays, Sampler sampler) {
    return std::to_string(sampler == Sampler::thesis ? 256U : rays) + " rays a texel";
}

/// Of what an error or a time asked for decides about; `rays`: where none is.
std::string rays_text(std::uint32_t rays, const Settings& settings) {
    if (settings.target_error) {
        return "as many rays as its error takes";
    }
    return settings.seconds ? "as many rays as the time allows" : rays_text(rays, settings.sampler);
}

/// "0.4 %"
std::string percent(double share) {
    const auto tenths = static_cast<long long>(std::ceil(share * 1000.0 - 1e-9));
    return std::to_string(tenths / 10) + (tenths % 10 == 0 ? "" : "." + std::to_string(tenths % 10)) + " %";
}

/// "2.5"
std::string shortest_text(double value) {
    std::array<char, 32> text{};
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() ? std::string(text.data(), end) : std::to_string(value);
}

/// No surface reflects a greater share than this, in any channel.
double greatest_albedo(const Scene& scene) {
    double greatest = 0.0;
    const Material absent;
    for (const Mesh& mesh : scene.meshes) {
        for (const Primitive& primitive : mesh.primitives) {
            const bool known = primitive.material && *primitive.material < scene.materials.size();
            const Material& material = known ? scene.materials[*primitive.material] : absent;
            const float color = std::max({material.base_color.r, material.base_color.g, material.base_color.b});
            const float metallic = material.metallic_texture ? 0.0F : std::clamp(material.metallic, 0.0F, 1.0F);
            greatest = std::max(greatest, static_cast<double>(std::clamp(color, 0.0F, 1.0F) * (1.0F - metallic)));
        }
    }
    return greatest;
}

std::string no_light(const Settings& settings) {
    return "mode " + std::string(name_of(settings.mode)) + " has no light";
}

PlanEntry plan_sky(const Settings& settings) {
    if (settings.mode != Mode::irradiance) {
        return {"sky", false, "mode " + std::string(name_of(settings.mode)) + " asks what is open, whatever the sky"};
    }
    return {"sky", true, "its direct light, " + rays_text(settings.rays, settings)};
}

PlanEntry plan_visibility(const Settings& settings) {
    if (settings.mode == Mode::irradiance) {
        return {"visibility", false, "not asked for (--mode ao or bent-normal)"};
    }
    std::string reason = settings.mode == Mode::ao ? "the share of the hemisphere that is open"
                                                   : "the mean direction that is open, as long as the share that is";
    if (settings.ao_distance) {
        reason += "; surfaces within " + shortest_text(*settings.ao_distance) + " m count";
        if (settings.ao_falloff != Falloff::none) {
            reason += ", the farther the less (" + std::string(name_of(settings.ao_falloff)) + ")";
        }
    }
    return {"visibility", true, reason + ", " + rays_text(settings.rays, settings)};
}

PlanEntry plan_sun(const Sky& sky, const Settings& settings) {
    if (settings.mode != Mode::irradiance) {
        return {"sun", false, no_light(settings)};
    }
    if (settings.sampler != Sampler::cosine) {
        return {"sun", false, "the sampler " + std::string(name_of(settings.sampler)) + " looks for none"};
    }
    const PeakCut cut = find_peaks(make_sky_lookup(sky));
    if (!cut.worthwhile()) {
        return {"sun", false, "no part of the sky is so bright that it wants rays of its own"};
    }
    return settings.sun == Switch::on
               ? PlanEntry{"sun", true,
                           describe(cut) + ": sampled on its own, " + rays_text(settings.rays, settings) + " more"}
               : PlanEntry{"sun", false, describe(cut) + ": found by chance (--sun off)"};
}

/// "1 hard lamp", "2 soft lamps"
std::string of_lamps(std::size_t count, const char* kind) {
    return std::to_string(count) + kind + (count == 1 ? " lamp" : " lamps");
}

PlanEntry plan_lamps(const Scene& scene, const Settings& settings) {
    if (scene.lamps.empty()) {
        return {"lamps", false, "the scene has none"};
    }
    if (settings.mode != Mode::irradiance) {
        return {"lamps", false, of_lamps(scene.lamps.size(), "") + "; " + no_light(settings)};
    }
    if (settings.lamps == Switch::off) {
        return {"lamps", false, of_lamps(scene.lamps.size(), "") + ", left to whoever draws the scene (--lamps off)"};
    }
    const auto soft = static_cast<std::size_t>(std::ranges::count_if(scene.lamps, &Lamp::is_soft));
    const std::size_t hard = scene.lamps.size() - soft;
    std::string reason = hard > 0 ? of_lamps(hard, " hard") + ", 1 ray a texel each" : "";
    if (soft > 0) {
        reason +=
            (hard > 0 ? "; " : "") + of_lamps(soft, " soft") + ", " + rays_text(settings.rays, settings) + " each";
    }
    return {"lamps", true, reason};
}

PlanEntry plan_bounces(const Scene& scene, const Settings& settings) {
    if (settings.mode != Mode::irradiance) {
        return {"bounces", false, no_light(settings)};
    }
    if (!reflects(scene)) {
        return {"bounces", false, "no surface reflects"};
    }
    const double albedo = greatest_albedo(scene);
    if (settings.bounces == 0) {
        return {"bounces", false,
                "not asked for (--bounces); surfaces reflect up to " + percent(albedo) + " of what they get"};
    }
    return {"bounces", true,
            std::to_string(settings.bounces) + ", " + rays_text(settings.bounce_rays, settings) +
                " each; light of later ones is at most " + percent(std::pow(albedo, settings.bounces)) +
                " of the first's"};
}

PlanEntry plan_directional(const Scene& scene, const Settings& settings) {
    const std::size_t count =
        count_materials(scene, [](const Material& material) { return material.normal_map.has_value(); });
    const std::string normal_maps =
        count == 0 ? "no material has a normal map"
                   : of_materials(count, scene) + (count == 1 ? " has a normal map" : " have normal maps");
    if (settings.mode != Mode::irradiance) {
        return {"directions", false, normal_maps + "; " + no_light(settings)};
    }
    if (settings.directional == Switch::off) {
        return {"directions", false, "not asked for (--directional on); " + normal_maps};
    }
    return {"directions", true,
            "four maps beside each light map, " + rays_text(settings.directional_rays, Sampler::cosine) + " more; " +
                normal_maps};
}

PlanEntry plan_probes(const Scene& scene, const Settings& settings) {
    std::uint64_t count = scene.probes.size();
    if (settings.probe_grid) {
        const auto& [x, y, z] = *settings.probe_grid;
        count += std::uint64_t{x} * y * z;
    }
    if (count == 0) {
        return {"light probes", false, "no node asks for one (extras.vkbake.probe), nor does --probes"};
    }
    const std::string probes = std::to_string(count) + (count == 1 ? " probe" : " probes");
    return settings.mode == Mode::irradiance
               ? PlanEntry{"light probes", true, probes + ", " + std::to_string(settings.probe_rays) + " rays each"}
               : PlanEntry{"light probes", false, probes + "; " + no_light(settings)};
}

PlanEntry plan_emission(const Scene& scene, const Settings& settings) {
    if (!emits(scene)) {
        return {"emission", false, "no surface emits"};
    }
    const std::string materials = of_materials(count_materials(scene, [](const auto& m) { return emits(m); }), scene);
    if (settings.mode != Mode::irradiance) {
        return {"emission", false, materials + " emit; " + no_light(settings)};
    }
    return settings.bounces > 0
               ? PlanEntry{"emission", true,
                           materials + ", with the first bounce's rays; what is small and bright has rays of its own"}
               : PlanEntry{"emission", false, materials + " emit, which --bounces 1 or more would bring"};
}

PlanEntry plan_textures(const Scene& scene, const Settings& settings) {
    const auto needed = static_cast<std::size_t>(
        std::ranges::count_if(color_uses(scene, settings.alpha), [](ColorUse use) { return use != ColorUse::none; }));
    const std::string images = std::to_string(needed) + (needed == 1 ? " image" : " images");
    if (needed == 0) {
        return {"albedo textures", false, "none that reflects or emits"};
    }
    return settings.bounces > 0 && settings.mode == Mode::irradiance
               ? PlanEntry{"albedo textures", true, images}
               : PlanEntry{"albedo textures", false, images + ", not decoded: there are no bounces"};
}

PlanEntry plan_alpha(const Scene& scene, const Settings& settings) {
    std::set<std::uint32_t> materials;
    std::size_t triangles = 0;
    std::size_t all = 0;
    for (const Instance& instance : scene.instances) {
        for (const Primitive& primitive : scene.meshes.at(instance.mesh).primitives) {
            all += primitive.indices.size() / 3;
            if (lets_light_through(scene, primitive)) {
                materials.insert(*primitive.material);
                triangles += primitive.indices.size() / 3;
            }
        }
    }
    if (triangles == 0) {
        return {"alpha", false, "no surface lets light through"};
    }
    const std::string what = of_materials(materials.size(), scene) + ", " +
                             percent(static_cast<double>(triangles) / static_cast<double>(all)) + " of the triangles";
    return settings.alpha == Alpha::opaque
               ? PlanEntry{"alpha", false, what + ", let light through: taken for whole (--alpha opaque)"}
               : PlanEntry{"alpha", true, what + ": looked up where rays meet them"};
}

} // namespace

std::vector<PlanEntry> make_plan(const Scene& scene, const Settings& settings, const Sky& sky) {
    return at_boundary([&] {
        return std::vector<PlanEntry>{plan_sky(settings),
                                      plan_visibility(settings),
                                      plan_sun(sky, settings),
                                      plan_lamps(scene, settings),
                                      plan_bounces(scene, settings),
                                      plan_emission(scene, settings),
                                      plan_directional(scene, settings),
                                      plan_probes(scene, settings),
                                      plan_textures(scene, settings),
                                      plan_alpha(scene, settings)};
    });
}

} // namespace vkbake
