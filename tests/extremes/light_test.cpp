// Skies from the faintest to the most blinding.
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "amount.hpp"
#include "host_bake.hpp"
#include "imageio/encode.hpp"
#include "trace/sky_lookup.hpp"
#include "trace/sky_sum.hpp"

namespace vkbake::test {
namespace {

Sky picture(int width, int height, const std::function<glm::vec3(int, int)>& radiance) {
    Image image{width, height, {}, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            image.texels.emplace_back(radiance(x, y), 1.0F);
        }
    }
    return {.source = EquirectangularSky{std::move(image)}};
}

Sky cube_sky(int size, float radiance) {
    const Image face{
        size,
        size,
        std::vector<glm::vec4>(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), glm::vec4(radiance)),
        {}};
    return {.source = CubeSky{{face, face, face, face, face, face}}};
}

/// A surface that nothing hides, facing along y or, turned, elsewhere.
LightMap light_on_a_plane(const Sky& sky, std::uint32_t rays, const glm::dmat3& linear = glm::dmat3(1.0)) {
    Settings settings = small_settings(8, rays);
    settings.mode = Mode::irradiance;
    return bake_on_host(scene_of(floor_of(1.0F), {}, linear), sky, settings).maps.at(0);
}

double error_in_last_places(const LightMap& map, double expected) {
    double worst = 0.0;
    for (std::size_t texel = 0; texel < map.image.texels.size(); ++texel) {
        if (map.image.coverage[texel] > 0.5F) {
            for (int channel = 0; channel < 3; ++channel) {
                const double value = map.image.texels[texel][channel];
                worst = std::max(worst, std::abs(value - expected) / (expected * 0x1p-23));
            }
        }
    }
    return worst;
}

/// One radiance from everywhere comes out as it went in: the sums are of doubles, so many rays add no error; a picture
/// is interpolated in floats, which errs by a few last places.
TEST(Light, OneRadianceIsKeptFromTheFaintestToTheMostBlinding) {
    for (const float radiance : {1e-30F, 3e-10F, 1.0F / 3.0F, 1e6F, 1e9F, 1e38F}) {
        SCOPED_TRACE(radiance);
        for (const std::uint32_t rays : {1U, 100U, amount(5000U, 300U)}) {
            EXPECT_LE(error_in_last_places(light_on_a_plane(constant_sky(glm::vec3(radiance)), rays), radiance), 1.0);
            EXPECT_LE(
                error_in_last_places(
                    light_on_a_plane(picture(8, 4, [&](int, int) { return glm::vec3(radiance); }), rays), radiance),
                4.0);
            EXPECT_LE(error_in_last_places(light_on_a_plane(cube_sky(4, radiance), rays), radiance), 4.0);
        }
    }
}

/// A sun of 10⁹ in a sky of 10⁻³⁰: who cannot see the sun gets the sky's 10⁻³⁰ in full; who sees it gets a finite
/// value.
TEST(Light, ASunDoesNotDrownAFaintSky) {
    const Sky sky = picture(64, 32, [](int x, int y) { // the sun around +X, 45° up
        return glm::vec3(std::abs(x - 32) <= 1 && std::abs(y - 8) <= 1 ? 1e9F : 1e-30F);
    });
    // Facing −X: the sun is behind the surface's back.
    const glm::dmat3 away(0, 1, 0, -1, 0, 0, 0, 0, 1);
    EXPECT_LE(error_in_last_places(light_on_a_plane(sky, 1000, away), 1e-30), 4.0);
    const LightMap lit = light_on_a_plane(sky, 4096);
    for (std::size_t texel = 0; texel < lit.image.texels.size(); ++texel) {
        if (lit.image.coverage[texel] > 0.5F) {
            // Bilinear texels stretch over 4 × 4 at most, each 1/64 of the turn and of it cos 45° or less in area.
            ASSERT_GT(lit.image.texels[texel].x, 1e5F);
            ASSERT_LT(lit.image.texels[texel].x, 2e7F);
        }
    }
}

