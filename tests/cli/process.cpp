#include "process.hpp"

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace vkbake::test {
namespace {

std::string contents(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

void redirect(int descriptor, const std::string& file) {
    const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(opened, descriptor);
    close(opened);
}

} // namespace

Outcome run_vkbake(const std::vector<std::string>& arguments, const RunOptions& options) {
    const std::string base =
        (std::filesystem::temp_directory_path() / ("vkbake-cli-" + std::to_string(getpid()))).string();
    const pid_t child = fork();
    if (child == 0) {
        redirect(STDOUT_FILENO, base + ".out");
        redirect(STDERR_FILENO, base + ".error");
        for (const auto& [name, value] : options.environment) {
            setenv(name.c_str(), value.c_str(), 1);
        }
        std::vector<std::string> words{VKBAKE_PROGRAM};
        words.insert(words.end(), arguments.begin(), arguments.end());
        std::vector<char*> pointers;
        for (std::string& word : words) {
            pointers.push_back(word.data());
        }
        pointers.push_back(nullptr);
        if (chdir(options.directory.c_str()) == 0) {
            execv(VKBAKE_PROGRAM, pointers.data());
        }
        _exit(127);
    }
    if (options.interrupt_after) {
        std::this_thread::sleep_for(*options.interrupt_after);
        kill(child, SIGINT);
    }
    int status = 0;
    waitpid(child, &status, 0);
    Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), contents(base + ".out"),
                    contents(base + ".error")};
    std::filesystem::remove(base + ".out");
    std::filesystem::remove(base + ".error");
    return outcome;
}

} // namespace vkbake::test
