// Loops over all cores. The only user of oneTBB.
#pragma once

#include <cstddef>
#include <functional>

namespace vkbake {

/// Calls body(begin, end) for disjoint ranges that together are [0, count), each at most `grain` long, on up to
/// `threads` workers (0: all that the machine has; no more than that in any case). The order is not defined: what body
/// computes must not depend on it. Each worker rounds to nearest and keeps denormals, whatever the host has set, and
/// restores the host's state. An exception of body ends the loop and is rethrown here.
void parallel_ranges(std::size_t count, std::size_t grain, int threads,
                     const std::function<void(std::size_t begin, std::size_t end)>& body);

/// As above, and body is told which worker calls it, below worker_count(threads): no two calls at a time have the same,
/// so what belongs to a worker needs no lock.
void parallel_ranges_by_worker(std::size_t count, std::size_t grain, int threads,
                               const std::function<void(std::size_t begin, std::size_t end, std::size_t worker)>& body);

/// How many workers a loop has that is asked for `threads` (0: all). Never more than the machine has, for they would
/// only wait for each other.
[[nodiscard]] std::size_t worker_count(int threads);

/// Runs `work` with at most `threads` workers for the loops and tasks inside it (0: all).
void with_threads(int threads, const std::function<void()>& work);

/// Runs both, possibly at the same time; returns when both are done.
void parallel_both(const std::function<void()>& first, const std::function<void()>& second);

} // namespace vkbake
