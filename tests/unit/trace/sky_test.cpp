#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "highway_targets.hpp"
#include "same_bits.hpp"
#include "sky_looked_up.hpp"
#include "vkbake/error.hpp"

namespace vkbake {
namespace {

using test::picture;
using test::pseudo_random;
using test::pseudo_random_direction;
using test::radiances;

glm::vec3 radiance(const Sky& sky, const glm::vec3& direction) {
    return radiances(make_sky_lookup(sky), {direction}).front();
}

TEST(ConstantSky, IsTheSameEverywhere) {
    Sky sky;
    sky.source = ConstantSky{{1.0F, 0.5F, 0.25F}};
    sky.rotation_degrees = 12.0;
    for (std::uint64_t i = 0; i < 20; ++i) {
        EXPECT_EQ(radiance(sky, pseudo_random_direction(i)), glm::vec3(1.0F, 0.5F, 0.25F));
    }
}

/// ISO 15469: L / Lz = f(χ) φ(Z) / (f(Zs) φ(0)), φ(Z) = 1 − e^(−0.32 / cos Z), φ(90°) = 1,
/// f(χ) = 1 + 10 (e^(−3 χ) − e^(−3 π/2)) + 0.45 cos² χ; the sun at Zs = 45°.
TEST(ClearSky, HasTheStandardsValuesAtPointsWorkedOutByHand) {
    // e^(−3π/2) = 0.0089833, e^(−3π/4) = 0.0947801; f(45°) = 1 + 0.857968 + 0.225 = 2.082968;
    // φ(0) = 1 − 0.726149 = 0.273851; f(45°) φ(0) = 0.570423.
    constexpr double zenith = 2.082968 * 0.273851;
    const float h = std::sqrt(0.5F);
    const Sky sky;
    const auto expect = [&](const glm::vec3& direction, double value) {
        const glm::vec3 found = radiance(sky, direction);
        EXPECT_NEAR(found.x, value, 2e-5 * value);
        EXPECT_EQ(found.x, found.y);
        EXPECT_EQ(found.x, found.z);
    };
    expect({0, 1, 0}, 1.0);
    // At the sun: f(0) = 1 + 9.910167 + 0.45 = 11.360167; φ(45°) = 1 − e^(−0.452548) = 0.363994.
    expect({h, h, 0}, 11.360167 * 0.363994 / zenith);
    // Opposite at the same height: χ = 90°, f = 1.
    expect({-h, h, 0}, 0.363994 / zenith);
    // On the horizon φ = 1: under the sun χ = 45°; to its side 90°; opposite 135°, f = 1 + 10 (e^(−9π/4) − …) + 0.225,
    // where e^(−9π/4) = 0.0008514.
    expect({1, 0, 0}, 2.082968 / zenith);
    expect({0, 0, 1}, 1.0 / zenith);
    expect({-1, 0, 0}, (1.225 + 0.008514 - 0.089833) / zenith);
    for (const glm::vec3& below : {glm::vec3(0, -1, 0), glm::vec3(h, -h, 0), glm::vec3(0.9F, -1e-6F, 0.1F)}) {
        EXPECT_EQ(radiance(sky, below), glm::vec3(0.0F));
    }
}

TEST(ClearSky, AgreesWithTheFormulaInLibraryFunctions) {
    for (std::uint64_t i = 0; i < 2000; ++i) {
        glm::vec3 direction = pseudo_random_direction(i);
        direction.y = std::abs(direction.y);
        const glm::dvec3 exact = glm::normalize(glm::dvec3(direction));
        const auto phi = [](double cosine) { return 1.0 - std::exp(-0.32 / cosine); };
        const auto f = [](double chi) {
            return 1.0 + 10.0 * (std::exp(-3.0 * chi) - std::exp(-1.5 * std::numbers::pi)) +
                   0.45 * std::cos(chi) * std::cos(chi);
        };
        const double chi = std::acos(std::min(1.0, (exact.x + exact.y) * std::numbers::sqrt2 / 2.0));
        const double expected = f(chi) * phi(exact.y) / (f(std::numbers::pi / 4.0) * phi(1.0));
        EXPECT_NEAR(radiance({}, direction).y, expected, 1e-6 * expected);
    }
}

TEST(EquirectangularSky, TexelCentresLieWhereTheConventionSays) {
    // v = acos(y) / π down from +Y; u = atan2(z, x) / 2π + ½: the centre column looks along +X, ¾ along +Z.
    Sky sky;
    sky.source = EquirectangularSky{picture(8, 4, [](int x, int y) { return glm::vec3(x, y, 10 * x + y); })};
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 8; ++x) {
            const double theta = (y + 0.5) / 4.0 * std::numbers::pi;
            const double phi = ((x + 0.5) / 8.0 - 0.5) * 2.0 * std::numbers::pi;
            const glm::vec3 direction(std::sin(theta) * std::cos(phi), std::cos(theta),
                                      std::sin(theta) * std::sin(phi));
            const glm::vec3 found = radiance(sky, direction);
            EXPECT_NEAR(found.x, x, 1e-5);
            EXPECT_NEAR(found.y, y, 1e-5);
        }
    }
}

