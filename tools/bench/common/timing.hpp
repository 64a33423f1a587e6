// Seconds, taken so that two contenders are treated alike.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace vkbake::bench {

/// One thread's work: answers tile `i` of a set.
using Work = std::function<void(std::size_t)>;

struct PassSeconds {
    double wall = 0.0; ///< from when all threads are ready until the last of them has no tile left
    double cpu = 0.0;  ///< what the threads spent on it, the mean: what `wall` would be on a machine without other load
};

/// Each thread has a core of its own, if there are as many, and makes its Work before the start; threads take the tiles
/// in order, one at a time.
[[nodiscard]] PassSeconds timed_pass(int threads, std::size_t tiles, const std::function<Work()>& make_work);

[[nodiscard]] double median(std::vector<double> values);

/// All that the machine has.
[[nodiscard]] int all_threads();

} // namespace vkbake::bench
