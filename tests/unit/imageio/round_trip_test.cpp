#include <algorithm>
#include <bit>
#include <cmath>
#include <csignal>
#include <fstream>
#include <iterator>
#include <limits>

#include <sys/resource.h>

#include "imageio/encode.hpp"
#include "imageio/staged_file.hpp"
#include "same_bits.hpp"
#include "test_images.hpp"
#include "vkbake/vkbake.hpp"

namespace vkbake {
namespace {

using test::message_of;
using test::TemporaryFolder;

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();

/// More than one tile in each direction, no multiple of the tile's size, every texel another.
Image gradient(bool with_coverage) {
    Image image{131, 70, {}, {}};
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const auto column = static_cast<float>(x);
            const auto row = static_cast<float>(y);
            image.texels.emplace_back(column / 7.0F, row / 3.0F, (column + row) * 1e-3F,
                                      (x + y) % 3 == 0 ? 0.0F : 1.0F);
            if (with_coverage) {
                image.coverage.push_back((x + y) % 3 == 1 ? 1.0F : 0.0F);
            }
        }
    }
    return image;
}

void write_bytes(const std::filesystem::path& file, const std::vector<std::uint8_t>& bytes) {
    StagedFile(file, bytes).commit();
}

bool same_bits(const Image& a, const Image& b) {
    return a.width == b.width && a.height == b.height && test::same_bits(a.texels, b.texels) &&
           a.coverage == b.coverage;
}

TEST(RoundTrip, ExrKeepsEveryBitAndCoverage) {
    const TemporaryFolder folder;
    Image image = gradient(true);
    image.texels[3] = {std::bit_cast<float>(0x7fc12345U), infinite, -infinite, 1.0F};
    image.texels[4] = {std::bit_cast<float>(1U), -0.0F, std::numeric_limits<float>::max(), 0.5F};
    write_image(folder / "map.exr", image);
    EXPECT_TRUE(same_bits(read_image(folder / "map.exr"), image));

    const Image plain = gradient(false);
    write_image(folder / "map.exr", plain); // over the older one
    EXPECT_TRUE(same_bits(read_image(folder / "map.exr"), plain));
}

// Read as bytes, not by the reader under test: the header of an OpenEXR file lists its channels by name.
TEST(RoundTrip, ExrNamesItsChannelsAndProvenanceAndNoTime) {
    const EncodedFile file = encode_image(gradient(true), ImageFormat::exr, {{"vkbake:version", "9.8.7"}});
    const std::string header(file.bytes.begin(), file.bytes.begin() + 1000);
    for (const char* text : {"vkbake:version", "9.8.7", "coverage", "tiles"}) {
        EXPECT_NE(header.find(text), std::string::npos) << text;
    }
    EXPECT_EQ(header.find("capDate"), std::string::npos);
    EXPECT_EQ(file.changed_values, 0U);
}

TEST(RoundTrip, PngTellsItsProvenanceInUtf8) {
    const std::string name = "vkbake:map";
    const std::string value = "k\u00fcche";
    const auto bytes = encode_image(gradient(false), ImageFormat::png16, {{name, value}}).bytes;
    const std::string file(bytes.begin(), bytes.end());
    // Keyword, its end, not compressed (flag and method), no language, no translated keyword: PNG, 11.3.4.5.
    EXPECT_NE(file.find("iTXt" + name + std::string(5, '\0') + value), std::string::npos);
    EXPECT_EQ(file.find("tIME"), std::string::npos);
}

TEST(RoundTrip, SameBytesEachTime) {
    const Image image = gradient(true);
    for (const ImageFormat format : {ImageFormat::exr, ImageFormat::hdr, ImageFormat::png16, ImageFormat::png8}) {
        const Attributes attributes{{"vkbake:version", "1"}};
        EXPECT_EQ(encode_image(image, format, attributes).bytes, encode_image(image, format, attributes).bytes);
    }
}

