// The progress of a long bake on standard error.
#pragma once

#include <chrono>
#include <string>

#include "vkbake/progress.hpp"

namespace vkbake::cli {

/// On a terminal one line that is rewritten ten times a second; otherwise a line every five seconds.
class ProgressLine {
public:
    explicit ProgressLine(bool quiet);
    ~ProgressLine(); ///< clears the line
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// Returns false once the user has asked to stop.
    bool update(const ProgressReport& report);

private:
    using Clock = std::chrono::steady_clock;

    [[nodiscard]] std::string line(const ProgressReport& report) const;

    bool m_quiet;
    bool m_terminal;
    bool m_shown = false;
    std::string m_stage;
    Clock::time_point m_trace_start{};
    double m_trace_start_share = 0.0;
    Clock::time_point m_last_shown{};
};

} // namespace vkbake::cli
