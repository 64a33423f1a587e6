// Runs the program and catches what it says.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vkbake::test {

struct Outcome {
    int status = -1; ///< exit status; 128 + signal where one ended it
    std::string out;
    std::string error;
};

struct RunOptions {
    std::string directory = ".";
    std::vector<std::pair<std::string, std::string>> environment; ///< added to this process's
    std::optional<std::chrono::milliseconds> interrupt_after;     ///< send SIGINT then
};

[[nodiscard]] Outcome run_vkbake(const std::vector<std::string>& arguments, const RunOptions& options = {});

} // namespace vkbake::test
