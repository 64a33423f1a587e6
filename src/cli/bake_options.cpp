#include "bake_options.hpp"

#include "choice.hpp"
#include "vkbake/vkbake.hpp"

namespace vkbake::cli {
namespace {

double quality_error(const std::string& name) { return name == "draft" ? 0.03 : name == "preview" ? 0.015 : 0.005; }

} // namespace

Sky SkyOptions::load() const {
    Sky sky = load_sky(source);
    sky.rotation_degrees = rotation_degrees;
    sky.intensity = intensity;
    return sky;
}

void add_load_options(CLI::App& app, LoadSettings& settings) {
    app.add_flag("--outside-files", settings.outside_files,
                 "Let the scene refer to files outside its own folder (by \"..\")");
}

void add_sky_options(CLI::App& app, SkyOptions& options) {
    app.add_option("--sky", options.source,
                   "The light from all around: clear (the CIE standard clear sky), a colour R,G,B, an equirectangular "
                   "image, a cube map as a strip or cross, or six files separated by commas")
        ->type_name("FILE|R,G,B|clear")
        ->capture_default_str();
    app.add_option("--sky-rotate", options.rotation_degrees, "Turn the sky about +Y, degrees")->capture_default_str();
    app.add_option("--sky-intensity", options.intensity, "Multiply the sky's radiance")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
}

void add_atlas_options(CLI::App& app, Settings& settings) {
    app.add_option("--size", settings.size,
                   "Side of a page, or of each object's map, in texels; 0: the least that --density allows")
        ->check(CLI::Range(0, 16384))
        ->capture_default_str();
    app.add_option_function<double>(
           "--density", [&settings](double density) { settings.density = density; },
           "Texels per metre; without it, the most that fit one page")
        ->check(CLI::PositiveNumber);
    add_choice(app, "--layout", settings.layout, "One map for the scene, or one for each object");
    add_choice(app, "--uv", settings.uv,
               "Keep TEXCOORD_1 where it will do and make it elsewhere; keep it; keep it even where it overlaps "
               "itself; make it");
    add_choice(app, "--charts", settings.charts, "How charts are made: few and of little stretch, or by facing");
    app.add_option("--stretch", settings.stretch, "L2 stretch that grown charts may have; 1 is none")
        ->check(CLI::Range(1.0001, 2.0))
        ->capture_default_str();
    app.add_option("--gutter", settings.gutter, "Empty texels between charts")
        ->check(CLI::Range(0, 64))
        ->capture_default_str();
    app.add_option("--max-pages", settings.max_pages, "How many pages may be opened")
        ->check(CLI::Range(1, 4096))
        ->capture_default_str();
}

namespace {

void add_error_options(CLI::App& app, Settings& settings) {
    app.add_option_function<double>(
           "--target-error", [&settings](double error) { settings.target_error = error; },
           "Instead of --rays and --bounce-rays: the relative error (RMSE / mean) that each map is to have, e.g. 0.01; "
           "with --denoise once it is denoised")
        ->check(CLI::PositiveNumber);
    app.add_option_function<std::string>(
           "--quality",
           [&settings](const std::string& name) { // --denoise comes after it, so that what is said there holds
               settings.target_error = quality_error(name);
               settings.denoise = name == "final" ? Switch::off : Switch::on;
           },
           "A named target error: draft (3 %), preview (1.5 %), both denoised, final (0.5 %)")
        ->check(CLI::IsMember({"draft", "preview", "final"}))
        ->type_name("draft|preview|final");
    app.add_option_function<double>(
           "--time", [&settings](double seconds) { settings.seconds = seconds; },
           "Instead of --rays: seconds that the bake may take; the best maps that they allow")
        ->check(CLI::PositiveNumber);
    app.add_flag("--error-map", settings.estimate_error,
                 "Estimate each texel's error and write it beside the light map; costs no rays");
    add_choice(app, "--reuse", settings.reuse,
               "Spare samples a ray where all those around them met alike; without it, on where an error or a time is "
               "asked for");
    add_choice(app, "--denoise", settings.denoise,
               "Filter noise out where neighbouring texels differ by no more than their errors explain");
    add_choice(app, "--blend-creases", settings.blend_creases,
               "Mix the light of both sides in texels on a crease inside a chart, so that it has no teeth there");
}

void add_tracing_options(CLI::App& app, Settings& settings) {
    add_choice(app, "--sampler", settings.sampler, "How directions are chosen");
    add_choice(app, "--accelerator", settings.accelerator, "What rays are traced against; never changes the result");
    add_choice(app, "--triangle-test", settings.triangle_test,
               "The ray-triangle test; moller-trumbore with brute and clusters only");
    app.add_option("--cluster-splits", settings.cluster_splits, "Parts that the clusters cut each axis into")
        ->check(CLI::Range(1, 64))
        ->capture_default_str();
    app.add_option("--seed", settings.seed, "Of the random numbers")->capture_default_str();
    app.add_option("--padding", settings.padding, "Rounds of dilation around the charts")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    app.add_option("--threads", settings.threads, "That trace; 0: all cores. Never changes the result")
        ->check(CLI::Range(0, 4096))
        ->capture_default_str();
    app.add_option("--memory-limit", settings.memory_limit,
                   "What a bake may take, checked before it starts; without it, three quarters of what the machine has")
        ->transform(CLI::AsSizeValue(false).description(""))
        ->type_name("BYTES|8G");
}

} // namespace

void add_light_options(CLI::App& app, Settings& settings) {
    add_choice(app, "--mode", settings.mode,
               "What a texel stores: the radiance of a white surface (E/pi), visibility, or the mean open direction");
    app.add_option_function<double>(
           "--ao-distance", [&settings](double metres) { settings.ao_distance = metres; },
           "Metres beyond which nothing occludes (modes ao and bent-normal)")
        ->check(CLI::PositiveNumber);
    add_choice(app, "--ao-falloff", settings.ao_falloff,
               "What a surface hides up to that distance: all of what is behind it, or less the farther it is");
    app.add_option("--rays", settings.rays, "Rays a texel")->check(CLI::Range(1U, 1U << 24U))->capture_default_str();
    add_choice(app, "--lamps", settings.lamps,
               "Bake the scene's lamps (KHR_lights_punctual), or leave them for whoever draws it");
    add_choice(app, "--sun", settings.sun,
               "Sample the brightest places of a sky's picture on their own, where that is worth as many rays again");
    app.add_option("--bounces", settings.bounces,
                   "How often light is followed from surface to surface; the first also brings what surfaces emit")
        ->check(CLI::Range(0U, 64U))
        ->capture_default_str();
    app.add_option("--bounce-rays", settings.bounce_rays,
                   "Rays a texel of each bounce; where an error is asked for, as many as that takes")
        ->check(CLI::Range(1U, 1U << 24U))
        ->capture_default_str();
    add_choice(app, "--directional", settings.directional,
               "Write where each texel's light comes from beside the light map, for renderers with normal maps");
    app.add_option("--directional-rays", settings.directional_rays, "Rays a texel for --directional")
        ->check(CLI::Range(1U, 1U << 24U))
        ->capture_default_str();
    app.add_option_function<std::vector<std::uint32_t>>(
           "--probes",
           [&settings](const std::vector<std::uint32_t>& counts) {
               settings.probe_grid = {counts.at(0), counts.at(1), counts.at(2)};
           },
           "A grid of light probes in the scene's box, beside those of nodes with extras.vkbake.probe")
        ->expected(3)
        ->delimiter(',')
        ->check(CLI::Range(1U, 1024U))
        ->type_name("NX,NY,NZ");
    app.add_option("--probe-rays", settings.probe_rays, "Rays of a light probe")
        ->check(CLI::Range(1U, 1U << 24U))
        ->capture_default_str();
    add_choice(app, "--alpha", settings.alpha,
               "Let light through where a material's alpha or transmission does, or take all surfaces for whole");
    add_error_options(app, settings);
    add_tracing_options(app, settings);
}

} // namespace vkbake::cli
