#include "make_scenes/png.hpp"

#include <string_view>

namespace vkbake::scenes {
namespace {

using Bytes = std::vector<std::uint8_t>;

void append_big_endian(Bytes& bytes, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) {
        bytes.push_back(static_cast<std::uint8_t>(value >> shift & 0xFFU));
    }
}

std::uint32_t crc32(const Bytes& bytes) {
    std::uint32_t crc = 0xFFFFFFFFU;
    for (const std::uint8_t byte : bytes) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
        }
    }
    return ~crc;
}

std::uint32_t adler32(const Bytes& bytes) {
    std::uint32_t a = 1;
    std::uint32_t b = 0;
    for (const std::uint8_t byte : bytes) {
        a = (a + byte) % 65521;
        b = (b + a) % 65521;
    }
    return b << 16 | a;
}

void append_chunk(Bytes& file, std::string_view type, const Bytes& data) {
    Bytes body(type.begin(), type.end());
    body.insert(body.end(), data.begin(), data.end());
    append_big_endian(file, static_cast<std::uint32_t>(data.size()));
    file.insert(file.end(), body.begin(), body.end());
    append_big_endian(file, crc32(body));
}

Bytes stored_zlib_stream(const Bytes& raw) {
    Bytes stream{0x78, 0x01};
    constexpr std::size_t longest = 65535;
    for (std::size_t start = 0; start < raw.size(); start += longest) {
        const std::size_t length = raw.size() - start < longest ? raw.size() - start : longest;
        stream.push_back(start + length == raw.size() ? 1 : 0);
        for (const std::size_t value : {length, ~length}) {
            stream.push_back(static_cast<std::uint8_t>(value & 0xFFU));
            stream.push_back(static_cast<std::uint8_t>(value >> 8 & 0xFFU));
        }
        const auto from = raw.begin() + static_cast<std::ptrdiff_t>(start);
        stream.insert(stream.end(), from, from + static_cast<std::ptrdiff_t>(length));
    }
    append_big_endian(stream, adler32(raw));
    return stream;
}

/// `kind`: bits a channel, and PNG's number of the colours' kind.
std::vector<std::byte> assemble(std::uint32_t side, const std::array<std::uint8_t, 2>& kind, const Bytes& palette,
                                bool first_is_clear, const Bytes& rows) {
    Bytes header;
    append_big_endian(header, side);
    append_big_endian(header, side);
    header.insert(header.end(), {kind[0], kind[1], 0, 0, 0}); // no filter choice, no interlace
    Bytes file{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    append_chunk(file, "IHDR", header);
    if (!palette.empty()) {
        append_chunk(file, "PLTE", palette);
    }
    if (first_is_clear) {
        append_chunk(file, "tRNS", {0});
    }
    append_chunk(file, "IDAT", stored_zlib_stream(rows));
    append_chunk(file, "IEND", {});
    std::vector<std::byte> result;
    result.reserve(file.size());
    for (const std::uint8_t byte : file) {
        result.push_back(static_cast<std::byte>(byte));
    }
    return result;
}

} // namespace

std::vector<std::byte> encode_png(const PaletteImage& image) {
    Bytes palette;
    for (const auto& colour : image.palette) {
        palette.insert(palette.end(), colour.begin(), colour.end());
    }
    Bytes rows;
    for (std::size_t y = 0; y < image.side; ++y) {
        rows.push_back(0);
        for (std::size_t x = 0; x < image.side; x += 2) {
            const std::size_t at = y * image.side + x;
            rows.push_back(static_cast<std::uint8_t>(image.texels[at] << 4 | image.texels[at + 1]));
        }
    }
    return assemble(image.side, {4, 3}, palette, image.first_is_clear, rows);
}

std::vector<std::byte> encode_png(const ColorImage& image) {
    Bytes rows;
    for (std::size_t y = 0; y < image.side; ++y) {
        rows.push_back(0);
        for (std::size_t x = 0; x < image.side; ++x) {
            const auto& texel = image.texels[y * image.side + x];
            rows.insert(rows.end(), texel.begin(), texel.end());
        }
    }
    return assemble(image.side, {8, 2}, {}, false, rows);
}

} // namespace vkbake::scenes
