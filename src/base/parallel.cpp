#include "base/parallel.hpp"

#include "base/float_state.hpp"

#include <algorithm>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

namespace vkbake {

void with_threads(int threads, const std::function<void()>& work) {
    tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
    arena.execute(work);
}

void parallel_ranges(std::size_t count, std::size_t grain, int threads,
                     const std::function<void(std::size_t, std::size_t)>& body) {
    with_threads(threads, [&] {
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, count, std::max<std::size_t>(grain, 1)),
            [&](const tbb::blocked_range<std::size_t>& range) {
                const DefaultFloatState state;
                body(range.begin(), range.end());
            },
            tbb::simple_partitioner());
    });
}

void parallel_both(const std::function<void()>& first, const std::function<void()>& second) {
    const auto run = [](const std::function<void()>& work) {
        const DefaultFloatState state;
        work();
    };
    tbb::parallel_invoke([&] { run(first); }, [&] { run(second); });
}

} // namespace vkbake
