// Where light comes from, and what renderers make of it.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "amount.hpp"
#include "base/sampling.hpp"
#include "hand_made.hpp"
#include "host_bake.hpp"
#include "lamp_scenes.hpp"
#include "lit_on_host.hpp"
#include "panorama.hpp"
#include "same_bits.hpp"
#include "trace/directional_map.hpp"
#include "vkbake_light.h"

namespace vkbake {
namespace {

using test::pi;

constexpr double band_0 = 0.28209479177387814; // √(1 / 4π)
constexpr double band_1 = 0.48860251190291992; // √(3 / 4π)

/// ∫ L and ∫ L ω of the light above a surface, from its four coefficients.
struct LightAbove {
    double all = 0.0;
    glm::dvec3 vector{0.0};
};

LightAbove light_of(const std::vector<Image>& maps, std::size_t texel, int channel = 1) {
    const auto coefficient = [&](std::size_t i) { return static_cast<double>(maps.at(i).texels.at(texel)[channel]); };
    return {coefficient(0) / band_0, glm::dvec3(coefficient(3), coefficient(1), coefficient(2)) / band_1};
}

/// a + b · ω, as a picture.
Sky sloping_sky(double a, const glm::dvec3& b) {
    return test::panorama_of(128, [&](const glm::dvec3& direction) { return glm::dvec3(a + glm::dot(b, direction)); });
}

/// One texel in the middle of a square that faces `normal`, and what a test adds.
class LonePlace {
public:
    explicit LonePlace(const glm::vec3& normal) : m_normal(glm::normalize(normal)) {
        const OrthonormalFrame frame = orthonormal_frame(m_normal);
        const auto corner = [&](float x, float y) { return 0.01F * (x * frame.tangent + y * frame.bitangent); };
        m_maker.add_quad(corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1));
    }
    test::SurfaceMaker& maker() { return m_maker; }
    [[nodiscard]] std::vector<Image> trace(const Sky& sky, const Settings& settings,
                                           const std::vector<Lamp>& lamps = {}) {
        const Surface surface = m_maker.finish();
        const Tracer tracer(surface, sky, settings, lamps);
        // Off the diagonal, on which no triangle lies alone.
        const std::vector<test::SamplePoint> points{test::point_on(surface, 0, {0.45, 0.1, 0.45})};
        return trace_directional(tracer, test::geometry_image(points, 1), nullptr, nullptr).coefficients;
    }

private:
    glm::vec3 m_normal;
    test::SurfaceMaker m_maker;
};

Settings directional_rays(std::uint32_t rays) {
    Settings settings;
    settings.directional = Switch::on;
    settings.directional_rays = rays;
    return settings;
}

TEST(Directional, ALinearSkyIsExact) {
    // Over a hemisphere about n, ∫ ω = π n and ∫ ω ωᵀ = 2π/3.
    constexpr double a = 1.25;
    const glm::dvec3 b(0.5, -0.25, 0.75);
    for (const glm::dvec3 normal : {glm::dvec3(0, 1, 0), glm::dvec3(0, 0, -1), glm::dvec3(0.6, 0.64, -0.48)}) {
        const LightAbove light =
            light_of(LonePlace(glm::vec3(normal)).trace(sloping_sky(a, b), directional_rays(4096)), 0);
        EXPECT_NEAR(light.all, 2.0 * pi * a + pi * glm::dot(b, normal), 2e-3);
        EXPECT_LT(glm::length(light.vector - (pi * a * normal + 2.0 * pi / 3.0 * b)), 2e-3);
    }
}

TEST(Directional, BehindAWallTheSkyIsAQuarter) {
    // A wall of the plane x = 0 leaves a lune: ∫ ω = π/2 towards +X and +Y each.
    LonePlace place({0, 1, 0});
    place.maker().add_quad({-1e-4F, -1, -1}, {-1e-4F, 1, -1}, {-1e-4F, 1, 1}, {-1e-4F, -1, 1});
    const LightAbove light = light_of(place.trace(test::white_sky(), directional_rays(1024)), 0);
    EXPECT_NEAR(light.all, pi, 0.02);
    EXPECT_LT(glm::length(light.vector - glm::dvec3(pi / 2.0, pi / 2.0, 0.0)), 0.02);
}

TEST(Directional, LampsShineFromWhereTheyAre) {
    const glm::dvec3 way = glm::normalize(glm::dvec3(-0.3, -0.8, 0.4));
    for (const double size : {0.0, 2.0}) { // hard and soft
        const LightAbove light = light_of(
            LonePlace({0, 1, 0}).trace(test::black_sky(), directional_rays(256), {test::sun(way, 3.0, size)}), 0);
        EXPECT_NEAR(light.all, 3.0, 1e-3);
        EXPECT_LT(glm::length(light.vector + 3.0 * way), 2e-3);
    }
    // Grazing, and half below the horizon: what is above counts, whatever its angle.
    const LightAbove low = light_of(
        LonePlace({0, 1, 0}).trace(test::black_sky(), directional_rays(1024), {test::sun({-1, 0, 0}, 3.0, 10.0)}), 0);
    EXPECT_NEAR(low.all, 1.5, 0.02);
    EXPECT_NEAR(low.vector.x, 1.5, 0.02);
}

TEST(Directional, TheSkysSunShinesFromWhereItIs) {
    Sky sky = sloping_sky(0.0, glm::dvec3(0.0));
    Image& image = std::get<EquirectangularSky>(sky.source).image;
    constexpr int row = 40;
    constexpr int column = 150;
    image.texels[image.index(column, row)] = glm::vec4(glm::vec3(1e5F), 1.0F);
    const double polar = (row + 0.5) / image.height * pi;
    const double azimuth = (2.0 * (column + 0.5) / image.width - 1.0) * pi;
    const glm::dvec3 towards(std::cos(azimuth) * std::sin(polar), std::cos(polar), std::sin(azimuth) * std::sin(polar));
    // A tent of the texel's volume; across it sin θ is all but linear.
    const double solid_angle = (pi / image.height) * (2.0 * pi / image.width) * std::sin(polar);
    const LightAbove light = light_of(LonePlace({0, 1, 0}).trace(sky, directional_rays(256)), 0);
    EXPECT_NEAR(light.all, 1e5 * solid_angle, 1e-3 * 1e5 * solid_angle);
    EXPECT_LT(glm::length(light.vector / light.all - towards), 1e-3);
}

TEST(Directional, BouncesAreInIt) {
    // A closed room that emits e and reflects ρ: the same radiance from all sides.
    Scene room = test::scene_of(test::box_of({-2, 0, -1}, {2, 2, 1}));
    auto& indices = room.meshes[0].primitives[0].indices;
    for (std::size_t first = 0; first < indices.size(); first += 3) {
        std::swap(indices[first + 1], indices[first + 2]);
    }
    test::paint(room, 0, {.base_color = {0.5F, 0.8F, 0.0F, 1.0F}, .emissive = {1.0F, 0.25F, 3.0F}});
    Settings settings = directional_rays(test::amount(256U, 64U));
    settings.size = 32;
    settings.rays = 16;
    settings.bounces = 3;
    settings.bounce_rays = 16;
    const Bake bake = test::bounced(room, settings);
    const LightMap& map = bake.light_maps.at(0);
    ASSERT_EQ(map.directional.size(), 4U);
    const GeometryImage geometry = reference_geometry_image(bake.surface, bake.atlas, 0);
    std::size_t covered = 0;
    for (std::size_t texel = 0; texel < geometry.texel_count(); ++texel) {
        if (map.image.coverage[texel] == 0.0F) {
            EXPECT_EQ(map.directional[0].texels[texel], glm::vec4(0.0F));
            continue;
        }
        ++covered;
        for (int channel = 0; channel < 3; ++channel) {
            const double radiance = double{map.image.texels[texel][channel]};
            const LightAbove light = light_of(map.directional, texel, channel);
            ASSERT_NEAR(light.all, 2.0 * pi * radiance, 1e-5 * radiance);
            if (!test::few_samples) {
                ASSERT_LT(glm::length(light.vector - pi * radiance * glm::dvec3(geometry.shading_normal[texel])),
                          0.1 * radiance);
            }
        }
        ASSERT_EQ(map.directional[3].texels[texel].a, 1.0F);
    }
    EXPECT_GT(covered, 300U);
    EXPECT_GT(map.statistics.directional_rays, 0U);
}

TEST(Directional, OnThreadsTheBitsAreTheSameAndTheLightMapsAlways) {
    Scene scene = test::furnished_scene();
    Settings settings = directional_rays(16);
    settings.size = 32;
    settings.rays = 16;
    settings.bounces = 1;
    settings.bounce_rays = 16;
    settings.threads = 1;
    const Bake one = test::bounced(scene, settings, glm::vec3(1.0F, 0.5F, 0.25F));
    settings.threads = 0;
    settings.accelerator = Accelerator::brute;
    const Bake all = test::bounced(scene, settings, glm::vec3(1.0F, 0.5F, 0.25F));
    settings.directional = Switch::off;
    const Bake without = test::bounced(scene, settings, glm::vec3(1.0F, 0.5F, 0.25F));
    for (std::size_t page = 0; page < one.light_maps.size(); ++page) {
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_TRUE(test::same_bits(one.light_maps[page].directional.at(i).texels,
                                        all.light_maps[page].directional.at(i).texels));
        }
        EXPECT_TRUE(test::same_bits(one.light_maps[page].image.texels, without.light_maps[page].image.texels));
        EXPECT_TRUE(without.light_maps[page].directional.empty());
    }
}

