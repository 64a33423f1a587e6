// Times the stages and tells the caller where they are.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "vkbake/error.hpp"
#include "vkbake/lightmap.hpp"
#include "vkbake/progress.hpp"

namespace vkbake {

/// The progress callback must outlive it. A stage that runs once a page adds up its pages' seconds.
class StageClock {
public:
    explicit StageClock(const Progress& progress) : m_progress(progress) {}

    /// From here on a stage's share counts the pages before this one as done.
    void begin_page(std::size_t page, std::size_t pages) {
        m_page = static_cast<double>(page);
        m_pages = static_cast<double>(pages);
    }

    template<typename Work>
    auto run(std::string_view stage, Work&& work) {
        report(stage, 0.0, 0.0);
        const auto start = Clock::now();
        auto result = work();
        add(stage, std::chrono::duration<double>(Clock::now() - start).count());
        return result;
    }

    /// For the tracer, of the page that was begun last. This clock must outlive it, and so must the name.
    [[nodiscard]] std::function<bool(double, std::uint64_t)> trace_progress(std::string_view stage = "trace") {
        return [this, stage, start = Clock::now()](double share, std::uint64_t rays) {
            const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
            return tell(stage, share, seconds > 0.0 ? static_cast<double>(rays) / seconds : 0.0);
        };
    }

    [[nodiscard]] const std::vector<StageSeconds>& seconds() const { return m_seconds; }

private:
    using Clock = std::chrono::steady_clock;

    bool tell(std::string_view stage, double share, double rays_per_second) {
        return !m_progress || m_progress({stage, (m_page + share) / m_pages, rays_per_second});
    }
    void report(std::string_view stage, double share, double rays_per_second) {
        if (!tell(stage, share, rays_per_second)) {
            throw Error(ErrorKind::interrupted, "interrupted");
        }
    }
    void add(std::string_view stage, double seconds) {
        for (StageSeconds& entry : m_seconds) {
            if (entry.stage == stage) {
                entry.seconds += seconds;
                return;
            }
        }
        m_seconds.push_back({std::string(stage), seconds});
    }

    const Progress& m_progress;
    double m_page = 0.0;
    double m_pages = 1.0;
    std::vector<StageSeconds> m_seconds;
};

} // namespace vkbake
