#include "base/parallel.hpp"

#include "base/float_state.hpp"

#include <algorithm>

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

namespace vkbake {

std::size_t worker_count(int threads) {
    const int most = std::max(tbb::info::default_concurrency(), 1);
    return static_cast<std::size_t>(threads > 0 ? std::min(threads, most) : most);
}

void with_threads(int threads, const std::function<void()>& work) {
    tbb::task_arena arena(static_cast<int>(worker_count(threads)));
    arena.execute(work);
}

void parallel_ranges_by_worker(std::size_t count, std::size_t grain, int threads,
                               const std::function<void(std::size_t, std::size_t, std::size_t)>& body) {
    with_threads(threads, [&] {
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, count, std::max<std::size_t>(grain, 1)),
            [&](const tbb::blocked_range<std::size_t>& range) {
                const DefaultFloatState state;
                body(range.begin(), range.end(),
                     static_cast<std::size_t>(tbb::this_task_arena::current_thread_index()));
            },
            tbb::simple_partitioner());
    });
}

void parallel_ranges(std::size_t count, std::size_t grain, int threads,
                     const std::function<void(std::size_t, std::size_t)>& body) {
    parallel_ranges_by_worker(count, grain, threads,
                              [&](std::size_t begin, std::size_t end, std::size_t /*worker*/) { body(begin, end); });
}

void parallel_both(const std::function<void()>& first, const std::function<void()>& second) {
    const auto run = [](const std::function<void()>& work) {
        const DefaultFloatState state;
        work();
    };
    tbb::parallel_invoke([&] { run(first); }, [&] { run(second); });
}

} // namespace vkbake