/// What the maps hold of a distribution of light, and the light that a tilted normal gets of it: E/π.
class Distribution {
public:
    void add(const glm::dvec3& direction, double radiance) { m_rays.emplace_back(direction, radiance); }

    [[nodiscard]] std::array<glm::vec3, 9> coefficients() const {
        std::array<glm::dvec3, 9> sums{};
        for (const auto& [d, radiance] : m_rays) {
            const std::array<double, 9> basis{band_0,
                                              band_1 * d.y,
                                              band_1 * d.z,
                                              band_1 * d.x,
                                              1.0925484305920792 * d.x * d.y,
                                              1.0925484305920792 * d.y * d.z,
                                              0.31539156525252005 * (3.0 * d.z * d.z - 1.0),
                                              1.0925484305920792 * d.x * d.z,
                                              0.54627421529603959 * (d.x * d.x - d.y * d.y)};
            for (std::size_t i = 0; i < sums.size(); ++i) {
                sums[i] += radiance * basis[i];
            }
        }
        return {sums[0], sums[1], sums[2], sums[3], sums[4], sums[5], sums[6], sums[7], sums[8]};
    }
    [[nodiscard]] double light(const glm::dvec3& normal) const {
        double sum = 0.0;
        for (const auto& [direction, radiance] : m_rays) {
            sum += radiance * std::max(glm::dot(direction, normal), 0.0);
        }
        return sum / pi;
    }

private:
    std::vector<std::pair<glm::dvec3, double>> m_rays;
};

