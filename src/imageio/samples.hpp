// What OpenImageIO reads from a file or from memory, before it is brought into the project's own image type.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace vkbake {

/// All channels of an image's first part, interleaved, row 0 at the top. Alpha is as the file stores it.
template<typename Value>
struct Samples {
    int width = 0;
    int height = 0;
    std::vector<std::string> channels; ///< names, at least one
    bool integer = false;              ///< the file stores integers; float values are then integer ÷ largest integer
    bool eight_bit = false;            ///< … of 8 bits
    std::vector<Value> values;         ///< width · height · channels.size()
};

/// Guards against files that are small and decode to something huge.
struct SampleLimits {
    int side = 32768;                  ///< texels
    std::uint64_t bytes = 8ULL << 30U; ///< of the decoded values
};

/// PNG, JPEG, EXR or HDR, told from the first bytes. Value: float or std::uint8_t (where the file has more bits they
/// are rounded to 8). Throws Error{bad_input}.
template<typename Value>
[[nodiscard]] Samples<Value> read_samples(const std::filesystem::path& file);

/// The same from memory; `name` is for messages. Throws Error{bad_input}.
template<typename Value>
[[nodiscard]] Samples<Value> read_samples(std::span<const std::byte> bytes, const std::string& name,
                                          const SampleLimits& limits);

/// Width and height alone, from the header. Throws Error{bad_input} as read_samples<std::uint8_t>.
[[nodiscard]] std::pair<int, int> read_size(std::span<const std::byte> bytes, const std::string& name,
                                            const SampleLimits& limits);

} // namespace vkbake
