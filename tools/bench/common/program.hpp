// What the mains of the benchmarks have in common.
#pragma once

#include <exception>
#include <string_view>

#include <fmt/core.h>

#include "vkbake/error.hpp"

namespace vkbake::bench {

/// Runs `work`, which returns the exit status; an exception becomes one line and the status that belongs to it.
template<typename Work>
[[nodiscard]] int run_program(std::string_view name, const Work& work) {
    try {
        return work();
    } catch (const Error& error) {
        fmt::print(stderr, "{}: {}\n", name, error.what());
        return static_cast<int>(error.kind());
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}: {}\n", name, error.what());
        return 1;
    }
}

} // namespace vkbake::bench
