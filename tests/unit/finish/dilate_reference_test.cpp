// The CPU reference against values worked out by hand; the compute pass is held to it bit by bit in tests/gpu.
#include "finish/dilate_reference.hpp"

#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "vkbake/error.hpp"

namespace {

using vkbake::dilate_reference;
using vkbake::Image;

constexpr glm::vec4 empty{0.0F};

glm::vec4 lit(float value) { return {value, 2.0F * value, 4.0F * value, 1.0F}; }

Image image_of(int width, std::vector<glm::vec4> texels) {
    const int height = static_cast<int>(texels.size()) / width;
    return {.width = width, .height = height, .texels = std::move(texels), .coverage = {}};
}

TEST(DilateReference, AveragesFilledNeighboursOfTheRoundBefore) {
    // Two lit corners of a 3×3 map. The middle and two border texels see both or one of them; the other corners see
    // nothing that was filled before the first round.
    Image image = image_of(3, {lit(1.0F), empty, lit(3.0F), empty, empty, empty, empty, empty, empty});
    EXPECT_EQ(dilate_reference(image, 1), 4U);
    const std::vector<glm::vec4> first{lit(1.0F), lit(2.0F), lit(3.0F), lit(1.0F), lit(2.0F),
                                       lit(3.0F), empty,     empty,     empty};
    EXPECT_EQ(image.texels, first);

    EXPECT_EQ(dilate_reference(image, 1), 3U);
    EXPECT_EQ(image.texels[6], lit(1.5F)); // of 1 and 2
    EXPECT_EQ(image.texels[7], lit(2.0F)); // of 1, 2 and 3
    EXPECT_EQ(image.texels[8], lit(2.5F)); // of 2 and 3
}

TEST(DilateReference, RoundsInOneCallAreRoundsInSeveral) {
    const Image start =
        image_of(4, {lit(1.0F), empty, empty, empty, empty, empty, empty, lit(5.0F), empty, empty, empty, empty});
    Image at_once = start;
    Image in_steps = start;
    const std::uint64_t filled = dilate_reference(at_once, 3);
    std::uint64_t filled_in_steps = 0;
    for (int round = 0; round < 3; ++round) {
        filled_in_steps += dilate_reference(in_steps, 1);
    }
    EXPECT_EQ(filled, 10U);
    EXPECT_EQ(filled_in_steps, filled);
    EXPECT_EQ(at_once.texels, in_steps.texels);
}

TEST(DilateReference, FillsFromOneNeighbourAndNoFartherThanItsRounds) {
    Image image = image_of(6, {lit(0.7F), empty, empty, empty, empty, empty});
    EXPECT_EQ(dilate_reference(image, 3), 3U);
    EXPECT_EQ(image.texels, (std::vector<glm::vec4>{lit(0.7F), lit(0.7F), lit(0.7F), lit(0.7F), empty, empty}));
}

TEST(DilateReference, BlackLitTexelIsFilledAndSpreads) {
    const glm::vec4 black(0.0F, 0.0F, 0.0F, 1.0F);
    Image image = image_of(3, {black, empty, empty});
    EXPECT_EQ(dilate_reference(image, 1), 1U);
    EXPECT_EQ(image.texels, (std::vector<glm::vec4>{black, black, empty}));
}

TEST(DilateReference, EqualNeighboursGiveTheirValueToTheBit) {
    // Sums of three, five, six and seven equal floats round; the average must not drift for that.
    for (const float value : {0.1F, 1.0F / 3.0F, 1.9999999F, 3.4e38F, 1e-30F}) {
        for (int count = 1; count <= 8; ++count) {
            std::vector<glm::vec4> texels(9, empty);
            for (int i = 0; i < count; ++i) {
                texels[static_cast<std::size_t>(i < 4 ? i : i + 1)] = {value, value, value, 1.0F};
            }
            Image image = image_of(3, texels);
            dilate_reference(image, 1);
            EXPECT_EQ(image.texels[4], glm::vec4(value, value, value, 1.0F)) << count << " neighbours of " << value;
        }
    }
}

TEST(DilateReference, LeavesOutWhatIsNotFinite) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    Image image = image_of(3, {{nan, 1.0F, 1.0F, 1.0F}, lit(2.0F), {1.0F, infinity, 1.0F, 1.0F}, empty, empty, empty});
    EXPECT_EQ(dilate_reference(image, 1), 3U);
    EXPECT_EQ(image.texels[4], lit(2.0F));

    Image alone = image_of(2, {{nan, 1.0F, 1.0F, 1.0F}, empty});
    EXPECT_EQ(dilate_reference(alone, 1), 0U);
    EXPECT_EQ(alone.texels[1], empty);
}

TEST(DilateReference, KnowsFilledByTheBitsOfAlpha) {
    EXPECT_FALSE(vkbake::is_filled({1.0F, 1.0F, 1.0F, 0.0F}));
    EXPECT_FALSE(vkbake::is_filled({1.0F, 1.0F, 1.0F, -0.0F}));
    EXPECT_TRUE(vkbake::is_filled({0.0F, 0.0F, 0.0F, 1.0F}));
    EXPECT_TRUE(vkbake::is_filled({0.0F, 0.0F, 0.0F, std::bit_cast<float>(1U)}));
    EXPECT_TRUE(vkbake::is_filled({0.0F, 0.0F, 0.0F, std::numeric_limits<float>::quiet_NaN()}));
}

TEST(DilateReference, NoRoundsDoNothingAndNegativeOnesAreRefused) {
    const Image start = image_of(2, {lit(1.0F), empty});
    Image image = start;
    EXPECT_EQ(dilate_reference(image, 0), 0U);
    EXPECT_EQ(image.texels, start.texels);
    try {
        dilate_reference(image, -1);
        FAIL() << "accepted -1 rounds";
    } catch (const vkbake::Error& error) {
        EXPECT_EQ(error.kind(), vkbake::ErrorKind::usage);
    }
}

} // namespace
