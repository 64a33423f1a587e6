// How much memory there is to work with.
#pragma once

#include <cstdint>

namespace vkbake {

/// Bytes: the machine's, or what the process's control group (a container's limit, version 1 or 2) allows if that is
/// less.
[[nodiscard]] std::uint64_t machine_memory();

} // namespace vkbake
