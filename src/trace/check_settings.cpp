#include "trace/check_settings.hpp"

#include <cmath>
#include <cstdint>
#include <string>

#include "trace/contrasts.hpp"
#include "vkbake/error.hpp"

namespace vkbake {

void check_trace_settings(const Settings& settings) {
    const auto require = [](bool holds, const std::string& message) {
        if (!holds) {
            throw Error(ErrorKind::usage, "trace settings: " + message);
        }
    };
    require(settings.rays >= 1, "0 rays a texel; give 1 or more");
    const bool denoised = settings.denoise == Switch::on;
    const bool estimated = settings.estimate_error || settings.target_error || settings.seconds || denoised;
    require(
        !estimated || settings.sampler == Sampler::cosine,
        "no error estimate, which the denoiser needs too, for samplers without a sequence; choose the sampler cosine");
    require(!estimated || settings.mode != Mode::bent_normal,
            "no error estimate in mode bent-normal, whose texels are no sums; choose rays");
    const bool reused = settings.reuse == Switch::on;
    require(!reused || settings.sampler == Sampler::cosine,
            "no reuse of visibility for samplers without a sequence; choose the sampler cosine");
    require(!reused || settings.mode != Mode::bent_normal,
            "no reuse of visibility in mode bent-normal, whose texels are no sums; choose another mode");
    const bool adaptive = settings.target_error || settings.seconds;
    require(!(settings.estimate_error || denoised) || adaptive || settings.rays >= least_estimated_rays,
            "an error estimate of " + std::to_string(settings.rays) + " rays a texel; give 16 or more");
    require(!(settings.estimate_error || denoised) || settings.target_error || settings.bounces == 0 ||
                settings.bounce_rays >= least_estimated_rays,
            "an error estimate of " + std::to_string(settings.bounce_rays) +
                " rays a texel and bounce; give 16 or more");
    const auto positive = [](const std::optional<double>& value) {
        return !value || (std::isfinite(*value) && *value > 0.0);
    };
    require(positive(settings.target_error), "the target error is not a number above 0; give a share such as 0.01");
    require(!settings.seconds || settings.bounces == 0,
            "a time and bounces, whose time it does not share out; give rays or a target error");
    require(positive(settings.seconds), "the time is not a number above 0; give seconds");
    if (settings.ao_distance) {
        require(settings.mode != Mode::irradiance,
                "a distance limit in mode irradiance; choose mode ao or bent-normal, or leave the distance out");
        require(std::isfinite(*settings.ao_distance) && *settings.ao_distance > 0.0,
                "the distance limit is " + std::to_string(*settings.ao_distance) + "; give a length above 0 in metres");
    }
    require(settings.ao_falloff == Falloff::none || settings.ao_distance,
            "a falloff without a distance limit, to which it falls off; give the distance too");
    require(settings.bounce_rays >= 1, "0 rays a texel and bounce; give 1 or more");
    require(settings.bounces <= 64, std::to_string(settings.bounces) + " bounces; give 0 to 64");
    require(settings.bounces == 0 || settings.mode == Mode::irradiance,
            "bounces in a mode that has no light; choose mode irradiance or leave them out");
    require(settings.directional_rays >= 1, "0 directional rays a texel; give 1 or more");
    require(settings.directional == Switch::off || settings.mode == Mode::irradiance,
            "directional maps in a mode that has no light; choose mode irradiance or leave them out");
    require(settings.directional == Switch::off || !settings.seconds,
            "a time and directional maps, whose time it does not share out; give rays or a target error");
    require(settings.probe_rays >= 1, "0 rays a light probe; give 1 or more");
    if (settings.probe_grid) {
        std::uint64_t probes = 1;
        for (const std::uint32_t count : *settings.probe_grid) {
            require(count >= 1 && count <= 1024, std::to_string(count) + " light probes along an axis; give 1 to 1024");
            probes *= count;
        }
        require(probes <= 1U << 20U, std::to_string(probes) + " light probes; give 1048576 at most");
        require(settings.mode == Mode::irradiance,
                "light probes in a mode that has no light; choose mode irradiance or leave them out");
    }
    require(settings.triangle_test == TriangleTest::watertight || settings.accelerator != Accelerator::bvh,
            "the triangle test moller_trumbore does not go with the accelerator bvh; choose clusters or brute");
    require(settings.cluster_splits >= 1 && settings.cluster_splits <= 64,
            std::to_string(settings.cluster_splits) + " cluster splits; give 1 to 64");
    require(settings.threads >= 0, std::to_string(settings.threads) + " threads; give 1 or more, or 0 for all");
}

} // namespace vkbake
