// What the bench is asked for.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "bench/common/measure.hpp"
#include "vkbake/settings.hpp"

namespace vkbake::bench {

struct Options {
    std::filesystem::path scene;
    bool ground = false;
    Settings settings{.size = 512};
    std::size_t max_rays = 1'500'000;
    std::vector<int> threads{1, 0}; ///< 0: all
    int repeats = 5;
    PassClock clock = PassClock::wall;
    double build_budget = 3.0; ///< seconds of building for each number of threads
    std::size_t verify = 20'000;
    std::size_t verify_brute = 100;
    std::filesystem::path json; ///< empty: none is written
};

/// Nothing if all is said already (--help). Throws Error{usage}.
[[nodiscard]] std::optional<Options> parse_options(int argument_count, char** arguments);

} // namespace vkbake::bench
