#include "trace/tile_loop.hpp"

#include <algorithm>
#include <chrono>

#include "base/parallel.hpp"

namespace vkbake {

std::size_t run(const TileLoop& loop, const std::function<void(std::size_t job, std::size_t worker)>& body) {
    // Below this, handing work to a thread costs more than a per cent of it.
    constexpr std::uint64_t worthwhile_rays = 4096;
    constexpr std::uint64_t first_band_rays = 1U << 18U;
    const auto grain = static_cast<std::size_t>((worthwhile_rays + loop.rays_a_job - 1) / loop.rays_a_job);
    if (loop.count == 0 && loop.report) {
        (void)loop.report(0); // nothing is left to stop
    }
    std::size_t band = static_cast<std::size_t>(first_band_rays / loop.rays_a_job) + 2;
    std::size_t done = 0;
    while (done < loop.count) {
        const auto start = std::chrono::steady_clock::now();
        const std::size_t first = done;
        const std::size_t count = std::min(band, loop.count - first);
        parallel_ranges_by_worker(count, grain, loop.threads,
                                  [&](std::size_t begin, std::size_t end, std::size_t worker) {
                                      for (std::size_t job = begin; job < end; ++job) {
                                          body(first + job, worker);
                                      }
                                  });
        done += count;
        if (loop.report && !loop.report(done)) {
            break;
        }
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        band = seconds < 0.06 ? band * 2 : (seconds > 0.15 ? std::max<std::size_t>(band / 2, 1) : band);
    }
    return done;
}

} // namespace vkbake
