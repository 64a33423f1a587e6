// Building: seconds and bytes, Embree's and ours.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "vkbake/surface.hpp"

namespace vkbake::bench {

struct BuildFigures {
    std::string who;
    int threads = 1;
    std::vector<double> seconds; ///< one a repetition; interleaved with the others'
    std::int64_t bytes = 0;      ///< held after the build
    std::int64_t peak_bytes = 0; ///< most held during it
};

/// Ours, Embree robust and Embree fast (both quality HIGH), for each number of threads. Repeats until `budget` seconds
/// are spent a number of threads, at least three times. No EmbreeDevice may live meanwhile.
[[nodiscard]] std::vector<BuildFigures> compare_builds(const Surface& surface, const std::vector<int>& threads,
                                                       double budget);

} // namespace vkbake::bench
