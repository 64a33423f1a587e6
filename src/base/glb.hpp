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

[[nodiscard]] constexpr std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

template<typename Byte>
[[nodiscard]] std::size_t padded_size(std::span<const std::span<const Byte>> parts) {
    std::size_t size = 0;
    for (const std::span<const Byte>& part : parts) {
        size += padded(part.size());
    }
    return size;
}

/// Of the whole container, in bytes, as `make` makes it.
template<typename Byte>
[[nodiscard]] std::size_t size_of(std::string_view json, std::span<const std::span<const Byte>> binary) {
    const std::size_t binary_size = padded_size(binary);
    return header_size + chunk_header_size + padded(json.size()) +
           (binary_size == 0 ? 0 : chunk_header_size + binary_size);
}

template<typename Byte>
void append_word(std::vector<Byte>& bytes, std::size_t word) {
    for (unsigned shift = 0; shift < 32; shift += 8) {
        bytes.push_back(static_cast<Byte>(static_cast<std::uint8_t>(word >> shift)));
    }
}

template<typename Byte>
void append_padded(std::vector<Byte>& bytes, std::span<const Byte> data, char padding) {
    bytes.insert(bytes.end(), data.begin(), data.end());
    bytes.insert(bytes.end(), padded(data.size()) - data.size(), static_cast<Byte>(padding));
}

/// A container of both: the parts of the binary chunk, each at a multiple of 4 bytes; no such chunk where they are
/// empty. Not larger than largest_size. Byte: std::byte or std::uint8_t.
template<typename Byte>
[[nodiscard]] std::vector<Byte> make(std::string_view json, std::span<const std::span<const Byte>> binary) {
    const std::size_t size = size_of(json, binary);
    std::vector<Byte> bytes;
    bytes.reserve(size);
    append_word(bytes, magic);
    append_word(bytes, version);
    append_word(bytes, size);
    append_word(bytes, padded(json.size()));
    append_word(bytes, json_type);
    append_padded(bytes, std::span(reinterpret_cast<const Byte*>(json.data()), json.size()), ' ');
    if (const std::size_t binary_size = padded_size(binary); binary_size > 0) {
        append_word(bytes, binary_size);
        append_word(bytes, binary_type);
        for (const std::span<const Byte>& part : binary) {
            append_padded(bytes, part, '\0');
        }
    }
    return bytes;
}

} // namespace vkbake::glb
