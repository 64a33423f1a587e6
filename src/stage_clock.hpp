// Times the stages and tells the caller where they are.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "vkbake/error.hpp"
#include "vkbake/lightmap.hpp"
#include "vkbake/progress.hpp"

namespace vkbake {

/// The progress callback must outlive it. A stage that runs once a page adds up its pages' seconds.
class StageClock {
public:
    using Clock = std::chrono::steady_clock;

    /// `seconds`: how long all may take, from now on.
    explicit StageClock(const Progress& progress, std::optional<double> seconds = {}) : m_progress(progress) {
        if (seconds) {
            m_end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(*seconds));
        }
    }

    /// From here on a stage's share counts the pages before this one as done.
    void begin_page(std::size_t page, std::size_t pages) {
        m_page = static_cast<double>(page);
        m_pages = static_cast<double>(pages);
    }

    /// When the rays of the page that was begun last are to end: what is left is shared by the pages that are left, and
    /// what follows on the device is kept free: `passes` times what the stage took that ran last, the geometry image.
    /// Absent without a limit.
    [[nodiscard]] std::optional<Clock::time_point> trace_deadline(double passes) const {
        if (!m_end) {
            return {};
        }
        const auto left = (*m_end - Clock::now()) / (m_pages - m_page);
        return Clock::now() + std::chrono::duration_cast<Clock::duration>(left) -
               std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(passes * m_last_seconds));
    }

    /// A stage's seconds are not those of one that runs within it.
    template<typename Work>
    auto run(std::string_view stage, Work&& work) {
        begin(stage);
        add(stage, 0.0);
        const double before = std::exchange(m_within, 0.0);
        const auto start = Clock::now();
        auto result = work();
        const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
        m_last_seconds = seconds - m_within;
        add(stage, m_last_seconds);
        m_within = before + seconds;
        return result;
    }

    /// For the tracer, of the page that was begun last. This clock must outlive it, and so must the name.
    [[nodiscard]] std::function<bool(double, std::uint64_t, double)> trace_progress(std::string_view stage = "trace") {
        return [this, stage, start = Clock::now()](double share, std::uint64_t rays, double error) {
            const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
            return tell({stage, share, seconds > 0.0 ? static_cast<double>(rays) / seconds : 0.0, error});
        };
    }

    [[nodiscard]] const std::vector<StageSeconds>& seconds() const { return m_seconds; }

private:
    bool tell(ProgressReport report) {
        report.share = (m_page + report.share) / m_pages;
        return !m_progress || m_progress(report);
    }
    void begin(std::string_view stage) {
        if (!tell({.stage = stage})) {
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
    std::optional<Clock::time_point> m_end;
    double m_last_seconds = 0.0;
    double m_within = 0.0; ///< of the stage that runs: seconds of those within it
    double m_page = 0.0;
    double m_pages = 1.0;
    std::vector<StageSeconds> m_seconds;
};

} // namespace vkbake
