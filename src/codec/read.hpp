// Files → samples, by OpenImageIO; as Codec says.
#pragma once

#include "codec/codec.hpp"

namespace vkbake {

/// Value: float or std::uint8_t.
template<typename Value>
[[nodiscard]] Samples<Value> read_samples(const std::filesystem::path& file);

template<typename Value>
[[nodiscard]] Samples<Value> read_samples(std::span<const std::byte> bytes, const std::string& name,
                                          const SampleLimits& limits);

[[nodiscard]] std::pair<int, int> read_size(std::span<const std::byte> bytes, const std::string& name,
                                            const SampleLimits& limits);

} // namespace vkbake
