#include "codec/exr_header.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

namespace vkbake {
namespace {

constexpr std::size_t longest_name = 255; // bytes, of attributes and types

/// One attribute's head: its name and type, each ended by a zero, and the size of its value; or the zero that ends a
/// header.
struct AttributeHead {
    std::size_t bytes = 0; ///< 1 where a header ends
    std::string type;
    std::int32_t value_bytes = 0;
};

std::optional<AttributeHead> read_head(OIIO::Filesystem::IOProxy& file, std::uint64_t offset) {
    std::array<char, 2 * (longest_name + 1) + sizeof(std::int32_t)> buffer{};
    const std::size_t length = file.pread(buffer.data(), buffer.size(), static_cast<std::int64_t>(offset));
    const std::string_view text(buffer.data(), std::min(length, buffer.size()));
    const std::size_t name = text.find('\0');
    if (name == 0) {
        return AttributeHead{1, {}, 0};
    }
    const std::size_t type = name == std::string_view::npos ? name : text.find('\0', name + 1);
    if (type == std::string_view::npos || text.size() < type + 1 + sizeof(std::int32_t)) {
        return std::nullopt;
    }
    AttributeHead head{type + 1 + sizeof(std::int32_t), std::string(text.substr(name + 1, type - name - 1)), 0};
    std::memcpy(&head.value_bytes, &buffer[type + 1], sizeof(head.value_bytes)); // little-endian, as we are
    return head;
}

/// Of types whose values have one size.
std::optional<std::int32_t> size_of_type(std::string_view type) {
    struct Type {
        std::string_view name;
        std::int32_t bytes;
    };
    static constexpr std::array<Type, 24> types{{{"box2f", 16},
                                                 {"box2i", 16},
                                                 {"chromaticities", 32},
                                                 {"compression", 1},
                                                 {"deepImageState", 1},
                                                 {"double", 8},
                                                 {"envmap", 1},
                                                 {"float", 4},
                                                 {"int", 4},
                                                 {"keycode", 28},
                                                 {"lineOrder", 1},
                                                 {"m33d", 72},
                                                 {"m33f", 36},
                                                 {"m44d", 128},
                                                 {"m44f", 64},
                                                 {"rational", 8},
                                                 {"tiledesc", 9},
                                                 {"timecode", 8},
                                                 {"v2d", 16},
                                                 {"v2f", 8},
                                                 {"v2i", 8},
                                                 {"v3d", 24},
                                                 {"v3f", 12},
                                                 {"v3i", 12}}};
    const auto* const found =
        std::find_if(types.begin(), types.end(), [&](const Type& known) { return known.name == type; });
    return found == types.end() ? std::nullopt : std::optional(found->bytes);
}

/// Names, each ended by a zero and followed by 16 bytes, and a zero at the very end.
bool is_channel_list(std::string_view value) {
    constexpr std::size_t channel_bytes = 16;
    while (!value.empty() && value[0] != '\0') {
        const std::size_t name = value.find('\0');
        if (name == std::string_view::npos || value.size() - name - 1 < channel_bytes) {
            return false;
        }
        value.remove_prefix(name + 1 + channel_bytes);
    }
    return value.size() == 1;
}

template<typename Number>
Number number_at(std::string_view value, std::size_t offset) {
    Number number = 0;
    std::memcpy(&number, value.data() + offset, sizeof(number));
    return number;
}

/// Strings, each behind its length.
bool is_string_vector(std::string_view value) {
    while (value.size() >= sizeof(std::int32_t)) {
        const auto length = number_at<std::int32_t>(value, 0);
        value.remove_prefix(sizeof(length));
        if (length < 0 || static_cast<std::size_t>(length) > value.size()) {
            return false;
        }
        value.remove_prefix(static_cast<std::size_t>(length));
    }
    return value.empty();
}

/// Width, height, and four bytes a pixel.
bool is_preview(std::string_view value) {
    if (value.size() < 2 * sizeof(std::uint32_t)) {
        return false;
    }
    const std::uint64_t pixels =
        std::uint64_t{number_at<std::uint32_t>(value, 0)} * number_at<std::uint32_t>(value, sizeof(std::uint32_t));
    const std::size_t rest = value.size() - 2 * sizeof(std::uint32_t);
    return pixels <= rest && 4 * pixels == rest;
}

/// OpenEXR reads a value of a type that it knows by what the value itself says, and goes on behind that: so the value
/// must be as long as its head says.
bool is_consistent(OIIO::Filesystem::IOProxy& file, const AttributeHead& head, std::uint64_t offset) {
    if (const auto bytes = size_of_type(head.type)) {
        return head.value_bytes == *bytes;
    }
    if (head.type != "chlist" && head.type != "stringvector" && head.type != "preview") {
        return true;
    }
    std::string value(static_cast<std::size_t>(head.value_bytes), '\0');
    if (file.pread(value.data(), value.size(), static_cast<std::int64_t>(offset)) != value.size()) {
        return false;
    }
    return head.type == "chlist"         ? is_channel_list(value)
           : head.type == "stringvector" ? is_string_vector(value)
                                         : is_preview(value);
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
        if (head->value_bytes < 0 || offset + static_cast<std::uint64_t>(head->value_bytes) > file.size() ||
            !is_consistent(file, *head, offset)) {
            return false;
        }
        offset += static_cast<std::uint64_t>(head->value_bytes);
    }
}

} // namespace vkbake
