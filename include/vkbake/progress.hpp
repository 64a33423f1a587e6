// How a long bake tells where it is, and how it is stopped.
#pragma once

#include <functional>
#include <string_view>

namespace vkbake {

struct ProgressReport {
    std::string_view stage;       ///< "atlas", "geometry image", "trace", "bounces", "finish", "write"
    double share = 0.0;           ///< of this stage, 0 … 1, never falling within a stage
    double rays_per_second = 0.0; ///< while tracing, otherwise 0
    double error = 0.0;           ///< relative, of the map being traced, as estimated so far; 0: not estimated
};

/// Called from the thread that called bake, at least once a stage and some ten times a second while tracing; or that
/// called a function which writes. Return false to stop: the function then throws Error{interrupted}. May be empty.
using Progress = std::function<bool(const ProgressReport&)>;

} // namespace vkbake
