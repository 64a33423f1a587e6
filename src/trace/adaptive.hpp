// Rays where they are needed, until a map is as good as was asked for or the time is up.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>

#include "trace/sampled_map.hpp"

namespace vkbake {

/// A texel in a hundred may err by more than so many times the target.
inline constexpr double worst_share = 0.01;
inline constexpr double worst_factor = 8.0;

struct AdaptiveGoal {
    std::optional<double> error; ///< MapEstimate::relative_rmse, or what `left` says
    std::optional<std::chrono::steady_clock::time_point> deadline;
    /// The map's error once it is filtered, as it is now. Asked a few times; absent where nothing filters it.
    std::function<double()> left = {};
};

/// How far the work is, how good the map is (0: not known yet). May throw to stop.
using AdaptiveReport = std::function<void(double share, double error)>;

struct AdaptiveResult {
    std::uint64_t uniform = 0; ///< samples a texel that would do as well if all texels had the same number
    double best_samples = 0.0; ///< over all texels: the least that the measured variances allow for this error
    double samples = 0.0;      ///< taken
    bool judged = false;       ///< `left` was asked after the last of them
};

/// Texels begin with 16 rays. Then, pass after pass, the tiles in which rays are worth most get up to four times what
/// they have (blocks of rays stay dense, and each pass decides by better estimates than the last), until the estimate
/// is what was asked for.
///
/// What decides is a tile's variance, smoothed with that of its neighbours along the tiles' curve and a little of the
/// map's: of sixteen texels and more, so a texel's own luck hardly decides whether it gets more rays, which would bias
/// it. Without a deadline a pure function of the samples, and of what `left` says.
///
/// Where the map is filtered it may have more noise than the error asked for: four times as much at first, and less
/// where `left` then says that the filter leaves too much.
AdaptiveResult sample_adaptively(SampledMap& map, const Samplers& samplers, const AdaptiveGoal& goal,
                                 const AdaptiveReport& report);

} // namespace vkbake
