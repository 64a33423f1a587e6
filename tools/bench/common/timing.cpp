#include "bench/common/timing.hpp"

#include <algorithm>
#include <atomic>
#include <barrier>
#include <chrono>
#include <ctime>
#include <numeric>
#include <thread>

#include <sched.h>

#include "base/float_state.hpp"

namespace vkbake::bench {
namespace {

double cpu_seconds() {
    std::timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// A pass of a few milliseconds is over before the scheduler has moved a thread to an idle core: two threads that it
// puts on the same core would be taken for a kernel that gains nothing from the second.
std::vector<cpu_set_t> own_cores(std::size_t threads) {
    cpu_set_t allowed;
    CPU_ZERO(&allowed);
    if (sched_getaffinity(0, sizeof(allowed), &allowed) != 0 ||
        static_cast<std::size_t>(CPU_COUNT(&allowed)) < threads) {
        return {};
    }
    std::vector<cpu_set_t> cores;
    for (std::size_t core = 0; core < CPU_SETSIZE && cores.size() < threads; ++core) {
        if (CPU_ISSET(core, &allowed)) {
            cpu_set_t& own = cores.emplace_back();
            CPU_ZERO(&own);
            CPU_SET(core, &own);
        }
    }
    return cores;
}

} // namespace

PassSeconds timed_pass(int threads, std::size_t tiles, const std::function<Work()>& make_work) {
    using Clock = std::chrono::steady_clock;
    const auto count = static_cast<std::size_t>(std::max(threads, 1));
    Clock::time_point start;
    const std::vector<cpu_set_t> cores = own_cores(count);
    std::vector<Clock::time_point> ends(count);
    std::vector<double> spent(count);
    std::barrier ready(static_cast<std::ptrdiff_t>(count), [&start]() noexcept { start = Clock::now(); });
    std::atomic<std::size_t> next{0};
    {
        std::vector<std::jthread> team;
        for (std::size_t thread = 0; thread < count; ++thread) {
            team.emplace_back([&, thread] {
                const DefaultFloatState state;
                if (!cores.empty()) {
                    (void)sched_setaffinity(0, sizeof(cores[thread]), &cores[thread]);
                }
                const Work work = make_work();
                ready.arrive_and_wait();
                const double before = cpu_seconds();
                for (std::size_t tile = next++; tile < tiles; tile = next++) {
                    work(tile);
                }
                ends[thread] = Clock::now();
                spent[thread] = cpu_seconds() - before;
            });
        }
    }
    return {std::chrono::duration<double>(*std::max_element(ends.begin(), ends.end()) - start).count(),
            std::accumulate(spent.begin(), spent.end(), 0.0) / static_cast<double>(count)};
}

double median(std::vector<double> values) {
    if (values.empty()) {
        return 0.0;
    }
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

int all_threads() { return static_cast<int>(std::max(1U, std::thread::hardware_concurrency())); }

} // namespace vkbake::bench
