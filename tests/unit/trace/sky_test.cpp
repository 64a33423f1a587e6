#include "trace/sky_lookup.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "base/random.hpp"
#include "vkbake/error.hpp"

namespace vkbake {
namespace {

Image picture(int width, int height, const std::function<glm::vec3(int, int)>& value) {
    Image image{width, height, {}, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            image.texels.emplace_back(value(x, y), 1.0F);
        }
    }
    return image;
}

glm::vec3 radiance(const Sky& sky, const glm::vec3& direction) {
    return std::visit([&](const auto& lookup) { return lookup(direction); }, make_sky_lookup(sky));
}

double pseudo_random(std::uint64_t key) { return static_cast<double>(mix64(key) >> 11U) * 0x1p-53; }

glm::vec3 pseudo_random_direction(std::uint64_t key) {
    const double z = 2.0 * pseudo_random(2 * key) - 1.0;
    const double phi = 2.0 * std::numbers::pi * pseudo_random(2 * key + 1);
    const double radius = std::sqrt(1.0 - z * z);
    return {radius * std::cos(phi), radius * std::sin(phi), z};
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
        EXPECT_NEAR(radiance({}, direction).y, expected, 2e-6 * expected);
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
    const CubeLookup lookup(cube, SkyTurn{});
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

TEST(SkyImages, AValueThatIsNoNumberStaysBetweenItsTexelsNeighbours) {
    BorderedImage image(4, 4);
    for (int y = -1; y <= 4; ++y) {
        for (int x = -1; x <= 4; ++x) {
            image.at(x, y) = glm::vec3(1.0F);
        }
    }
    image.at(1, 1) = glm::vec3(std::numeric_limits<float>::quiet_NaN(), 1.0F, 1.0F);
    EXPECT_TRUE(std::isnan(image.sample(1.5 / 4.0, 1.5 / 4.0).x));
    EXPECT_TRUE(std::isnan(image.sample(1.9 / 4.0, 1.9 / 4.0).x));
    EXPECT_EQ(image.sample(1.9 / 4.0, 1.9 / 4.0).y, 1.0F);
    // Exactly on the centre of a neighbour its weight is 0.
    EXPECT_EQ(image.sample(0.5 / 4.0, 0.5 / 4.0).x, 1.0F);
    EXPECT_EQ(image.sample(2.5 / 4.0, 1.5 / 4.0).x, 1.0F);
    EXPECT_EQ(image.sample(0.5 / 4.0, 1.5 / 4.0).x, 1.0F);
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
