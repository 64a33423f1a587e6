// --blend-creases through a whole bake.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

#include "device.hpp"
#include "panorama.hpp"
#include "roof.hpp"
#include "vkbake/vkbake.hpp"

namespace vkbake::test {
namespace {

constexpr std::size_t texel_count = std::size_t{roof_side} * roof_side;

Sky sloping_sky() {
    return panorama_of(64,
                       [](const glm::dvec3& direction) { return glm::dvec3(1.0 + glm::dot(sky_slope, direction)); });
}

LightMap bake_roof(Switch blend_creases) {
    Primitive primitive = roof();
    for (const glm::vec3& position : primitive.positions) {
        primitive.tex_coords[1].emplace_back(position.x, position.z);
    }
    Settings settings;
    settings.size = roof_side;
    settings.uv = UvSource::trust;
    settings.rays = 1024;
    settings.estimate_error = true;
    settings.directional = Switch::on;
    settings.blend_creases = blend_creases;
    return bake(scene_of(primitive), sloping_sky(), settings, device()).light_maps.at(0);
}

struct CreaseBakes : testing::Test {
    static const LightMap& blended() {
        static const LightMap map = bake_roof(Switch::on);
        return map;
    }
    static const LightMap& sampled() {
        static const LightMap map = bake_roof(Switch::off);
        return map;
    }
};

TEST_F(CreaseBakes, HoldTheMeanOfBothFacesUnderALinearSky) {
    const double first = under_sloping_sky(first_normal());
    const double second = under_sloping_sky(second_normal());
    double far_off = 0.0;
    for (int y = 0; y < roof_side; ++y) {
        for (int x = 0; x < roof_side; ++x) {
            const double share = first_share(x, y);
            const double mean = share * first + (1.0 - share) * second;
            const std::size_t texel = blended().image.index(x, y);
            EXPECT_NEAR(blended().image.texels[texel].g, mean, 0.01) << x << ", " << y;
            far_off = std::max(far_off, std::abs(static_cast<double>(sampled().image.texels[texel].g) - mean));
        }
    }
    // One point of a texel is on one face; of the texels on the crease a quarter or three quarters are.
    EXPECT_NEAR(far_off, 0.25 * std::abs(first - second), 0.01);
    EXPECT_EQ(blended().statistics.blended_texels, std::uint64_t{roof_side}); // one in each row
    EXPECT_EQ(sampled().statistics.blended_texels, 0U);
}

/// What is mixed is every picture of the map and its errors, and nothing but these texels.
TEST_F(CreaseBakes, MixAllThatTheMapHas) {
    const auto touched = [](std::size_t texel) {
        const double share = first_share(static_cast<int>(texel) % roof_side, static_cast<int>(texel) / roof_side);
        return share > 0.0 && share < 1.0;
    };
    ASSERT_EQ(blended().directional.size(), 4U);
    std::array<std::size_t, 3> mixed{}; // of light, its slope along x, errors
    for (std::size_t texel = 0; texel < texel_count; ++texel) {
        const std::array<bool, 3> changed{
            blended().image.texels[texel] != sampled().image.texels[texel],
            blended().directional[3].texels[texel] != sampled().directional[3].texels[texel],
            blended().standard_error[texel] != sampled().standard_error[texel],
        };
        for (std::size_t i = 0; i < changed.size(); ++i) {
            mixed[i] += changed[i] ? 1 : 0;
            EXPECT_TRUE(!changed[i] || touched(texel)) << texel;
        }
    }
    for (const std::size_t count : mixed) {
        EXPECT_EQ(count, std::size_t{roof_side});
    }
}

} // namespace
} // namespace vkbake::test