TEST(EquirectangularSky, WrapsAroundTheHorizonAndHoldsAtThePoles) {
    Sky sky;
    sky.source = EquirectangularSky{picture(8, 4, [](int x, int y) { return glm::vec3(x == 0, x == 7, y); })};
    // −X is where the last column meets the first.
    const glm::vec3 seam = radiance(sky, {-1, 0, 0});
    EXPECT_NEAR(seam.x, 0.5F, 1e-6F);
    EXPECT_NEAR(seam.y, 0.5F, 1e-6F);
    EXPECT_NEAR(seam.z, 1.5F, 1e-6F);
    EXPECT_EQ(radiance(sky, {0, 1, 0}).z, 0.0F);
    EXPECT_EQ(radiance(sky, {0, -1, 0}).z, 3.0F);
    EXPECT_EQ(radiance(sky, {1e-5F, 1, 1e-5F}).z, 0.0F);
}

/// Vulkan 1.3, table "Cube map face and coordinate selection", written out for faces of 2 × 2: towards which corner of
/// the cube each face's upper left, upper right, lower left and lower right texel lies.
constexpr std::array<std::array<std::array<int, 3>, 4>, 6> cube_corners{{
    {{{1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {1, -1, -1}}},     // +X: s along −Z, t along −Y
    {{{-1, 1, -1}, {-1, 1, 1}, {-1, -1, -1}, {-1, -1, 1}}}, // −X: +Z, −Y
    {{{-1, 1, -1}, {1, 1, -1}, {-1, 1, 1}, {1, 1, 1}}},     // +Y: +X, +Z
    {{{-1, -1, 1}, {1, -1, 1}, {-1, -1, -1}, {1, -1, -1}}}, // −Y: +X, −Z
    {{{-1, 1, 1}, {1, 1, 1}, {-1, -1, 1}, {1, -1, 1}}},     // +Z: +X, −Y
    {{{1, 1, -1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, -1}}}, // −Z: −X, −Y
}};

TEST(CubeSky, EveryTexelOfEveryFaceLiesWhereVulkanPutsIt) {
    CubeSky cube;
    for (int face = 0; face < 6; ++face) {
        cube.faces[static_cast<std::size_t>(face)] =
            picture(2, 2, [&](int x, int y) { return glm::vec3(face, 2 * y + x, 1); });
    }
    Sky sky;
    sky.source = cube;
    for (std::size_t face = 0; face < 6; ++face) {
        for (std::size_t texel = 0; texel < 4; ++texel) {
            const auto& corner = cube_corners[face][texel];
            glm::vec3 direction(corner[0], corner[1], corner[2]);
            for (int axis = 0; axis < 3; ++axis) {
                direction[axis] *= axis == static_cast<int>(face / 2) ? 1.0F : 0.5F; // the texel's centre
            }
            const glm::vec3 found = radiance(sky, glm::normalize(direction));
            EXPECT_NEAR(found.x, static_cast<float>(face), 1e-5F);
            EXPECT_NEAR(found.y, static_cast<float>(texel), 1e-5F);
        }
    }
}

TEST(CubeSky, TiesBetweenAxesGoToZThenY) {
    EXPECT_EQ(cube_point({1, 1, 1}).face, 4);
    EXPECT_EQ(cube_point({1, 1, 0.5}).face, 2);
    EXPECT_EQ(cube_point({-1, -1, -1}).face, 5);
}

TEST(CubeSky, IsContinuousAcrossEdges) {
    CubeSky cube;
    for (std::uint64_t face = 0; face < 6; ++face) {
        cube.faces[face] = picture(4, 4, [&](int x, int y) {
            return glm::vec3(static_cast<float>(
                pseudo_random(100 * face + 10 * static_cast<std::uint64_t>(y) + static_cast<std::uint64_t>(x))));
        });
    }
    Sky sky;
    sky.source = cube;
    const SkyLookup ready = make_sky_lookup(sky);
    const auto lookup = [&](const glm::vec3& direction) { return radiances(ready, {direction}).front(); };
    for (int major = 0; major < 3; ++major) {
        const int other = (major + 1) % 3;
        const int along = (major + 2) % 3;
        for (const float sign : {1.0F, -1.0F}) {
            for (const float other_sign : {1.0F, -1.0F}) {
                // Not within half a texel of a corner: three faces' cells do not fit together there.
                for (float place = -0.74F; place < 0.75F; place += 0.05F) {
                    glm::vec3 direction(0.0F);
                    direction[along] = place;
                    direction[major] = sign * 1.00001F;
                    direction[other] = other_sign;
                    const float here = lookup(direction).x;
                    direction[major] = sign;
                    direction[other] = other_sign * 1.00001F;
                    EXPECT_NEAR(lookup(direction).x, here, 2e-4F) << major << sign << other_sign << place;
                }
            }
        }
    }
}

/// One bright texel towards +X in each layout.
std::vector<Sky> skies_bright_towards_positive_x() {
    CubeSky cube;
    for (std::size_t face = 0; face < 6; ++face) {
        cube.faces[face] = picture(5, 5, [&](int x, int y) { return glm::vec3(face == 0 && x == 2 && y == 2); });
    }
    Sky with_cube;
    with_cube.source = cube;
    Sky with_panorama;
    with_panorama.source = EquirectangularSky{picture(15, 9, [](int x, int y) { return glm::vec3(x == 7 && y == 4); })};
    return {with_cube, with_panorama};
}

TEST(SkyRotation, TurnsCounterClockwiseSeenFromAbove) {
    for (Sky sky : skies_bright_towards_positive_x()) {
        EXPECT_NEAR(radiance(sky, {1, 0, 0}).x, 1.0F, 1e-6F);
        EXPECT_EQ(radiance(sky, {0, 0, -1}).x, 0.0F);
        sky.rotation_degrees = 90.0;
        EXPECT_NEAR(radiance(sky, {0, 0, -1}).x, 1.0F, 1e-6F);
        EXPECT_EQ(radiance(sky, {1, 0, 0}).x, 0.0F);
        sky.rotation_degrees = -90.0 + 720.0;
        EXPECT_NEAR(radiance(sky, {0, 0, 1}).x, 1.0F, 1e-6F);
        sky.rotation_degrees = 30.0;
        const float angle = std::numbers::pi_v<float> / 6.0F;
        EXPECT_NEAR(radiance(sky, {std::cos(angle), 0, -std::sin(angle)}).x, 1.0F, 1e-5F);
    }
    Sky clear;
    clear.rotation_degrees = 90.0;
    const float h = std::sqrt(0.5F);
    EXPECT_NEAR(radiance(clear, {0, h, -h}).x, radiance(Sky{}, {h, h, 0}).x, 1e-5F);
}

/// Bilinear in double, of a picture without a ring: rows are held, columns wrap.
double bilinear(const Image& image, double x, double y) {
    const double column = std::floor(x);
    const double row = std::floor(y);
    const auto texel = [&](double c, double r) {
        const int wrapped = (static_cast<int>(c) + image.width) % image.width;
        const int held = std::clamp(static_cast<int>(r), 0, image.height - 1);
        return static_cast<double>(image.texels[image.index(wrapped, held)].x);
    };
    const auto along = [&](double r) { return std::lerp(texel(column, r), texel(column + 1.0, r), x - column); };
    return std::lerp(along(row), along(row + 1.0), y - row);
}

TEST(EquirectangularSky, AgreesWithTheConventionInLibraryFunctions) {
    Sky sky;
    const Image image = picture(64, 32, [](int x, int y) {
        return glm::vec3(
            static_cast<float>(pseudo_random(1000 * static_cast<std::uint64_t>(y) + static_cast<std::uint64_t>(x))));
    });
    sky.source = EquirectangularSky{image};
    const SkyLookup ready = make_sky_lookup(sky);
    for (std::uint64_t i = 0; i < 2000; ++i) {
        const glm::vec3 direction = pseudo_random_direction(i);
        const glm::dvec3 exact = glm::normalize(glm::dvec3(direction));
        const double u = std::atan2(exact.z, exact.x) / (2.0 * std::numbers::pi) + 0.5;
        const double v = std::acos(exact.y) / std::numbers::pi;
        // 2⁻²¹ of the width is 3e-5 texel, and texels differ by up to 1.
        EXPECT_NEAR(radiances(ready, {direction}).front().x, bilinear(image, u * 64.0 - 0.5, v * 32.0 - 0.5), 6e-5);
    }
}

TEST(SkySums, WeighEveryRayThatIsOpenAndNoOther) {
    RayBlock block;
    BlockedRays open{};
    std::array<double, RayBlock::strata> weights{};
    std::array<glm::dvec3, RayBlock::lanes> expected{};
    std::vector<Sky> skies(1);
    skies.emplace_back().source = ConstantSky{{1.0F, 2.0F, 4.0F}};
    skies.emplace_back().source =
        EquirectangularSky{picture(9, 5, [](int x, int y) { return glm::vec3(x, y, x * y); })};
    for (const Sky& sky : skies) {
        const SkyLookup ready = make_sky_lookup(sky);
        LaneSums sums;
        expected.fill(glm::dvec3(0.0));
        for (std::uint64_t round = 0; round < 3; ++round) {
            for (std::size_t i = 0; i < RayBlock::strata; ++i) {
                weights[i] = pseudo_random(round * 16 + i);
                open[i] = static_cast<RayBlock::LaneBits>(i == 7 ? 0 : mix64(99 + round * 16 + i));
                for (std::size_t lane = 0; lane < RayBlock::lanes; ++lane) {
                    const glm::vec3 direction = pseudo_random_direction((round * 16 + i) * 16 + lane);
                    for (std::size_t axis = 0; axis < 3; ++axis) {
                        block.direction[i][axis][lane] = direction[static_cast<int>(axis)];
                    }
                    if (((open[i] >> lane) & 1U) != 0) {
                        expected[lane] += weights[i] * glm::dvec3(radiances(ready, {direction}).front());
                    }
                }
            }
            add_sky(ready, block, open, weights, sums);
        }
        for (std::size_t lane = 0; lane < RayBlock::lanes; ++lane) {
            EXPECT_LT(glm::distance(total(ready, sums, lane), expected[lane]), 1e-12 * glm::length(expected[lane]));
        }
    }
}

TEST(SkyLookups, HaveTheSameBitsWithEveryInstructionSet) {
    std::vector<glm::vec3> directions;
    for (std::uint64_t i = 0; i < 1000; ++i) {
        directions.push_back(pseudo_random_direction(i));
    }
    std::vector<Sky> skies = skies_bright_towards_positive_x();
    skies.emplace_back();
    for (Sky& sky : skies) {
        sky.rotation_degrees = 40.0;
        const SkyLookup ready = make_sky_lookup(sky);
        const std::vector<glm::vec3> expected = radiances(ready, directions);
        test::for_every_target([&] { EXPECT_TRUE(test::same_bits(radiances(ready, directions), expected)); });
    }
}

ErrorKind refusal(const Sky& sky) {
    try {
        (void)make_sky_lookup(sky);
    } catch (const Error& error) {
        return error.kind();
    }
    ADD_FAILURE() << "was taken";
    return ErrorKind::bake_failed;
}

TEST(SkyErrors, NameWhatIsWrong) {
    Sky sky;
    sky.intensity = -1.0;
    EXPECT_EQ(refusal(sky), ErrorKind::usage);
    sky.intensity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(refusal(sky), ErrorKind::usage);
    sky.intensity = 1.0;
    sky.rotation_degrees = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(refusal(sky), ErrorKind::usage);
    sky.rotation_degrees = 0.0;
    sky.source = ConstantSky{{1.0F, -1.0F, 1.0F}};
    EXPECT_EQ(refusal(sky), ErrorKind::usage);
    sky.source = EquirectangularSky{};
    EXPECT_EQ(refusal(sky), ErrorKind::bad_input);
    CubeSky cube;
    cube.faces.fill(picture(2, 2, [](int, int) { return glm::vec3(1.0F); }));
    cube.faces[3] = picture(3, 3, [](int, int) { return glm::vec3(1.0F); });
    sky.source = cube;
    EXPECT_EQ(refusal(sky), ErrorKind::bad_input);
    sky.source = EquirectangularSky{picture(2, 1, [](int, int) { return glm::vec3(3e38F); })};
    sky.intensity = 2.0;
    EXPECT_EQ(refusal(sky), ErrorKind::bad_input);
}

} // namespace
} // namespace vkbake
