// Where it is open, on average: mode bent-normal where that is known.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "bent_light.hpp"
#include "configuration_factors.hpp"
#include "hand_made.hpp"
#include "host_bake.hpp"
#include "trace/tracer.hpp"
#include "vkbake/error.hpp"

namespace vkbake {
namespace {

Settings bent_settings(std::uint32_t rays) {
    Settings settings;
    settings.mode = Mode::bent_normal;
    settings.rays = rays;
    return settings;
}

/// Of a point on a floor that faces +Y, at the origin.
glm::dvec3 bent_normal(test::SurfaceMaker maker, const Settings& settings) {
    const std::uint32_t floor =
        maker.add_quad({-0.001F, 0, 0.001F}, {0.001F, 0, 0.001F}, {0.001F, 0, -0.001F}, {-0.001F, 0, -0.001F});
    const Surface surface = maker.finish();
    const std::vector<test::SamplePoint> points{test::point_on(surface, floor, {0.48, 0.04, 0.48})};
    return Tracer(surface, test::white_sky(), settings).trace(test::geometry_image(points, 1)).image.texels[0];
}

TEST(BentNormal, ASunOfOneTexelIsInTheSkysCoefficients) {
    constexpr int width = 1024;
    constexpr int row = 160;
    constexpr int column = 300;
    constexpr double pi = std::numbers::pi;
    EquirectangularSky picture;
    picture.image = {.width = width, .height = width / 2, .texels = {}, .coverage = {}};
    picture.image.texels.assign(std::size_t{width} * width / 2, glm::vec4(0.0F, 0.0F, 0.0F, 1.0F));
    picture.image.texels[picture.image.index(column, row)] = {1e5F, 2e5F, 0.0F, 1.0F};
    Sky sky;
    sky.source = picture;
    // Its bilinear tent has the light of a whole texel: (2π / width) · (π / height) · sin.
    const double polar = pi * (row + 0.5) / (width / 2.0);
    const double azimuth = 2.0 * pi * ((column + 0.5) / width - 0.5);
    const double flux = 1e5 * (2.0 * pi / width) * (2.0 * pi / width) * std::sin(polar);
    const glm::dvec3 towards(std::sin(polar) * std::cos(azimuth), std::cos(polar), std::sin(polar) * std::sin(azimuth));
    const std::array<glm::vec3, 9> found = sky_coefficients(sky);
    const auto expect_coefficient = [&](std::size_t which, double basis) {
        EXPECT_NEAR(found[which].r, flux * basis, 0.01 * flux) << which;
        EXPECT_NEAR(found[which].g, 2.0 * flux * basis, 0.02 * flux) << which;
        EXPECT_EQ(found[which].b, 0.0F) << which;
    };
    expect_coefficient(0, std::sqrt(1.0 / (4.0 * pi)));
    const double first = std::sqrt(3.0 / (4.0 * pi));
    expect_coefficient(1, first * towards.y);
    expect_coefficient(2, first * towards.z);
    expect_coefficient(3, first * towards.x);
    expect_coefficient(4, std::sqrt(15.0 / (4.0 * pi)) * towards.x * towards.y);
    expect_coefficient(6, std::sqrt(5.0 / (16.0 * pi)) * (3.0 * towards.z * towards.z - 1.0));
}

TEST(BentNormal, OfAnOpenPlaneIsItsNormal) {
    const glm::dvec3 found = bent_normal({}, bent_settings(1024));
    EXPECT_NEAR(glm::length(found), 1.0, 1e-6);
    EXPECT_LT(glm::length(found - glm::dvec3(0, 1, 0)), 2e-3);
}

TEST(BentNormal, BesideAWallLeansAway) {
    // Of the lune x > 0, y > 0: ∫ x y = 2/3, ∫ y y = π/3; half of the light.
    test::SurfaceMaker maker;
    maker.add_quad({-0.002F, 0, -1}, {-0.002F, 1, -1}, {-0.002F, 1, 1}, {-0.002F, 0, 1});
    const glm::dvec3 found = bent_normal(maker, bent_settings(4096));
    EXPECT_NEAR(glm::length(found), 0.5, 0.01);
    EXPECT_LT(glm::length(glm::normalize(found) - glm::normalize(glm::dvec3(2.0, std::numbers::pi, 0.0))), 0.02);
    Settings limited = bent_settings(4096);
    limited.ao_distance = 0.0012; // nearer than the wall
    EXPECT_NEAR(glm::length(bent_normal(maker, limited)), 1.0, 1e-6);
}

TEST(BentNormal, InAPitIsUpAndShort) {
    // A square shaft, closed below and 1 deep, 0.5 wide: the mouth's configuration factor from its middle.
    test::SurfaceMaker maker;
    constexpr float half = 0.25F;
    constexpr float deep = 0.9F;
    maker.add_quad({-half, -half, -half}, {-half, deep, -half}, {-half, deep, half}, {-half, -half, half});
    maker.add_quad({half, -half, -half}, {half, deep, -half}, {half, deep, half}, {half, -half, half});
    maker.add_quad({-half, -half, -half}, {half, -half, -half}, {half, deep, -half}, {-half, deep, -half});
    maker.add_quad({-half, -half, half}, {half, -half, half}, {half, deep, half}, {-half, deep, half});
    const glm::dvec3 found = bent_normal(maker, bent_settings(4096));
    const double expected = 4.0 * test::element_to_parallel_rectangle(0.25, 0.25, 0.9);
    EXPECT_NEAR(glm::length(found), expected, 0.03 * expected);
    EXPECT_LT(glm::length(glm::normalize(found) - glm::dvec3(0, 1, 0)), 0.01);
}

TEST(BentNormal, WhereNothingIsOpenIsNothing) {
    test::SurfaceMaker maker;
    maker.add_box({-0.5F, -0.5F, -0.5F}, {0.5F, 0.5F, 0.5F}, true);
    EXPECT_EQ(bent_normal(maker, bent_settings(64)), glm::dvec3(0.0));
}

TEST(BentNormal, IsAsLongAsVisibility) {
    Settings settings = bent_settings(16);
    settings.size = 32;
    const test::HostBake bent = test::bake_on_host(test::furnished_scene(), test::white_sky(), settings);
    settings.mode = Mode::ao;
    const test::HostBake open = test::bake_on_host(test::furnished_scene(), test::white_sky(), settings);
    std::size_t compared = 0;
    for (std::size_t texel = 0; texel < open.maps[0].image.texels.size(); ++texel) {
        EXPECT_NEAR(glm::length(glm::vec3(bent.maps[0].image.texels[texel])), open.maps[0].image.texels[texel].x,
                    1e-6F);
        compared += open.maps[0].image.coverage[texel] != 0.0F ? 1 : 0;
    }
    EXPECT_GT(compared, 100U);
}

TEST(BentNormal, HasNoErrorEstimate) {
    Settings settings = bent_settings(64);
    settings.estimate_error = true;
    EXPECT_THROW((void)bent_normal({}, settings), Error);
}

} // namespace
} // namespace vkbake