// RGBE shares one exponent. The largest channel's mantissa is 128 … 255, so half a step is at most 1/256 of that
// channel.
TEST(RoundTrip, HdrRoundsToHalfAStep) {
    const TemporaryFolder folder;
    const Image image = gradient(false);
    write_image(folder / "map.hdr", image);
    const Image read = read_image(folder / "map.hdr");
    ASSERT_EQ(read.texels.size(), image.texels.size());
    double signed_error = 0.0;
    for (std::size_t i = 0; i < image.texels.size(); ++i) {
        const glm::vec4& texel = image.texels[i];
        const float largest = std::max({texel.x, texel.y, texel.z});
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_NEAR(read.texels[i][channel], texel[channel], largest / 256.0F * 1.0001F);
        }
        signed_error += largest > 0.0F ? static_cast<double>((read.texels[i].y - texel.y) / largest) : 0.0;
        EXPECT_EQ(read.texels[i].w, 1.0F);
    }
    EXPECT_LT(std::abs(signed_error) / static_cast<double>(image.texels.size()), 5e-4) << "truncated, not rounded";
}

TEST(RoundTrip, HdrAtItsLimits) {
    const TemporaryFolder folder;
    Image image{
        3, 1, {{not_a_number, -1.0F, infinite, 1.0F}, {3.4e38F, 1.0F, 0.0F, 1.0F}, {255.9F, 129.0F, 1.0F, 1.0F}}, {}};
    const EncodedFile file = encode_image(image, ImageFormat::hdr);
    EXPECT_EQ(file.changed_values, 4U); // NaN, negative, infinite, too large
    write_bytes(folder / "map.hdr", file.bytes);
    const Image read = read_image(folder / "map.hdr");
    EXPECT_EQ(read.texels[0], glm::vec4(0.0F, 0.0F, 0x1.FEp+126F, 1.0F));
    EXPECT_EQ(read.texels[1], glm::vec4(0x1.FEp+126F, 0.0F, 0.0F, 1.0F));
    EXPECT_EQ(read.texels[2].x, 256.0F); // carried into the next exponent, where a step is 2
    EXPECT_NEAR(read.texels[2].y, 129.0F, 1.0F);
}

TEST(RoundTrip, Png16IsLinearAndClamped) {
    const TemporaryFolder folder;
    Image image{3, 1, {{0.25F, 0.5F, 1.0F, 1.0F}, {not_a_number, -2.0F, 7.0F, 0.0F}, {1e-5F, 0.9F, 0.0F, 1.0F}}, {}};
    const EncodedFile file = encode_image(image, ImageFormat::png16);
    EXPECT_EQ(file.changed_values, 3U);
    write_bytes(folder / "map.png", file.bytes);
    const Image read = read_image(folder / "map.png");
    for (int channel = 0; channel < 4; ++channel) {
        EXPECT_NEAR(read.texels[0][channel], image.texels[0][channel], 0.5F / 65535.0F);
        EXPECT_NEAR(read.texels[2][channel], image.texels[2][channel], 0.5F / 65535.0F + 1e-7F);
    }
    EXPECT_EQ(read.texels[1], glm::vec4(0.0F, 0.0F, 1.0F, 0.0F));
    EXPECT_TRUE(read.coverage.empty());
}

// Colours under alpha 0 must not be lost to premultiplication, neither in writing nor in reading.
TEST(RoundTrip, Png8IsSrgbWithStraightAlpha) {
    const TemporaryFolder folder;
    const Image image{2, 1, {{0.5F, 1.0F, 0.0F, 0.0F}, {10.0F / 255.0F, -1.0F, 2.0F, 0.2F}}, {}};
    write_image(folder / "picture.png", image);
    const Image read = read_image(folder / "picture.png");
    // 128/255 encoded is 0.2158605 linear; 10/255 lies on the straight part: ÷ 12.92.
    EXPECT_NEAR(read.texels[0].x, 0.2158605F, 1e-6F);
    EXPECT_EQ(read.texels[0].y, 1.0F);
    EXPECT_EQ(read.texels[0].w, 0.0F);
    EXPECT_NEAR(read.texels[1].x, 10.0F / 255.0F / 12.92F, 1e-8F);
    EXPECT_EQ(read.texels[1].y, 0.0F);
    EXPECT_EQ(read.texels[1].z, 1.0F);
    EXPECT_NEAR(read.texels[1].w, 0.2F, 1e-6F);
}

