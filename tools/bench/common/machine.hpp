// On what and of what a figure was measured.
#pragma once

#include "base/json.hpp"

namespace vkbake::bench {

/// Processor, threads, one-minute load average at the start, commit of the folder the program runs in, compiler.
[[nodiscard]] Json describe_machine();

} // namespace vkbake::bench
