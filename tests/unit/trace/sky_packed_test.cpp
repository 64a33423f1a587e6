// Pictures whose texels are packed into four bytes.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include "highway_targets.hpp"
#include "sky_looked_up.hpp"

namespace vkbake {
namespace {

using test::picture;
using test::pseudo_random;
using test::pseudo_random_direction;
using test::radiances;

/// A value that Radiance's files hold: 8 bits a channel times one power of two, here 2⁻³⁰ … 2¹⁷.
glm::vec3 shared_exponent_value(std::uint64_t key) {
    const double step = std::ldexp(1.0, static_cast<int>(48.0 * pseudo_random(4 * key)) - 30);
    const auto channel = [&](std::uint64_t number) {
        return static_cast<float>(step * std::floor(256.0 * pseudo_random(4 * key + number)));
    };
    return key % 7 == 0 ? glm::vec3(0.0F) : glm::vec3(channel(1), channel(2), channel(3));
}

TEST(PackedPictures, AreLookedUpWithTheBitsOfFloats) {
    std::vector<glm::vec3> directions;
    for (std::uint64_t i = 0; i < 2000; ++i) {
        directions.push_back(pseudo_random_direction(i));
    }
    for (const int width : {13, 16}) { // with and without a remainder of the squares of four
        const auto number = [&](int x, int y) {
            return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(y) + static_cast<std::uint64_t>(x);
        };
        Sky sky;
        sky.source =
            EquirectangularSky{picture(width, 9, [&](int x, int y) { return shared_exponent_value(number(x, y)); })};
        CubeSky cube;
        for (std::size_t face = 0; face < 6; ++face) {
            cube.faces.at(face) =
                picture(width, width, [&](int x, int y) { return shared_exponent_value(1000 * face + number(x, y)); });
        }
        for (const auto& source : {decltype(sky.source)(sky.source), decltype(sky.source)(cube)}) {
            sky.source = source;
            const SkyLookup floats = make_sky_lookup(sky);
            SkyLookup packed = floats;
            pack(packed);
            const auto* const panorama = std::get_if<EquirectangularLookup>(&packed);
            ASSERT_TRUE(panorama != nullptr ? panorama->image.is_packed()
                                            : std::get<CubeLookup>(packed).faces.is_packed());
            test::for_every_target([&] { EXPECT_EQ(radiances(packed, directions), radiances(floats, directions)); });
        }
    }
}

TEST(PackedPictures, AreLeftAloneWherePackingWouldLose) {
    Sky sky;
    for (const glm::vec3& other : {glm::vec3(257.0F, 0.0F, 0.0F), glm::vec3(128.0F, 0.25F, 0.0F), glm::vec3(1e-40F)}) {
        sky.source =
            EquirectangularSky{picture(8, 4, [&](int x, int y) { return x == 5 && y == 2 ? other : glm::vec3(1.0F); })};
        SkyLookup lookup = make_sky_lookup(sky);
        pack(lookup);
        EXPECT_FALSE(std::get<EquirectangularLookup>(lookup).image.is_packed());
        EXPECT_EQ(std::get<EquirectangularLookup>(lookup).image.at(0, 5, 2), other);
    }
}

TEST(PackedPictures, TakeTheNearestValueOrTheOneBelow) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
        const glm::vec3 value =
            static_cast<float>(std::exp2(60.0 * pseudo_random(i) - 30.0)) * glm::abs(pseudo_random_direction(i + 5000));
        const glm::vec3 near = packed_near(value);
        const glm::vec3 below = packed_below(value);
        const float step = std::max({value.x, value.y, value.z}) / 128.0F;
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_NEAR(near[channel], value[channel], step);
            EXPECT_LE(below[channel], value[channel]);
            EXPECT_GT(below[channel], value[channel] - step);
        }
        EXPECT_EQ(packed_below(near), near);
        EXPECT_EQ(packed_near(below), below);
    }
}

} // namespace
} // namespace vkbake
