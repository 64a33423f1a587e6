// Work on many tiles, on all cores.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

namespace vkbake {

struct TileLoop {
    std::size_t count = 0;        ///< jobs, of a tile each
    std::uint64_t rays_a_job = 0; ///< about; ≥ 1
    int threads = 0;              ///< 0: all
    /// How many jobs are done; returns false to stop. Called from the calling thread some ten times a second, between
    /// bands of jobs; may be empty.
    std::function<bool(std::size_t done)> report;
};

/// Calls body(job, worker) for all jobs, worker < worker_count(threads), no two at a time with the same. The sizes of
/// bands and tasks change no result. Returns how many jobs were done: all, unless a report returned false.
std::size_t run(const TileLoop& loop, const std::function<void(std::size_t job, std::size_t worker)>& body);

} // namespace vkbake