/// 5000 rays of which half bring 10⁹ and half 1: the sum of the small ones is not lost, as in floats it would be.
TEST(Light, SumsKeepTheSmallBesideTheLarge) {
    const Sky sky = picture(4096, 2, [](int x, int) { return glm::vec3(x < 2048 ? 1e9F : 1.0F, 1.0F, 1e-30F); });
    const LightMap map = light_on_a_plane(sky, 5000);
    for (std::size_t texel = 0; texel < map.image.texels.size(); ++texel) {
        if (map.image.coverage[texel] > 0.5F) {
            ASSERT_NEAR(static_cast<double>(map.image.texels[texel].x), 5e8, 6.0 * 5e8 / std::sqrt(5000.0));
            ASSERT_NEAR(static_cast<double>(map.image.texels[texel].y), 1.0, 0x1p-21);
            ASSERT_NEAR(static_cast<double>(map.image.texels[texel].z), 1e-30, 1e-30 * 0x1p-21);
        }
    }
}

TEST(Light, BlackAndTinySkies) {
    const LightMap black = light_on_a_plane(constant_sky(glm::vec3(0.0F)), 16);
    for (const glm::vec4& texel : black.image.texels) {
        EXPECT_EQ(glm::vec3(texel), glm::vec3(0.0F));
    }
    EXPECT_GT(black.statistics.covered_texels, 16U);
    for (Sky sky : {constant_sky(glm::vec3(1.0F)), picture(4, 2, [](int, int) { return glm::vec3(1e9F); }), Sky{}}) {
        sky.intensity = 0.0;
        for (const glm::vec4& texel : light_on_a_plane(sky, 16).image.texels) {
            EXPECT_EQ(glm::vec3(texel), glm::vec3(0.0F));
        }
    }
    EXPECT_LE(error_in_last_places(light_on_a_plane(picture(1, 1, [](int, int) { return glm::vec3(0.7F); }), 64), 0.7F),
              4.0);
    EXPECT_LE(error_in_last_places(light_on_a_plane(cube_sky(1, 0.7F), 64), 0.7F), 4.0);
}

TEST(Light, SkiesOfOneTexelAreConstant) {
    const glm::vec4 texel(0.25F, 1e-20F, 3e5F, 1.0F);
    const Image one{1, 1, {texel}, {}};
    const CubeSky cube{{one, one, one, one, one, one}};
    for (const Sky& sky : {Sky{.source = EquirectangularSky{one}}, Sky{.source = cube}}) {
        const SkyLookup lookup = make_sky_lookup(sky);
        for (const glm::vec3& direction : {glm::vec3(1, 0, 0), glm::vec3(-1, 0, -0.0F), glm::vec3(0, 1, 0),
                                           glm::vec3(0, -1, 0), glm::vec3(0.6F, 0, -0.8F), glm::vec3(0, 0.6F, 0.8F)}) {
            const glm::vec3 found = radiance(lookup, direction);
            for (int channel = 0; channel < 3; ++channel) {
                EXPECT_NEAR(found[channel], texel[channel],
                            4 * 0x1p-24F * texel[channel]); // of interpolation in floats
            }
        }
    }
}

/// Where the cosine of the angle to the pole is 1 in floats: a picture whose radiance is the row's number gives the
/// angle back, by rows.
TEST(Light, RowsAreToldApartUpToThePoles) {
    constexpr int height = 16384;
    const SkyLookup lookup =
        make_sky_lookup(picture(2, height, [](int, int y) { return glm::vec3(static_cast<float>(y)); }));
    for (int step = 4; step <= 40; ++step) {
        const double row = 0.25 * step + 0.1; // from the pole; the middle of row 0 is at one half
        const double angle = row * std::numbers::pi / height;
        const glm::dvec3 up(std::sin(angle) * 0.6, std::cos(angle), std::sin(angle) * 0.8);
        EXPECT_NEAR(radiance(lookup, glm::vec3(up)).x, row - 0.5, 1e-3) << row;
        const glm::dvec3 down(up.x, -up.y, up.z);
        EXPECT_NEAR(radiance(lookup, glm::vec3(down)).x, height - row - 0.5, 0.01) << row; // 16384 in floats
    }
}

