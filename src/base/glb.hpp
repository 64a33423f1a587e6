// The GLB container as it is written (glTF 2.0 §4).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace vkbake::glb {

inline constexpr std::uint32_t magic = 0x46546C67; // "glTF"
inline constexpr std::uint32_t version = 2;
inline constexpr std::uint32_t json_type = 0x4E4F534A;   // "JSON"
inline constexpr std::uint32_t binary_type = 0x004E4942; // "BIN\0"
inline constexpr std::size_t header_size = 12;
inline constexpr std::size_t chunk_header_size = 8;
inline constexpr std::size_t largest_size = 0xFFFFFFFF; // lengths are 32 bits wide

/// Of the whole container, in bytes; a chunk for `binary` bytes only where there are any.
[[nodiscard]] constexpr std::size_t size_of(std::size_t json, std::size_t binary) {
    const auto chunk = [](std::size_t size) { return chunk_header_size + (size + 3) / 4 * 4; };
    return header_size + chunk(json) + (binary == 0 ? 0 : chunk(binary));
}

template<typename Byte>
void append_word(std::vector<Byte>& bytes, std::size_t word) {
    for (unsigned shift = 0; shift < 32; shift += 8) {
        bytes.push_back(static_cast<Byte>(static_cast<std::uint8_t>(word >> shift)));
    }
}

template<typename Byte>
void append_chunk(std::vector<Byte>& bytes, std::uint32_t type, std::span<const Byte> data, char padding) {
    const std::size_t padded = (data.size() + 3) / 4 * 4;
    append_word(bytes, padded);
    append_word(bytes, type);
    bytes.insert(bytes.end(), data.begin(), data.end());
    bytes.insert(bytes.end(), padded - data.size(), static_cast<Byte>(padding));
}

/// A container of both; the binary chunk is left out where `binary` is empty. Not larger than largest_size.
/// Byte: std::byte or std::uint8_t.
template<typename Byte>
[[nodiscard]] std::vector<Byte> make(std::string_view json, std::span<const Byte> binary) {
    const std::size_t size = size_of(json.size(), binary.size());
    std::vector<Byte> bytes;
    bytes.reserve(size);
    append_word(bytes, magic);
    append_word(bytes, version);
    append_word(bytes, size);
    append_chunk(bytes, json_type, std::span(reinterpret_cast<const Byte*>(json.data()), json.size()), ' ');
    if (!binary.empty()) {
        append_chunk(bytes, binary_type, binary, '\0');
    }
    return bytes;
}

} // namespace vkbake::glb