TEST(Write, RefusesWhatCannotBeWritten) {
    const TemporaryFolder folder;
    const Image image = test::filled(2, 2, glm::vec4(1.0F));
    message_of(ErrorKind::output, [&] { write_image(folder / "map.tga", image); });
    message_of(ErrorKind::output, [&] { write_image(folder / "map.exr", Image{2, 2, {}, {}}); });
    message_of(ErrorKind::output, [&] { write_image(folder / "map.exr", Image{}); });
    write_image(folder / "file.exr", image);
    const std::string message =
        message_of(ErrorKind::output, [&] { write_image(folder / "file.exr" / "map.exr", image); });
    EXPECT_NE(message.find("map.exr"), std::string::npos) << message;
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

/// While it lives, no file of this process can grow beyond a size: what a full disk does.
class SmallFiles {
public:
    explicit SmallFiles(rlim_t bytes) : m_handler(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &m_saved);
        const rlimit limit{bytes, m_saved.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~SmallFiles() {
        setrlimit(RLIMIT_FSIZE, &m_saved);
        std::signal(SIGXFSZ, m_handler);
    }
    SmallFiles(const SmallFiles&) = delete;
    SmallFiles& operator=(const SmallFiles&) = delete;

private:
    rlimit m_saved{};
    void (*m_handler)(int);
};

TEST(Write, AFullDiskKeepsTheOldFile) {
    const TemporaryFolder folder;
    const Image old = test::filled(2, 2, glm::vec4(1.0F));
    write_image(folder / "map.exr", old);
    {
        const SmallFiles full(100);
        message_of(ErrorKind::output, [&] { write_image(folder / "map.exr", gradient(true)); });
    }
    EXPECT_TRUE(same_bits(read_image(folder / "map.exr"), old));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1) << "a temporary was left";
}

TEST(Write, AnInterruptedPictureKeepsTheOldFile) {
    const TemporaryFolder folder;
    const Image old = test::filled(2, 2, glm::vec4(1.0F));
    write_image(folder / "map.exr", old);
    message_of(ErrorKind::interrupted, [&] {
        write_image(folder / "map.exr", gradient(true), [](const ProgressReport& /*report*/) { return false; });
    });
    EXPECT_TRUE(same_bits(read_image(folder / "map.exr"), old));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1) << "a temporary was left";
}

/// While the bytes themselves are written too: before each block of 16 MiB.
TEST(Write, AnInterruptedFileGoes) {
    const TemporaryFolder folder;
    const std::vector<std::uint8_t> bytes((std::size_t{16} << 20U) + 1);
    for (int last = 1; last <= 2; ++last) {
        int asked = 0;
        const auto stop = [&] {
            if (++asked == last) {
                throw Error(ErrorKind::interrupted, "interrupted");
            }
        };
        message_of(ErrorKind::interrupted, [&] { const StagedFile file(folder / "data.bin", bytes, stop); });
        EXPECT_EQ(asked, last);
        EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
    }
}

TEST(Write, AFileThatCannotBePutInPlace) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "map.png"); // no file can be renamed onto a folder
    message_of(ErrorKind::output, [&] { write_image(folder / "map.png", test::filled(2, 2, glm::vec4(1.0F))); });
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1) << "a temporary was left";
}

TEST(Write, WhatIsNotCommittedGoes) {
    const TemporaryFolder folder;
    const std::vector<std::uint8_t> bytes{1, 2, 3};
    { const StagedFile file(folder / "deep/er/data.bin", bytes); }
    EXPECT_TRUE(std::filesystem::is_empty(folder / "deep/er"));
}

} // namespace
} // namespace vkbake
