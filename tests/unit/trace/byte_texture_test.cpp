// Textures as opacity looks them up.
#include "trace/byte_texture.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "amount.hpp"
#include "base/random.hpp"

namespace vkbake {
namespace {

ByteTexture random_texture(int width, int height, std::uint64_t seed) {
    ByteTexture texture{width, height, {}};
    for (int texel = 0; texel < width * height; ++texel) {
        texture.texels.push_back(static_cast<std::uint8_t>(mix64(seed + static_cast<std::uint64_t>(texel))));
    }
    return texture;
}

float value(const ByteTexture& texture, const TextureUse& use, const glm::dvec2& uv) {
    const TextureSampler sampler(use);
    return sampler.value(texture, linear_values(), sampler.place(uv));
}

const ByteTexture ramp{4, 1, {0, 51, 102, 255}};

TEST(ByteTexture, NearestTakesTheTexelUnderThePlaceAsItWraps) {
    const auto at = [](double u, Wrap wrap) {
        return std::lround(value(ramp, {.wrap_u = wrap, .filter = Filter::nearest}, {u, 7.3}) * 255.0F);
    };
    EXPECT_EQ(at(0.3, Wrap::repeat), 51);
    EXPECT_EQ(at(-0.1, Wrap::repeat), 255);
    EXPECT_EQ(at(2.6, Wrap::repeat), 102);
    EXPECT_EQ(at(-1e-30, Wrap::repeat), 0); // as near to 1 as to 0
    EXPECT_EQ(at(1.3, Wrap::clamp), 255);
    EXPECT_EQ(at(1.0, Wrap::clamp), 255);
    EXPECT_EQ(at(-3.0, Wrap::clamp), 0);
    EXPECT_EQ(at(1.3, Wrap::mirror), 102);
    EXPECT_EQ(at(-0.3, Wrap::mirror), 51);
    EXPECT_EQ(at(1e300, Wrap::repeat), 0);
    EXPECT_EQ(at(std::numeric_limits<double>::quiet_NaN(), Wrap::mirror), 0);
    EXPECT_EQ(at(std::numeric_limits<double>::infinity(), Wrap::clamp), 0);
}

TEST(ByteTexture, LinearBlendsAcrossTheBorderAsItWraps) {
    const auto at = [](double u, Wrap wrap) {
        return static_cast<double>(value(ramp, {.wrap_u = wrap}, {u, 0.0}) * 255.0F);
    };
    EXPECT_EQ(at(0.125, Wrap::repeat), 0.0); // a texel's centre
    EXPECT_NEAR(at(0.25, Wrap::repeat), 25.5, 1e-4);
    EXPECT_NEAR(at(0.0, Wrap::repeat), 127.5, 1e-4);
    EXPECT_NEAR(at(0.9375, Wrap::repeat), 255.0 * 0.75, 1e-4);
    EXPECT_EQ(at(0.0, Wrap::clamp), 0.0);
    EXPECT_EQ(at(1.0, Wrap::clamp), 255.0);
    EXPECT_EQ(at(1.0, Wrap::mirror), 255.0);
    EXPECT_NEAR(at(1.25, Wrap::mirror), 178.5, 1e-4);
    EXPECT_EQ(at(2.0, Wrap::mirror), 0.0);
}

TEST(ByteTexture, PlacesAreTransformedAsGltfHasIt) {
    const TextureUse use{.offset = {0.25F, -1.5F}, .rotation = 0.7F, .scale = {2.0F, -3.0F}};
    const glm::dvec2 found = TextureSampler(use).place({0.3, 0.9});
    // KHR_texture_transform: offset · rotation · scale, with its rotation matrix (cos, sin; −sin, cos).
    const double u = 2.0 * 0.3;
    const double v = -3.0 * 0.9;
    EXPECT_NEAR(found.x, 0.25 + std::cos(0.7) * u + std::sin(0.7) * v, 1e-6);
    EXPECT_NEAR(found.y, -1.5 - std::sin(0.7) * u + std::cos(0.7) * v, 1e-6);
    // A quarter turn: the picture's right lies where its top was.
    const glm::dvec2 turned = TextureSampler({.rotation = std::numbers::pi_v<float> / 2.0F}).place({0.25, 0.0});
    EXPECT_LT(glm::length(turned - glm::dvec2(0.0, -0.25)), 1e-7);
}

TEST(ByteTexture, RangesHoldWhatLookUpsFind) {
    std::uint64_t state = 0;
    const auto random = [&] { return static_cast<double>(mix64(++state) >> 11U) * 0x1p-53; };
    std::size_t tight = 0;
    for (int i = 0; i < test::amount(400, 60); ++i) {
        const ByteTexture texture = random_texture(1 + static_cast<int>(random() * 40.0),
                                                   1 + static_cast<int>(random() * 40.0), mix64(++state));
        const TextureRanges ranges(texture);
        const auto wrap = [&] { return static_cast<Wrap>(static_cast<int>(random() * 3.0)); };
        const TextureSampler sampler(
            {.wrap_u = wrap(), .wrap_v = wrap(), .filter = i % 2 == 0 ? Filter::linear : Filter::nearest});
        const glm::dvec2 low(random() * 4.0 - 2.0, random() * 4.0 - 2.0);
        const glm::dvec2 high = low + glm::dvec2(random(), random()) * (i % 3 == 0 ? 2.0 : 0.3);
        const ByteRange range = ranges.within(sampler, low, high);
        tight += range.least > 0 || range.greatest < 255 ? 1 : 0;
        for (int look = 0; look < 50; ++look) {
            const glm::dvec2 place = low + glm::dvec2(random(), random()) * (high - low);
            const float found = sampler.value(texture, linear_values(), place);
            EXPECT_GE(found, static_cast<float>(range.least) / 255.0F);
            EXPECT_LE(found, static_cast<float>(range.greatest) / 255.0F);
        }
    }
    EXPECT_GT(tight, 20U);
}

TEST(ByteTexture, RangesAreExactWhereTheRectangleIsSmall) {
    // One dark texel in a large picture: seen from around it, and from nowhere else.
    ByteTexture texture{256, 256, std::vector<std::uint8_t>(256 * 256, 255)};
    texture.texels[100 * 256 + 60] = 7;
    const TextureRanges ranges(texture);
    const TextureSampler sampler(TextureUse{});
    const auto around = [&](double x, double y, double half) {
        return ranges
            .within(sampler, {(x - half) / 256.0, (y - half) / 256.0}, {(x + half) / 256.0, (y + half) / 256.0})
            .least;
    };
    EXPECT_EQ(around(60.5, 100.5, 2.0), 7);
    EXPECT_EQ(around(70.5, 100.5, 4.0), 255);
    EXPECT_EQ(around(60.5 - 256.0, 100.5 + 512.0, 2.0), 7);
    EXPECT_EQ(around(0.0, 0.0, 40.0), 255); // across the border
    EXPECT_EQ(ranges.within(sampler, {0.0, 0.0}, {3.0, 3.0}).least, 7);
    EXPECT_EQ(ranges.within(sampler, glm::dvec2(std::numeric_limits<double>::quiet_NaN()), {3.0, 3.0}).least, 7);
}

TEST(ByteTexture, IsHalvedToItsBound) {
    const int width = 2 * most_opacity_texels;
    std::vector<std::uint8_t> rgba;
    for (int texel = 0; texel < width * 2; ++texel) {
        rgba.insert(rgba.end(), {9, 9, 9, static_cast<std::uint8_t>(texel % 2 == 0 ? 10 : 21)});
    }
    const ByteTexture texture = make_byte_texture(width, 2, rgba, 3);
    EXPECT_EQ(texture.width, most_opacity_texels);
    EXPECT_EQ(texture.height, 1);
    EXPECT_EQ(texture.texels, std::vector<std::uint8_t>(static_cast<std::size_t>(most_opacity_texels), 16)); // 15.5
}

} // namespace
} // namespace vkbake