/// No place of it is counted in too few bits. It takes 4 GiB and seconds, so tools/extremes.sh runs it.
TEST(Light, DISABLED_ASkyOf16384By8192Texels) {
    constexpr int width = 16384;
    constexpr int height = 8192;
    Image image{width, height, std::vector<glm::vec4>(std::size_t{width} * height, glm::vec4(0.5F)), {}};
    const std::pair<int, int> places[] = {
        {0, 0}, {width - 1, 0}, {0, height - 1}, {width - 1, height - 1}, {5000, 7000}, {width - 1, height / 2}};
    for (std::size_t i = 0; i < std::size(places); ++i) {
        image.texels[image.index(places[i].first, places[i].second)] = glm::vec4(static_cast<float>(i + 1));
    }
    const SkyLookup lookup = make_sky_lookup({.source = EquirectangularSky{std::move(image)}});
    for (std::size_t i = 0; i < std::size(places); ++i) {
        const double around = 2.0 * std::numbers::pi * ((places[i].first + 0.5) / width - 0.5);
        const double polar = std::numbers::pi * (places[i].second + 0.5) / height;
        const glm::dvec3 direction(std::cos(around) * std::sin(polar), std::cos(polar),
                                   std::sin(around) * std::sin(polar));
        const glm::vec3 found = radiance(lookup, glm::vec3(direction));
        EXPECT_NEAR(found.x, static_cast<float>(i + 1), 0.02F * static_cast<float>(i + 1)) << i;
    }
}

/// What a file brings is cleaned by the reader, with a note; a sky that a caller makes with such values is refused.
TEST(Light, RadianceThatIsNoneIsRefusedWhereNoReaderCleansIt) {
    constexpr float infinite = std::numeric_limits<float>::infinity();
    for (const float wrong : {std::numeric_limits<float>::quiet_NaN(), infinite, -infinite, -1.0F, -1e-30F}) {
        SCOPED_TRACE(wrong);
        const auto one_wrong = [&](int x, int y) { return glm::vec3(x == 3 && y == 2 ? wrong : 1.0F, 1.0F, 1.0F); };
        for (Sky sky : {picture(8, 4, one_wrong), cube_sky(4, 1.0F), constant_sky({1.0F, wrong, 1.0F})}) {
            if (auto* faces = std::get_if<CubeSky>(&sky.source)) {
                faces->faces[2].texels[5].y = wrong;
            }
            try {
                (void)make_sky_lookup(sky);
                ADD_FAILURE() << "taken";
            } catch (const Error& error) {
                EXPECT_TRUE(error.kind() == ErrorKind::bad_input || error.kind() == ErrorKind::usage);
                EXPECT_NE(std::string(error.what()).find("finite"), std::string::npos) << error.what();
            }
        }
    }
}

/// What a format cannot hold is written as the nearest that it can, and counted; EXR's 32 bits hold everything.
TEST(Light, ValuesBeyondAFormatAreClampedAndCounted) {
    const Image image{4,
                      1,
                      {{1e-30F, 0.5F, 1.0F, 1.0F},
                       {65504.0F, 65520.0F, 1e6F, 1.0F},
                       {1e9F, 1e38F, 3e38F, 1.0F},
                       {0.0F, 0.0F, 0.0F, 1.0F}},
                      {1.0F, 1.0F, 1.0F, 1.0F}};
    EXPECT_EQ(encode_image(image, ImageFormat::exr, {}).changed_values, 0U);
    EXPECT_EQ(encode_image(image, ImageFormat::hdr, {}).changed_values, 1U);   // 3e38: RGBE ends at 2^127
    EXPECT_EQ(encode_image(image, ImageFormat::png16, {}).changed_values, 6U); // all above 1
}

} // namespace
} // namespace vkbake::test
