#include "load/uri.hpp"

#include <array>
#include <cstdint>
#include <filesystem>

namespace vkbake::gltf {

namespace {

int hex_digit(char c) {
    if (c >= '0' && c <= '9') {
        return c - '0';
    }
    if (c >= 'a' && c <= 'f') {
        return c - 'a' + 10;
    }
    if (c >= 'A' && c <= 'F') {
        return c - 'A' + 10;
    }
    return -1;
}

std::optional<std::string> percent_decoded(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            result.push_back(text[i]);
            continue;
        }
        const int high = i + 2 < text.size() ? hex_digit(text[i + 1]) : -1;
        const int low = i + 2 < text.size() ? hex_digit(text[i + 2]) : -1;
        if (high < 0 || low < 0) {
            return std::nullopt;
        }
        result.push_back(static_cast<char>(high * 16 + low));
        i += 2;
    }
    return result;
}

constexpr std::array<std::int8_t, 256> make_base64_digits() {
    std::array<std::int8_t, 256> digits{};
    digits.fill(-1);
    constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < alphabet.size(); ++i) {
        digits.at(static_cast<unsigned char>(alphabet[i])) = static_cast<std::int8_t>(i);
    }
    return digits;
}

/// RFC 4648 §4; the padding may be left off, as some exporters do.
std::optional<std::vector<std::byte>> base64_decoded(std::string_view text) {
    static constexpr std::array<std::int8_t, 256> digits = make_base64_digits();
    const std::size_t padding = text.ends_with("==") ? 2 : (text.ends_with('=') ? 1 : 0);
    if (padding > 0 && text.size() % 4 != 0) {
        return std::nullopt;
    }
    text.remove_suffix(padding);
    if (text.size() % 4 == 1) {
        return std::nullopt;
    }
    std::vector<std::byte> bytes;
    bytes.reserve(text.size() / 4 * 3 + 3);
    std::uint32_t bits = 0;
    unsigned held = 0;
    for (const char c : text) {
        const std::int8_t digit = digits.at(static_cast<unsigned char>(c));
        if (digit < 0) {
            return std::nullopt;
        }
        bits = (bits << 6U) | static_cast<std::uint32_t>(digit);
        held += 6;
        if (held >= 8) {
            held -= 8;
            bytes.push_back(static_cast<std::byte>((bits >> held) & 0xFFU));
        }
    }
    return bytes;
}

} // namespace

bool is_data_uri(std::string_view uri) { return uri.starts_with("data:"); }

std::optional<DataUri> decode_data_uri(std::string_view uri) {
    const std::size_t comma = uri.find(',');
    if (!is_data_uri(uri) || comma == std::string_view::npos) {
        return std::nullopt;
    }
    std::string_view header = uri.substr(5, comma - 5);
    const std::string_view payload = uri.substr(comma + 1);
    const bool base64 = header.ends_with(";base64");
    if (base64) {
        header.remove_suffix(7);
    }
    if (header.find(";;") != std::string_view::npos || header.ends_with(';')) {
        return std::nullopt;
    }
    DataUri result;
    result.media_type = std::string(header.substr(0, header.find(';')));
    if (base64) {
        auto bytes = base64_decoded(payload);
        if (!bytes) {
            return std::nullopt;
        }
        result.bytes = *std::move(bytes);
        return result;
    }
    const auto text = percent_decoded(payload);
    if (!text) {
        return std::nullopt;
    }
    const auto* const first = reinterpret_cast<const std::byte*>(text->data());
    result.bytes.assign(first, first + text->size());
    return result;
}

std::optional<std::string> relative_path(std::string_view uri) {
    // A colon before the first slash would make what stands before it a scheme (RFC 3986 §4.2).
    const std::string_view first_segment = uri.substr(0, uri.find('/'));
    if (uri.empty() || uri.starts_with('/') || first_segment.find(':') != std::string_view::npos ||
        uri.find_first_of("?#\\") != std::string_view::npos) {
        return std::nullopt;
    }
    auto path = percent_decoded(uri);
    if (!path || path->starts_with('/') || path->find('\0') != std::string::npos) {
        return std::nullopt;
    }
    return path;
}

bool leaves_folder(const std::string& path) {
    const std::filesystem::path normal = std::filesystem::path(path).lexically_normal();
    return normal.is_absolute() || (!normal.empty() && *normal.begin() == "..");
}

} // namespace vkbake::gltf
