#include "process.hpp"

#include <array>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace vkbake::test {
namespace {

void redirect_output(const std::string& file) {
    const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(opened, STDOUT_FILENO);
    close(opened);
}

void limit(int resource, std::uint64_t bytes) {
    if (bytes > 0) {
        const rlimit most{bytes, bytes};
        setrlimit(static_cast<__rlimit_resource_t>(resource), &most);
    }
}

/// In the child; never returns.
[[noreturn]] void become_vkbake(const std::vector<std::string>& arguments, const RunOptions& options) {
    for (const auto& [name, value] : options.environment) {
        setenv(name.c_str(), value.c_str(), 1);
    }
    limit(RLIMIT_AS, options.address_space);
    limit(RLIMIT_FSIZE, options.largest_file);
    signal(SIGXFSZ, SIG_IGN); // so that writing fails as on a full disk
    if (options.ignores_interrupts) {
        signal(SIGINT, SIG_IGN);
    }
    std::vector<std::string> words{VKBAKE_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& word : words) {
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    if (chdir(options.directory.c_str()) == 0) {
        execv(VKBAKE_PROGRAM, pointers.data());
    }
    _exit(127);
}

/// All that the child says on standard error, until it ends. When it is interrupted is told by what it says or does and
/// not by a time: how long it takes to get there is the machine's affair.
std::string listen(int pipe_end, pid_t child, std::function<bool(const std::string&)> interrupt_when) {
    std::string said;
    std::array<char, 4096> part{};
    while (true) {
        if (interrupt_when && interrupt_when(said)) {
            kill(child, SIGINT);
            interrupt_when = nullptr;
        }
        pollfd waiting{.fd = pipe_end, .events = POLLIN, .revents = 0};
        constexpr int milliseconds = 2;
        if (poll(&waiting, 1, interrupt_when ? milliseconds : -1) <= 0) {
            continue;
        }
        const ssize_t count = read(pipe_end, part.data(), part.size());
        if (count <= 0) {
            return said;
        }
        said.append(part.data(), static_cast<std::size_t>(count));
    }
}

} // namespace

std::function<bool(const std::string&)> says(std::string text) {
    return [text = std::move(text)](const std::string& said) { return said.find(text) != std::string::npos; };
}

std::string contents(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

Outcome run_vkbake(const std::vector<std::string>& arguments, const RunOptions& options) {
    const std::string output =
        (std::filesystem::temp_directory_path() / ("vkbake-cli-" + std::to_string(getpid()) + ".out")).string();
    std::array<int, 2> error_pipe{};
    if (pipe(error_pipe.data()) != 0) {
        return {};
    }
    const pid_t child = fork();
    if (child == 0) {
        redirect_output(output);
        dup2(error_pipe[1], STDERR_FILENO);
        close(error_pipe[0]);
        close(error_pipe[1]);
        become_vkbake(arguments, options);
    }
    close(error_pipe[1]);
    Outcome outcome;
    outcome.error = listen(error_pipe[0], child, options.interrupt_when);
    close(error_pipe[0]);
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    outcome.peak_memory = static_cast<std::uint64_t>(usage.ru_maxrss) << 10U;
    outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    outcome.out = contents(output);
    std::filesystem::remove(output);
    return outcome;
}

} // namespace vkbake::test
