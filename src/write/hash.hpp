// The hash by which a reader knows that a file is the one that was written.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace vkbake {

/// XXH3 with 128 bits (xxHash 0.8), as 32 hexadecimal digits in its canonical, big-endian order: what `xxhsum -H2`
/// prints.
[[nodiscard]] std::string hash_of(std::span<const std::uint8_t> bytes);

} // namespace vkbake
