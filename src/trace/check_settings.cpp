#include "trace/check_settings.hpp"

#include <cmath>
#include <string>

#include "vkbake/error.hpp"

namespace vkbake {

void check_trace_settings(const Settings& settings) {
    const auto require = [](bool holds, const std::string& message) {
        if (!holds) {
            throw Error(ErrorKind::usage, "trace settings: " + message);
        }
    };
    require(settings.rays >= 1, "0 rays a texel; give 1 or more");
    if (settings.ao_distance) {
        require(settings.mode == Mode::ao,
                "a distance limit without mode ao; choose mode ao or leave the distance out");
        require(std::isfinite(*settings.ao_distance) && *settings.ao_distance > 0.0,
                "the distance limit is " + std::to_string(*settings.ao_distance) + "; give a length above 0 in metres");
    }
    require(settings.bounce_rays >= 1, "0 rays a texel and bounce; give 1 or more");
    require(settings.bounces <= 64, std::to_string(settings.bounces) + " bounces; give 0 to 64");
    require(settings.bounces == 0 || settings.mode == Mode::irradiance,
            "bounces in mode ao, which has no light; choose mode irradiance or leave them out");
    require(settings.triangle_test == TriangleTest::watertight || settings.accelerator != Accelerator::bvh,
            "the triangle test moller_trumbore does not go with the accelerator bvh; choose clusters or brute");
    require(settings.cluster_splits >= 1 && settings.cluster_splits <= 64,
            std::to_string(settings.cluster_splits) + " cluster splits; give 1 to 64");
    require(settings.threads >= 0, std::to_string(settings.threads) + " threads; give 1 or more, or 0 for all");
}

} // namespace vkbake