/// Even over the sphere as far as `seen` says.
template<typename Seen>
Distribution even_light(const Seen& seen) {
    constexpr int count = 200;
    Distribution light;
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j < 2 * count; ++j) {
            const double y = (2.0 * i + 1.0) / count - 1.0;
            const double azimuth = (j + 0.5) / count * pi;
            const double across = std::sqrt(1.0 - y * y);
            const glm::dvec3 direction(across * std::cos(azimuth), y, across * std::sin(azimuth));
            if (seen(direction)) {
                light.add(direction, 2.0 * pi / (count * count));
            }
        }
    }
    return light;
}

double directional(const Distribution& light, const glm::dvec3& surface, const glm::dvec3& normal) {
    const auto sh = light.coefficients();
    return double{shared::vkbake_directional_light(glm::vec3(static_cast<float>(light.light(surface))), sh[0], sh[1],
                                                   sh[2], sh[3], glm::vec3(surface), glm::vec3(normal))
                      .g};
}

const glm::dvec3 upwards(0, 1, 0);

glm::dvec3 tilted_by(double degrees) { return {std::sin(degrees * pi / 180.0), std::cos(degrees * pi / 180.0), 0.0}; }

TEST(DirectionalLight, IsExactUnderAnEvenHemisphereAndSphere) {
    const Distribution hemisphere = even_light([](const glm::dvec3& d) { return d.y > 0.0; });
    const Distribution sphere = even_light([](const glm::dvec3& /*d*/) { return true; });
    for (const double degrees : {-80.0, -30.0, 0.0, 10.0, 45.0, 90.0}) {
        const double expected = 0.5 + 0.5 * std::cos(degrees * pi / 180.0);
        EXPECT_NEAR(directional(hemisphere, upwards, tilted_by(degrees)), expected, 2e-4) << degrees;
        EXPECT_NEAR(directional(sphere, upwards, tilted_by(degrees)), 1.0, 2e-4) << degrees;
    }
}

