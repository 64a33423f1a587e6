#include "imageio/encode_exr.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>
#include <thread>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfThreading.h>
#include <OpenEXR/ImfTiledOutputFile.h>

#include "vkbake/error.hpp"

namespace vkbake {
namespace {

constexpr unsigned tile_side = 64;
constexpr std::array<const char*, 4> channel_names{"R", "G", "B", "A"};

class MemoryStream final : public Imf::OStream {
public:
    explicit MemoryStream(std::vector<std::uint8_t>& bytes) : OStream("memory"), m_bytes(bytes) {}

    void write(const char* data, int count) override {
        const std::size_t end = m_place + static_cast<std::size_t>(count);
        m_bytes.resize(std::max(m_bytes.size(), end));
        std::memcpy(&m_bytes[m_place], data, static_cast<std::size_t>(count));
        m_place = end;
    }
    std::uint64_t tellp() override { return m_place; }
    void seekp(std::uint64_t place) override { m_place = static_cast<std::size_t>(place); }

private:
    std::vector<std::uint8_t>& m_bytes;
    std::size_t m_place = 0;
};

Imf::Header make_header(const Image& image, const Attributes& attributes) {
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    header.setTileDescription(Imf::TileDescription(tile_side, tile_side));
    for (const char* const name : channel_names) {
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    }
    if (!image.coverage.empty()) {
        header.channels().insert("coverage", Imf::Channel(Imf::FLOAT));
    }
    for (const auto& [name, value] : attributes) {
        header.insert(name, Imf::StringAttribute(value));
    }
    return header;
}

/// Where the channels are in memory. Slices are written to where files are read, so they are not const.
Imf::FrameBuffer frame_buffer_of(const Image& image) {
    const auto slice = [&](const float* first, std::size_t stride) {
        char* const base = reinterpret_cast<char*>(const_cast<float*>(first));
        return Imf::Slice(Imf::FLOAT, base, stride, stride * static_cast<std::size_t>(image.width));
    };
    Imf::FrameBuffer buffer;
    for (std::size_t channel = 0; channel < channel_names.size(); ++channel) {
        buffer.insert(channel_names.at(channel), slice(&image.texels.front().x + channel, sizeof(glm::vec4)));
    }
    if (!image.coverage.empty()) {
        buffer.insert("coverage", slice(image.coverage.data(), sizeof(float)));
    }
    return buffer;
}

void use_all_cores() {
    if (Imf::globalThreadCount() == 0) {
        Imf::setGlobalThreadCount(static_cast<int>(std::max(std::thread::hardware_concurrency(), 1U)));
    }
}

} // namespace

std::vector<std::uint8_t> encode_exr(const Image& image, const Attributes& attributes, const Poll& poll) {
    std::vector<std::uint8_t> bytes;
    try {
        use_all_cores();
        MemoryStream stream(bytes);
        Imf::TiledOutputFile file(stream, make_header(image, attributes), Imf::globalThreadCount());
        file.setFrameBuffer(frame_buffer_of(image));
        for (int row = 0; row < file.numYTiles(); ++row) {
            if (poll) {
                poll();
            }
            file.writeTiles(0, file.numXTiles() - 1, row, row);
        }
    } catch (const Iex::BaseExc& error) {
        throw Error(ErrorKind::output, std::string("encoding exr: ") + error.what() + "; choose another format");
    }
    return bytes;
}

} // namespace vkbake
