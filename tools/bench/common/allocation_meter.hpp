// Counts what the program takes from the heap by `new`.
#pragma once

#include <cstdint>

namespace vkbake::bench {

struct Allocations {
    std::int64_t bytes = 0; ///< held now
    std::int64_t peak = 0;  ///< most that was held since reset_peak
    std::int64_t calls = 0; ///< since the program started
};

/// A program that uses this has its operators new and delete replaced by counting ones.
[[nodiscard]] Allocations allocations();
void reset_peak();

} // namespace vkbake::bench
