#include "progress_line.hpp"

#include "interrupt.hpp"
#include "text.hpp"

#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

namespace vkbake::cli {

ProgressLine::ProgressLine(bool quiet)
    : m_quiet(quiet), m_terminal(isatty(fileno(stderr)) != 0), m_last_shown(Clock::now()) {}

ProgressLine::~ProgressLine() {
    if (m_shown && m_terminal) {
        std::fputs("\r\x1b[K", stderr);
    }
}

std::string ProgressLine::line(const ProgressReport& report) const {
    std::string text = fmt::format("{:<14} {:5.1f} %", report.stage, 100.0 * report.share);
    if (report.rays_per_second > 0.0) {
        text += fmt::format("  {} rays/s", count_text(report.rays_per_second));
        if (report.error > 0.0) {
            text += fmt::format("  error {:.2g} %", 100.0 * report.error);
        }
        const double seconds = std::chrono::duration<double>(Clock::now() - m_trace_start).count();
        const double gained = report.share - m_trace_start_share;
        // A time left that is foretold from the first moments is worse than none.
        if (gained > 0.01 && seconds > 0.5) {
            text += fmt::format("  {} left", duration_text(seconds * (1.0 - report.share) / gained));
        }
    }
    return text;
}

bool ProgressLine::update(const ProgressReport& report) {
    const auto now = Clock::now();
    if (m_stage != report.stage) {
        m_stage = report.stage;
        m_trace_start = now;
        m_trace_start_share = report.share;
    }
    const auto interval = m_terminal ? std::chrono::milliseconds(100) : std::chrono::milliseconds(5000);
    if (!m_quiet && now - m_last_shown >= interval) {
        m_last_shown = now;
        m_shown = true;
        fmt::print(stderr, "{}{}{}", m_terminal ? "\r\x1b[K" : "", line(report), m_terminal ? "" : "\n");
        std::fflush(stderr);
    }
    return !interrupted();
}

} // namespace vkbake::cli
