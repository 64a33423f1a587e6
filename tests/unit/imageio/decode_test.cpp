#include <array>
#include <cstring>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "imageio/decode.hpp"
#include "imageio/encode.hpp"
#include "test_images.hpp"
#include "vkbake/vkbake.hpp"

namespace vkbake {
namespace {

using test::message_of;

EncodedImage encoded(std::span<const std::uint8_t> bytes) {
    EncodedImage image{"brick", "", {}};
    for (const std::uint8_t byte : bytes) {
        image.bytes.push_back(static_cast<std::byte>(byte));
    }
    return image;
}

TEST(Decode, PngToBytesAndToLinearFloats) {
    const Image picture{2, 2, {{0, 1, 0.5F, 1}, {1, 0, 0, 0}, {0.2F, 0.4F, 0.6F, 0.8F}, {0, 0, 0, 1}}, {}};
    const EncodedImage image = encoded(encode_image(picture, ImageFormat::png8).bytes);
    const Rgba8Image raw = decode_rgba8(image);
    EXPECT_EQ(raw.width, 2);
    EXPECT_EQ(raw.height, 2);
    const std::vector<std::uint8_t> expected{0, 255, 128, 255, 255, 0, 0, 0, 51, 102, 153, 204, 0, 0, 0, 255};
    EXPECT_EQ(raw.texels, expected);
    const Image linear = decode_image(image);
    EXPECT_NEAR(linear.texels[0].z, 0.2158605F, 1e-6F); // 128/255 by IEC 61966-2-1
    EXPECT_NEAR(linear.texels[2].w, 0.8F, 1e-6F);       // alpha is not encoded
    EXPECT_EQ(linear.texels[1], glm::vec4(1, 0, 0, 0));
}

TEST(Decode, GreyAndOpaqueImages) {
    const std::array<std::uint8_t, 2> grey{7, 200};
    const Rgba8Image raw = decode_rgba8(encoded(encode_grey_png(2, 1, grey)));
    EXPECT_EQ(raw.texels, (std::vector<std::uint8_t>{7, 7, 7, 255, 200, 200, 200, 255}));
    const std::array<std::uint8_t, 3> color{1, 2, 3};
    EXPECT_EQ(decode_rgba8(encoded(encode_srgb_png(1, 1, color))).texels, (std::vector<std::uint8_t>{1, 2, 3, 255}));
}

// The smallest baseline JPEG of one grey texel, written out from ITU-T T.81: tables of one code each, all coefficients
// 0, which is mid grey.
TEST(Decode, Jpeg) {
    std::vector<std::uint8_t> bytes{0xFF, 0xD8, 0xFF, 0xDB, 0x00, 0x43, 0x00};
    bytes.insert(bytes.end(), 64, 1);
    const std::vector<std::uint8_t> rest{
        0xFF, 0xC0, 0x00, 0x0B, 0x08, 0x00, 0x01, 0x00, 0x01, 0x01, 0x01, 0x11, 0x00, // frame
        0xFF, 0xC4, 0x00, 0x14, 0x00, 1,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,    0,   0, 0, 0,
        0,    0x00, 0xFF, 0xC4, 0x00, 0x14, 0x10, 1,    0,    0,    0,    0,    0,    0,    0,    0,    0,   0, 0, 0,
        0,    0,    0,    0x00, 0xFF, 0xDA, 0x00, 0x08, 0x01, 0x01, 0x00, 0x00, 0x3F, 0x00, 0x3F, 0xFF, 0xD9};
    bytes.insert(bytes.end(), rest.begin(), rest.end());
    EXPECT_EQ(decode_rgba8(encoded(bytes)).texels, (std::vector<std::uint8_t>{128, 128, 128, 255}));
}

TEST(Decode, DamagedImagesAreErrorsThatNameThem) {
    const Image picture = test::filled(64, 64, glm::vec4(0.3F));
    const std::vector<std::uint8_t> good = encode_image(picture, ImageFormat::png8).bytes;
    std::vector<std::vector<std::uint8_t>> damaged{{}, {1, 2, 3}, {good.begin(), good.begin() + 8}};
    damaged.emplace_back(good.begin(), good.begin() + 40); // a header, no data
    damaged.push_back(good);
    damaged.back()[good.size() / 2] ^= 0xFFU; // a checksum that does not fit
    for (const auto& bytes : damaged) {
        const std::string message = message_of(ErrorKind::bad_input, [&] { (void)decode_rgba8(encoded(bytes)); });
        EXPECT_NE(message.find("brick"), std::string::npos) << message;
        message_of(ErrorKind::bad_input, [&] { (void)decode_image(encoded(bytes)); });
    }
}

std::uint32_t crc32(std::span<const std::uint8_t> bytes) {
    std::uint32_t crc = 0xFFFFFFFFU;
    for (const std::uint8_t byte : bytes) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc >> 1U) ^ ((crc & 1U) != 0U ? 0xEDB88320U : 0U);
        }
    }
    return ~crc;
}

/// A PNG whose header is made to claim another size, checksum right.
std::vector<std::uint8_t> with_claimed_size(std::vector<std::uint8_t> png, std::uint32_t width, std::uint32_t height) {
    const auto put = [&](std::size_t place, std::uint32_t value) {
        for (std::size_t i = 0; i < 4; ++i) {
            png[place + i] = static_cast<std::uint8_t>(value >> (24U - 8U * i));
        }
    };
    put(16, width);
    put(20, height);
    put(29, crc32(std::span(png).subspan(12, 17)));
    return png;
}

