#include "codec/exr_header.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>

namespace vkbake {
namespace {

constexpr std::size_t longest_name = 255; // bytes, of attributes and types

/// One attribute's head: its name and type, each ended by a zero, and the size of its value; or the zero that ends a
/// header.
struct AttributeHead {
    std::size_t bytes = 0; ///< 1 where a header ends
    std::int32_t value_bytes = 0;
};

std::optional<AttributeHead> read_head(OIIO::Filesystem::IOProxy& file, std::uint64_t offset) {
    std::array<char, 2 * (longest_name + 1) + sizeof(std::int32_t)> buffer{};
    const std::size_t length = file.pread(buffer.data(), buffer.size(), static_cast<std::int64_t>(offset));
    const std::string_view text(buffer.data(), std::min(length, buffer.size()));
    const std::size_t name = text.find('\0');
    if (name == 0) {
        return AttributeHead{1, 0};
    }
    const std::size_t type = name == std::string_view::npos ? name : text.find('\0', name + 1);
    if (type == std::string_view::npos || text.size() < type + 1 + sizeof(std::int32_t)) {
        return std::nullopt;
    }
    AttributeHead head{type + 1 + sizeof(std::int32_t), 0};
    std::memcpy(&head.value_bytes, &buffer[type + 1], sizeof(head.value_bytes)); // little-endian, as we are
    return head;
}

} // namespace

bool holds_its_attributes(OIIO::Filesystem::IOProxy& file) {
    constexpr std::uint64_t first_attribute = 8; // after magic number and version
    constexpr std::uint32_t multi_part = 0x1000;
    std::uint32_t version = 0;
    if (file.pread(&version, sizeof(version), 4) != sizeof(version)) {
        return false;
    }
    bool empty = true; // the header so far; an empty one ends those of a file with several parts
    for (std::uint64_t offset = first_attribute;;) {
        const auto head = read_head(file, offset);
        if (!head) {
            return false;
        }
        offset += head->bytes;
        if (head->bytes == 1) {
            if (empty || (version & multi_part) == 0) {
                return true;
            }
            empty = true;
            continue;
        }
        empty = false;
        if (head->value_bytes < 0 || offset + static_cast<std::uint64_t>(head->value_bytes) > file.size()) {
            return false;
        }
        offset += static_cast<std::uint64_t>(head->value_bytes);
    }
}

} // namespace vkbake
