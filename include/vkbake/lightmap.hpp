// What a bake gives back.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "vkbake/atlas.hpp"
#include "vkbake/image.hpp"
#include "vkbake/light_probe.hpp"
#include "vkbake/settings.hpp"
#include "vkbake/surface.hpp"

namespace vkbake {

/// Counts over one map. All but `seconds` are the same for every machine, thread count and accelerator.
struct LightMapStatistics {
    std::uint64_t covered_texels = 0;
    std::uint64_t rays = 0;               ///< traced
    std::uint64_t occluded_rays = 0;      ///< of those: nothing comes along them
    std::uint64_t filtered_rays = 0;      ///< of those: met a triangle that is not opaque, and were looked up there
    std::uint64_t skipped_directions = 0; ///< at or below the geometric plane: add nothing, not traced
    std::uint64_t spared_rays = 0;        ///< samples without a ray: Settings::reuse
    std::uint64_t probed_hits = 0;        ///< hits among the rays whose nearest hit was looked at (one a texel)
    std::uint64_t back_side_hits = 0;     ///< of those, on a triangle's back
    std::uint64_t bounce_rays = 0;        ///< traced beside `rays`, for what surfaces reflect and emit
    std::uint64_t lamp_rays = 0;          ///< traced beside `rays`, towards lamps
    std::uint64_t peak_rays = 0;          ///< traced beside both, towards the sky's brightest places
    std::uint64_t directional_rays = 0;   ///< traced beside all these, for LightMap::directional
    std::uint64_t denoised_texels = 0;    ///< that the denoiser changed
    std::uint64_t blended_texels = 0;     ///< on creases: Settings::blend_creases
    std::uint64_t filled_texels = 0;      ///< by dilation
    double seconds = 0.0;                 ///< tracing
    /// For each of Scene::lamps the rays that reached it; empty where no lamps were baked.
    std::vector<std::uint64_t> lamps_reached;
};

/// What a map's own samples say of its error: of luminance (Rec. 709), noise alone (what one sample point a texel
/// cannot show is no part of it). Of all light, that of bounces with it; rays and slope are of the direct light.
struct MapError {
    double relative_rmse = 0.0; ///< root-mean-square error over the covered texels ÷ the map's mean
    double percentile_99 = 0.0; ///< of the texels' standard errors ÷ the map's mean
    /// Where the map was denoised: relative_rmse before; else 0. relative_rmse is then an estimate of what is left, the
    /// bias of the filter with it (Stein's unbiased estimate of risk).
    double noise_rmse = 0.0;
    bool target_reached =
        true; ///< false where 65536 rays a texel, or the time, were too few for Settings::target_error
    // Rays a texel, and samples at or below the geometric plane; 0 where all texels were given the same number
    double mean_rays = 0.0;      ///< without those that Settings::reuse spared
    double best_mean_rays = 0.0; ///< the least that the measured variances allow for this error, each sample a ray
    double uniform_rays = 0.0;   ///< that would do as well if all texels had the same number, each a ray: foretold
    double slope = 0.0;          ///< of log error against log rays, as this map's samples show it
};

struct LightMap {
    std::string name; ///< AtlasPage::name
    Image image;      ///< RGB: as Settings::mode has it; A: 1 where there is a value to sample; coverage: 1 where baked
    LightMapStatistics statistics;
    /// Where Settings::directional was on: four images of RGB coefficients, ∫ L Y over the light that arrives from
    /// above the texel's surface, of the real orthonormal spherical harmonics of world directions: 0.282095,
    /// 0.488603 y, 0.488603 z, 0.488603 x. A as `image` has it; their coverage is empty, being that of `image`.
    /// share/vkbake/glsl/vkbake_light.h evaluates them.
    std::vector<Image> directional;
    // Where Settings::estimate_error was set:
    std::optional<MapError> error;
    /// Row-major as the image's texels; 0 where not baked. Of luminance: the truth lies within ± 2.365 standard errors
    /// of the texel's value with a probability of 95 % (Student's t, 7 degrees of freedom: contrasts of eight parts of
    /// the texel's sequence). Never less than what no hit, or no miss, in all its samples would allow. Where the texel
    /// was denoised: the root of the squared error to be expected of it, noise and bias, as the texels around it show
    /// it.
    std::vector<float> standard_error;
    std::vector<std::uint32_t> texel_rays; ///< samples a texel; row-major, 0 where not baked
};

struct StageSeconds {
    std::string stage;
    double seconds = 0.0;
};

struct Bake {
    Settings settings;
    std::string device; ///< the Vulkan device's name and driver
    std::string sky;    ///< Sky::name
    Surface surface;
    Atlas atlas;
    std::vector<LightMap> light_maps; ///< one a page, in the pages' order
    std::vector<LightProbe> probes;   ///< of the scene's nodes, then the grid's
    std::optional<ProbeGrid> probe_grid;
    std::uint64_t probe_rays = 0;     ///< traced for probes
    std::vector<StageSeconds> stages; ///< in the order they ran
    std::vector<std::string> notes;
};

} // namespace vkbake