TEST(Decode, BombsAreRefusedBeforeTheyAreDecoded) {
    const auto png = encode_image(test::filled(4, 4, glm::vec4(0.5F)), ImageFormat::png8).bytes;
    EXPECT_EQ(decode_rgba8(encoded(with_claimed_size(png, 4, 4))).width, 4); // the helper makes valid files
    const std::string message =
        message_of(ErrorKind::bad_input, [&] { (void)decode_rgba8(encoded(with_claimed_size(png, 16385, 1))); });
    EXPECT_NE(message.find("16385"), std::string::npos) << message;
    message_of(ErrorKind::bad_input, [&] { (void)decode_rgba8(encoded(with_claimed_size(png, 1, 1000000))); });
    message_of(ErrorKind::bad_input, [&] { (void)decode_rgba8(encoded(with_claimed_size(png, 65535, 65535))); });
    // 16384² texels of four floats are 4 GiB.
    const std::string large =
        message_of(ErrorKind::bad_input, [&] { (void)decode_image(encoded(with_claimed_size(png, 16384, 16384))); });
    EXPECT_NE(large.find("limit"), std::string::npos) << large;
}

/// OpenEXR would get two gigabytes for it before it finds that the file ends.
TEST(Decode, AnExrWhoseHeaderAnnouncesMoreThanTheFileHoldsIsRefused) {
    const std::string place("compression\0compression\0", 24);
    for (const std::uint32_t size : {0x7FFFFFFFU, 0x80000000U, 5000U}) {
        std::vector<std::uint8_t> exr = encode_image(test::filled(4, 4, glm::vec4(0.5F)), ImageFormat::exr).bytes;
        EXPECT_NO_THROW((void)decode_image(encoded(exr)));
        const auto found = std::search(exr.begin(), exr.end(), place.begin(), place.end());
        ASSERT_NE(found, exr.end());
        std::memcpy(&*found + place.size(), &size, sizeof(size));
        const std::string message = message_of(ErrorKind::bad_input, [&] { (void)decode_image(encoded(exr)); });
        EXPECT_NE(message.find("its header announces"), std::string::npos) << message;
    }
}

/// A list of channels that is longer than it says, behind which OpenEXR would read on at another place than we do: the
/// same two gigabytes.
TEST(Decode, AnExrWhoseAttributesAreNotAsLongAsTheySayIsRefused) {
    const std::vector<std::uint8_t> whole = encode_image(test::filled(4, 4, glm::vec4(0.5F)), ImageFormat::exr).bytes;
    struct Case {
        std::string attribute; ///< name and type, each with its zero
        std::uint32_t shorter;
    };
    for (const Case& tried :
         {Case{std::string("channels\0chlist\0", 16), 1}, Case{std::string("channels\0chlist\0", 16), 18},
          Case{std::string("dataWindow\0box2i\0", 17), 4}, Case{std::string("lineOrder\0lineOrder\0", 20), 1}}) {
        std::vector<std::uint8_t> exr = whole;
        const auto found = std::search(exr.begin(), exr.end(), tried.attribute.begin(), tried.attribute.end());
        ASSERT_NE(found, exr.end()) << tried.attribute;
        *(found + static_cast<std::ptrdiff_t>(tried.attribute.size())) -= static_cast<std::uint8_t>(tried.shorter);
        const std::string message = message_of(ErrorKind::bad_input, [&] { (void)decode_image(encoded(exr)); });
        EXPECT_NE(message.find("its header announces"), std::string::npos) << message;
    }
    // Of types that hold lengths: a text and a preview of more than there is, each put before the first attribute.
    for (const auto& [type, value] :
         {std::pair<std::string, std::string>{"stringvector", std::string("\xFF\xFF\xFF\x7F", 4)},
          {"preview", std::string("\0\x40\0\0\0\x40\0\0", 8)}}) {
        std::string added = std::string("extra") + '\0' + type + '\0';
        added += static_cast<char>(value.size());
        added += std::string(3, '\0') + value;
        std::vector<std::uint8_t> exr = whole;
        exr.insert(exr.begin() + 8, added.begin(), added.end());
        const std::string message = message_of(ErrorKind::bad_input, [&] { (void)decode_image(encoded(exr)); });
        EXPECT_NE(message.find("its header announces"), std::string::npos) << message;
    }
}

TEST(Read, FilesThatAreNoImages) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "text.png") << "this is no picture";
    std::ofstream(folder / "empty.exr").flush();
    for (const char* name : {"text.png", "empty.exr", "missing.hdr"}) {
        const std::string message = message_of(ErrorKind::bad_input, [&] { (void)read_image(folder / name); });
        EXPECT_NE(message.find(name), std::string::npos) << message;
    }
    message_of(ErrorKind::bad_input, [&] { (void)read_image(folder.path()); });
}

// What Blender writes: all channels under the name of a layer.
TEST(Read, ChannelsInLayersOfRealFiles) {
    const std::filesystem::path file = std::filesystem::path(VKBAKE_SHARED_DATA_DIR) / "cycles/suzanne-ground.ao.exr";
    if (!std::filesystem::exists(file)) {
        GTEST_SKIP() << "no folder of real data here";
    }
    const Image image = read_image(file);
    EXPECT_GT(image.width, 0);
    float largest = 0.0F;
    for (const glm::vec4& texel : image.texels) {
        largest = std::max(largest, texel.x);
    }
    EXPECT_GT(largest, 0.5F);
    EXPECT_LE(largest, 1.1F);
}

} // namespace
} // namespace vkbake
