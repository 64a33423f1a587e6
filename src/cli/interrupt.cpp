#include "interrupt.hpp"

#include <csignal>
#include <string_view>

#include <unistd.h>

#include "vkbake/error.hpp"

namespace vkbake::cli {
namespace {

// A signal handler can reach nothing but what has static storage.
volatile std::sig_atomic_t interrupt_flag = 0;
volatile std::sig_atomic_t terminal_flag = 0;

void say(std::string_view text) { // nothing else may be called there, and nobody is left to hear that it failed
    [[maybe_unused]] const ssize_t ignored = ::write(STDERR_FILENO, text.data(), text.size());
}

void end_at_once(int /*signal*/) {
    if (terminal_flag != 0) {
        say("\r\x1b[K"); // the progress line
    }
    say("vkbake: interrupted; nothing was written\n");
    ::_exit(static_cast<int>(ErrorKind::interrupted));
}

void set_flag(int signal) {
    interrupt_flag = 1;
    std::signal(signal, SIG_DFL);
}

/// Who started us with a signal ignored (a shell does so in the background) is obeyed.
void handle(void (*handler)(int)) {
    for (const int signal : {SIGINT, SIGTERM}) {
        struct sigaction before {};
        sigaction(signal, nullptr, &before);
        if (before.sa_handler != SIG_IGN) {
            std::signal(signal, handler);
        }
    }
}

} // namespace

void end_on_interrupt() {
    terminal_flag = ::isatty(STDERR_FILENO);
    handle(end_at_once);
}

void stop_on_interrupt() { handle(set_flag); }

bool interrupted() { return interrupt_flag != 0; }

Progress stopping() {
    stop_on_interrupt();
    return [](const ProgressReport& /*report*/) { return !interrupted(); };
}

} // namespace vkbake::cli
