// Runs the program and catches what it says.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace vkbake::test {

struct Outcome {
    int status = -1; ///< exit status; 128 + signal where one ended it
    std::string out;
    std::string error;
    std::uint64_t peak_memory = 0; ///< bytes that were resident at the most
};

struct RunOptions {
    std::string directory = ".";
    std::vector<std::pair<std::string, std::string>> environment; ///< added to this process's
    /// Send SIGINT once it is true of what standard error holds so far; asked every few milliseconds. Empty: never.
    std::function<bool(const std::string& said)> interrupt_when;
    bool ignores_interrupts = false; ///< as what a shell starts in the background
    std::uint64_t largest_file = 0;  ///< bytes that it may write to one file, as on a full disk; 0: any
    std::uint64_t address_space = 0; ///< bytes that it may map; 0: any
};

/// For RunOptions::interrupt_when.
[[nodiscard]] std::function<bool(const std::string&)> says(std::string text);

/// The bytes of a file; none if it cannot be read.
[[nodiscard]] std::string contents(const std::filesystem::path& file);

[[nodiscard]] Outcome run_vkbake(const std::vector<std::string>& arguments, const RunOptions& options = {});

} // namespace vkbake::test