TEST(DirectionalLight, LeavesFlatSurfacesAsTheLightMapHasThem) {
    Distribution light;
    light.add(glm::normalize(glm::dvec3(0.9, 0.2, -0.3)), 7.0);
    light.add(glm::normalize(glm::dvec3(-0.1, 0.6, 0.5)), 2.0);
    EXPECT_EQ(directional(light, upwards, upwards), double{static_cast<float>(light.light(upwards))});
    EXPECT_EQ(directional(Distribution(), upwards, tilted_by(30.0)), 0.0); // black stays black
}

TEST(DirectionalLight, FollowsLightFromOneSide) {
    // Tilts of 30° towards the light and away, as multiples of what the surface gets: what docs/light.md says.
    const Distribution lune = even_light([](const glm::dvec3& d) { return d.y > 0.0 && d.x > 0.0; });
    Distribution near_lamp;
    near_lamp.add(tilted_by(30.0), 5.0);
    Distribution far_lamp;
    far_lamp.add(tilted_by(60.0), 5.0);
    const auto error = [&](const Distribution& light, double degrees) {
        const double expected = light.light(tilted_by(degrees));
        return std::abs(directional(light, upwards, tilted_by(degrees)) - expected) / light.light(upwards);
    };
    for (const double degrees : {-30.0, -15.0, 15.0, 30.0}) {
        EXPECT_LT(error(lune, degrees), 0.05) << degrees;
        EXPECT_LT(error(near_lamp, degrees), 0.05) << degrees;
    }
    EXPECT_LT(error(far_lamp, 30.0), 0.02);
    EXPECT_LT(error(far_lamp, -30.0), 0.4);
    EXPECT_GE(directional(far_lamp, upwards, tilted_by(-120.0)), 0.0); // its lobe has no negative part
}

TEST(DirectionalLight, TheBandsAloneGiveWhatTheyHold) {
    const Distribution lune = even_light([](const glm::dvec3& d) { return d.y > 0.0 && d.x > 0.0; });
    const auto sh = lune.coefficients();
    for (const double degrees : {-170.0, -30.0, 0.0, 45.0, 100.0}) {
        // U/4π + 2/4π V · n of the lune: 1/4 + (cos + sin) / 4.
        const double expected =
            std::max(0.25 + 0.25 * (std::cos(degrees * pi / 180.0) + std::sin(degrees * pi / 180.0)), 0.0);
        EXPECT_NEAR(double{shared::vkbake_irradiance_sh1(sh[0], sh[1], sh[2], sh[3], glm::vec3(tilted_by(degrees))).g},
                    expected, 2e-4);
    }
}

} // namespace
} // namespace vkbake
