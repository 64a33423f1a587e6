// What a bake is asked for. Every field has the default that suits a first run; flags only fill it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace vkbake {

enum class Layout : std::uint8_t { atlas, object }; ///< one map for the scene (pages as needed), or one for each object
enum class UvSource : std::uint8_t {
    automatic,
    keep,
    trust,
    make
}; ///< automatic: keep TEXCOORD_1 where it will do, make it elsewhere; trust: keep it even where it overlaps itself
enum class ChartMaker : std::uint8_t {
    grown,
    polypack
}; ///< grown: few charts within a bound of stretch; polypack: the thesis's, by facing
enum class Mode : std::uint8_t {
    irradiance,
    ao,
    bent_normal
}; ///< E/π; cosine-weighted visibility; or the mean open direction, as long as visibility
/// What a surface at distance d hides where surfaces hide up to a distance D: all; 1 − d/D; (1 − d/D)².
enum class Falloff : std::uint8_t { none, linear, square };
enum class Switch : std::uint8_t { on, off };
enum class Alpha : std::uint8_t {
    traced,
    opaque
}; ///< traced: MASK, BLEND and transmission are looked up where rays meet them; opaque: all is whole
enum class Sampler : std::uint8_t {
    cosine,
    stratified,
    uniform,
    thesis
}; ///< cosine: scrambled Sobol points, spread by the cosine; stratified: random points, one in each of N cells,
   ///< likewise; uniform: independent directions, spread evenly; thesis: its own 256. All but cosine are there to be
   ///< measured
enum class Accelerator : std::uint8_t { bvh, clusters, brute };
enum class TriangleTest : std::uint8_t { watertight, moller_trumbore };

struct Settings {
    // Atlas
    int size = 1024; ///< side of a page or an object's map, texels; 1 … 16384, or 0: the least that `density` allows
    std::optional<double> density; ///< texels per metre, > 0; absent: the largest that fits one page
    Layout layout = Layout::atlas;
    UvSource uv = UvSource::automatic;
    ChartMaker charts = ChartMaker::grown; ///< how they are made where UVs are
    double stretch = 1.01; ///< charts `grown`: L2 stretch that a chart may have, 1 being none; 1.0001 … 2
    int gutter = 2;        ///< empty texels between charts that are made; 0 … 64
    int max_pages = 16;    ///< ≥ 1

    // Light
    Mode mode = Mode::irradiance;
    std::optional<double>
        ao_distance; ///< metres, > 0; modes ao and bent_normal: farther hits do not occlude. Absent: no limit
    /// How the distance makes surfaces hide less; with ao_distance only. Each ray that meets something is then asked by
    /// itself how far it is.
    Falloff ao_falloff = Falloff::none;
    std::uint32_t rays = 256; ///< a texel; ≥ 1. Sampler `thesis` always takes its own 256
    /// How often light is followed from surface to surface after the sky's; 0: the sky's direct light alone. The first
    /// also brings what surfaces emit. 0 … 64; mode irradiance.
    std::uint32_t bounces = 0;
    std::uint32_t bounce_rays = 64; ///< a texel and bounce; ≥ 1, 16 where errors are estimated. Sampler `thesis` always
                                    ///< takes its own 256
    /// Whether maps also tell where their light comes from (LightMap::directional), for renderers with normal maps, by
    /// `directional_rays` more rays a texel. Mode irradiance.
    Switch directional = Switch::off;
    std::uint32_t directional_rays = 64; ///< ≥ 1
    /// So many light probes along each axis of the scene's box, 1 … 1024 and 2²⁰ in all, beside those of the scene's
    /// nodes. Mode irradiance.
    std::optional<std::array<std::uint32_t, 3>> probe_grid;
    std::uint32_t probe_rays = 1024; ///< of each; ≥ 1
    Alpha alpha = Alpha::traced;
    /// Relative error that a map is to have: root-mean-square error of luminance ÷ the map's mean, and no more than one
    /// texel in a hundred with a standard error above eight times that. Each texel then gets as many rays as it takes,
    /// 16 to 65536, of direct light and of each bounce, whose light counts in both; `rays` and `bounce_rays` mean
    /// nothing; the errors are estimated. With `denoise` it is the denoised map's error, and rays are spared that the
    /// filter makes needless. > 0; sampler cosine.
    std::optional<double> target_error;
    /// Seconds that bake() may take, the map as good as they allow; with target_error, whichever is reached first. The
    /// result depends on the machine, unlike any other's. > 0; sampler cosine, no bounces.
    std::optional<double> seconds;
    /// Estimate each texel's error (LightMap::standard_error). Costs no rays; sampler cosine, 16 rays or more.
    bool estimate_error = false;
    /// Whether the scene's lamps are baked; mode ao has none. A hard one takes a ray a texel, a soft one as many as the
    /// sky does. off: they are left for whoever draws the scene.
    Switch lamps = Switch::on;
    /// Whether the brightest places of a sky's picture, its sun above all, are sampled on their own where that is worth
    /// it, with as many rays again; sampler cosine.
    Switch sun = Switch::on;
    /// Whether samples are spared a ray where all those of the texels around it, in the same part of the hemisphere and
    /// beside it, met alike: they are taken to meet the same. `rays` are then samples, of which often less than half
    /// are traced. The results are the same for every number of threads and every accelerator. Absent: where an error
    /// or a time is asked for. Sampler cosine, modes irradiance and ao.
    std::optional<Switch> reuse;
    Sampler sampler = Sampler::cosine;
    Accelerator accelerator = Accelerator::bvh;
    TriangleTest triangle_test = TriangleTest::watertight; ///< moller_trumbore: accelerators brute and clusters only
    int cluster_splits = 4;                                ///< parts an axis is cut into (the thesis has 4); 1 … 64
    std::uint64_t seed = 0;

    // Finish
    /// Whether noise is filtered out where neighbouring texels differ by no more than their own errors explain. The
    /// errors are then estimated, and those of the filtered map are told. Of the sky's and the lamps' direct light:
    /// bounces are added as they come. Sampler cosine, 16 rays or more.
    Switch denoise = Switch::off;
    /// Whether texels on a crease inside a chart hold the light of both sides, by how much of them lies on each; off:
    /// of the side that holds the texel's sample point, which gives the light teeth along creases that run aslant.
    Switch blend_creases = Switch::on;
    int padding = 8; ///< rounds of dilation; 0 … 1024

    // Machine
    int threads = 0; ///< workers that trace; 0: all that the machine has. Never changes the result
    /// Bytes that a bake may take, an estimate that is checked before the work starts; absent: three quarters of what
    /// the machine, or the process's control group, has. Never changes the result.
    std::optional<std::uint64_t> memory_limit;
};

/// Settings::reuse, or what it is where it is absent.
[[nodiscard]] constexpr bool reuses_visibility(const Settings& settings) {
    return settings.reuse ? *settings.reuse == Switch::on : settings.target_error || settings.seconds;
}

} // namespace vkbake
