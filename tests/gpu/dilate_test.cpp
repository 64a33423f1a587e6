// The compute pass against its CPU reference, bit by bit.
#include "finish/dilate.hpp"

#include <bit>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "device.hpp"
#include "finish/dilate_reference.hpp"
#include "same_bits.hpp"
#include "vkbake/error.hpp"

namespace {

using vkbake::Image;
using vkbake::test::context;

bool same_bits(const Image& a, const Image& b) {
    return a.width == b.width && a.height == b.height && vkbake::test::same_bits(a.texels, b.texels) &&
           a.coverage == b.coverage;
}

/// `share` of the texels filled, with values over all magnitudes, both signs, denormals, infinities and NaN with
/// payloads.
Image random_map(int width, int height, double share, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    Image image{.width = width, .height = height, .texels = {}, .coverage = {}};
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const auto value = [&] {
        const double kind = unit(random);
        const auto bits = static_cast<std::uint32_t>(random());
        if (kind < 0.6) {
            return static_cast<float>(unit(random));
        }
        if (kind < 0.95) {
            return std::bit_cast<float>(bits); // any float there is
        }
        return std::bit_cast<float>(kind < 0.97 ? bits & 0x807FFFFFU : bits | 0x7F800000U);
    };
    for (std::size_t i = 0; i < count; ++i) {
        const bool filled = unit(random) < share;
        image.texels.emplace_back(value(), value(), value(), filled ? 1.0F : 0.0F);
        image.coverage.push_back(filled ? 1.0F : 0.0F);
    }
    return image;
}

void expect_equals_reference(const Image& start, int rounds, int tile) {
    Image expected = start;
    const std::uint64_t filled = vkbake::dilate_reference(expected, rounds);
    Image image = start;
    EXPECT_EQ(vkbake::dilate(context(), image, {.rounds = rounds, .tile = tile}), filled);
    EXPECT_TRUE(same_bits(image, expected))
        << start.width << " x " << start.height << ", " << rounds << " rounds, tile " << tile;
}

TEST(Dilate, EqualsTheReferenceForSizesAndTiles) {
    struct Size {
        int width;
        int height;
    };
    for (const Size size :
         {Size{1, 1}, Size{1, 37}, Size{53, 1}, Size{7, 5}, Size{16, 16}, Size{61, 67}, Size{97, 40}}) {
        for (const int tile : {16, 33, 2048}) {
            for (const int rounds : {1, 3, 8}) {
                expect_equals_reference(random_map(size.width, size.height, 0.05, 7), rounds, tile);
            }
        }
    }
}

TEST(Dilate, EqualsTheReferenceForEveryShareOfFilledTexels) {
    for (const double share : {0.0, 0.001, 0.3, 0.7, 0.999, 1.0}) {
        expect_equals_reference(random_map(71, 45, share, 11), 5, 33);
    }
}

TEST(Dilate, ATexelBesideATilesBorderReachesAllTilesAround) {
    for (const int x : {0, 15, 16, 17, 39}) {
        for (const int y : {0, 16, 31}) {
            Image image = random_map(40, 40, 0.0, 19);
            image.texels[image.index(x, y)] = {1.0F, 2.0F, 3.0F, 1.0F};
            expect_equals_reference(image, 3, 16);
        }
    }
}

TEST(Dilate, EqualsTheReferenceOverManyRounds) {
    // More than are submitted together, and more than the map is long.
    Image image = random_map(90, 31, 0.0, 13);
    image.texels[0] = {1.0F, 2.0F, 3.0F, 1.0F};
    for (const int rounds : {15, 16, 17, 40, 500}) {
        expect_equals_reference(image, rounds, 2048);
        expect_equals_reference(image, rounds, 33);
    }
}

TEST(Dilate, StopsEarlyWithoutChangingTheResult) {
    // One hole in a full map: filled in the first of a thousand rounds.
    Image image = random_map(64, 64, 1.0, 17);
    image.texels[image.index(31, 30)] = {};
    expect_equals_reference(image, 1000, 2048);
}

TEST(Dilate, NeverChangesTheBitsOfFilledTexels) {
    const Image start = random_map(120, 80, 0.5, 19);
    Image image = start;
    EXPECT_GT(vkbake::dilate(context(), image, {.rounds = 4, .tile = 33}), 0U);
    std::size_t special = 0;
    for (std::size_t i = 0; i < start.texels.size(); ++i) {
        if (!vkbake::is_filled(start.texels[i])) {
            continue;
        }
        ASSERT_TRUE(vkbake::test::same_bits(std::span(&start.texels[i], 1), std::span(&image.texels[i], 1)))
            << "texel " << i;
        for (int channel = 0; channel < 3; ++channel) {
            const auto exponent = std::bit_cast<std::uint32_t>(start.texels[i][channel]) & 0x7F800000U;
            special += exponent == 0 || exponent == 0x7F800000U ? 1 : 0;
        }
    }
    EXPECT_GT(special, 100U) << "the map has too few denormals and NaN to prove anything";
    EXPECT_EQ(image.coverage, start.coverage);
}

TEST(Dilate, BlackLitTexelSpreadsBlack) {
    Image image{.width = 3, .height = 3, .texels = std::vector<glm::vec4>(9), .coverage = {}};
    image.texels[4] = {0.0F, 0.0F, 0.0F, 1.0F};
    EXPECT_EQ(vkbake::dilate(context(), image, {.rounds = 1}), 8U);
    EXPECT_EQ(image.texels, std::vector<glm::vec4>(9, glm::vec4(0.0F, 0.0F, 0.0F, 1.0F)));
}

TEST(Dilate, RefusesWhatIsOutOfRange) {
    Image image{.width = 1, .height = 1, .texels = {glm::vec4(0.0F)}, .coverage = {}};
    EXPECT_EQ(vkbake::dilate(context(), image, {.rounds = 0}), 0U);
    for (const vkbake::DilateSettings& settings :
         {vkbake::DilateSettings{.rounds = -1}, vkbake::DilateSettings{.tile = 0}}) {
        try {
            vkbake::dilate(context(), image, settings);
            FAIL() << "accepted";
        } catch (const vkbake::Error& error) {
            EXPECT_EQ(error.kind(), vkbake::ErrorKind::usage);
        }
    }
}

} // namespace
