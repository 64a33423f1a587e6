// Nothing in the way: what the samplers make of skies that can be integrated by hand.
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "base/random.hpp"
#include "base/sampling.hpp"
#include "hand_made.hpp"
#include "panorama.hpp"
#include "statistics.hpp"
#include "trace/tracer.hpp"

namespace vkbake {
namespace {

std::vector<glm::vec3> normals() {
    std::vector<glm::vec3> all{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (std::uint64_t i = 0; i < 8; ++i) {
        const auto number = [&](std::uint64_t k) {
            return static_cast<float>(static_cast<double>(mix64(3 * i + k + 1) >> 11U) * 0x1p-53 * 2.0 - 1.0);
        };
        all.push_back(glm::normalize(glm::vec3(number(0), number(1), number(2))));
    }
    return all;
}

/// A triangle that looks along `normal`, as far as floats go; its geometric normal is what the texels get.
Surface facing(const glm::vec3& normal) {
    const OrthonormalFrame frame = orthonormal_frame(normal);
    const glm::vec3 a = -0.4F * frame.tangent - 0.3F * frame.bitangent;
    test::SurfaceMaker maker;
    maker.add(a, a + 0.9F * frame.tangent, a + 0.8F * frame.bitangent);
    return maker.finish();
}

LightMap trace_texels(const Surface& surface, const Sky& sky, const Settings& settings, std::size_t count) {
    const std::vector<test::SamplePoint> points(count, test::point_on(surface, 0, {0.4, 0.3, 0.3}));
    return Tracer(surface, sky, settings).trace(test::geometry_image(points, 16));
}

TEST(Furnace, UnobstructedPlaneUnderAWhiteSkyIsOneForAnyNumberOfRays) {
    Sky sky;
    sky.source = ConstantSky{};
    for (const glm::vec3& normal : normals()) {
        const Surface surface = facing(normal);
        for (const std::uint32_t rays : {1U, 7U, 100U, 256U, 1000U}) {
            Settings settings;
            settings.rays = rays;
            const LightMap map = trace_texels(surface, sky, settings, 64);
            for (const glm::vec4& texel : map.image.texels) {
                EXPECT_NEAR(texel.x, 1.0F, 1e-6F);
                EXPECT_NEAR(texel.y, 1.0F, 1e-6F);
                EXPECT_NEAR(texel.z, 1.0F, 1e-6F);
            }
            EXPECT_EQ(map.statistics.rays, 64U * rays);
            EXPECT_EQ(map.statistics.skipped_directions, 0U);
            EXPECT_EQ(map.statistics.occluded_rays, 0U);
        }
    }
}

TEST(Furnace, ThesisSamplerGivesItsOwnSum) {
    double sum = 0.0;
    for (int phi = 0; phi < 32; ++phi) {
        for (int theta = 0; theta < 8; ++theta) {
            sum += std::cos(0.2 * theta) * std::sin(0.2 * theta);
        }
    }
    const double expected = std::numbers::pi / 256.0 * sum;
    ASSERT_NEAR(expected, 0.97353, 5e-6);
    Sky sky;
    sky.source = ConstantSky{};
    Settings settings;
    settings.sampler = Sampler::thesis;
    settings.rays = 3; // it takes its own 256
    for (const glm::vec3& normal : normals()) {
        const LightMap map = trace_texels(facing(normal), sky, settings, 16);
        EXPECT_NEAR(map.image.texels[5].x, expected, 1e-6);
        EXPECT_EQ(map.statistics.rays, 16U * 256U);
    }
}

TEST(Furnace, IntensityAndColourScaleTheResult) {
    Sky sky;
    sky.source = ConstantSky{{0.25F, 2.0F, 1e-30F}};
    sky.intensity = 1e6;
    const LightMap map = trace_texels(facing({0, 1, 0}), sky, {}, 1);
    EXPECT_NEAR(map.image.texels[0].x, 0.25e6F, 1.0F);
    EXPECT_NEAR(map.image.texels[0].y, 2e6F, 1.0F);
    EXPECT_NEAR(map.image.texels[0].z * 1e24F, 1.0F, 1e-5F);
}

/// Where the shading normal leans by α, the directions below the surface have the share (1 − cos α) / 2.
TEST(Furnace, DirectionsBelowTheSurfaceAddNothing) {
    const Surface surface = facing({0, 1, 0});
    Sky sky;
    sky.source = ConstantSky{};
    for (const double angle : {0.1, 0.7, 1.4}) {
        test::SamplePoint point = test::point_on(surface, 0, {0.4, 0.3, 0.3});
        point.shading_normal = {static_cast<float>(std::sin(angle)), static_cast<float>(std::cos(angle)), 0.0F};
        const std::vector<test::SamplePoint> points(512, point);
        const LightMap map = Tracer(surface, sky, {}).trace(test::geometry_image(points, 16));
        std::vector<double> values;
        for (const glm::vec4& texel : map.image.texels) {
            values.push_back(texel.x);
        }
        const test::MeanEstimate found = test::estimate_mean(values);
        EXPECT_NEAR(found.mean, 0.5 * (1.0 + std::cos(angle)), test::allowed_errors * found.standard_error);
        EXPECT_EQ(map.statistics.rays + map.statistics.skipped_directions, 512U * 256U);
        EXPECT_NEAR(static_cast<double>(map.statistics.rays) / (512.0 * 256.0), found.mean, 1e-9);
    }
}

/// What each channel of the linear sky is: a + b · ω.
struct Linear {
    double a;
    glm::dvec3 b;
    [[nodiscard]] double along(const glm::dvec3& direction) const { return a + glm::dot(b, direction); }
};
const std::array<Linear, 3> linear_sky{{{1.0, {0.5, 0.0, 0.0}}, {1.5, {0.0, -1.0, 0.3}}, {2.0, {0.2, 0.4, -1.2}}}};

glm::dvec3 linear_radiance(const glm::dvec3& direction) {
    return {linear_sky[0].along(direction), linear_sky[1].along(direction), linear_sky[2].along(direction)};
}

Sky cube_of(const test::Radiance& radiance) {
    // Vulkan's table: for each face the directions of its centre, of its right border and of its lower border.
    const std::array<std::array<glm::dvec3, 3>, 6> axes{{{{{1, 0, 0}, {0, 0, -1}, {0, -1, 0}}},
                                                         {{{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}}},
                                                         {{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}},
                                                         {{{0, -1, 0}, {1, 0, 0}, {0, 0, -1}}},
                                                         {{{0, 0, 1}, {1, 0, 0}, {0, -1, 0}}},
                                                         {{{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}}}}};
    CubeSky sky;
    for (std::size_t face = 0; face < 6; ++face) {
        sky.faces[face] = {128, 128, {}, {}};
        for (int y = 0; y < 128; ++y) {
            for (int x = 0; x < 128; ++x) {
                const double s = 2.0 * (x + 0.5) / 128.0 - 1.0;
                const double t = 2.0 * (y + 0.5) / 128.0 - 1.0;
                const glm::dvec3 direction = glm::normalize(axes[face][0] + s * axes[face][1] + t * axes[face][2]);
                sky.faces[face].texels.emplace_back(glm::vec3(radiance(direction)), 1.0F);
            }
        }
    }
    Sky named;
    named.source = sky;
    named.name = "cube";
    return named;
}

/// E/π of L = a + b · ω is a + ⅔ b · n. What bilinear filtering adds is at most |b| h² / 8 · |second derivative| an
/// axis: with h = 2π/256 and derivatives up to 1 twice, 1.5e-4 |b| on the panorama (clamping at the poles adds 2e-6);
/// with h = 2/128 and derivatives up to 2 twice, 1.2e-4 |b| on the cube, and as much in the ring beyond a face's
/// border.
TEST(LinearSky, GivesItsClosedFormAtTiltedNormals) {
    for (const Sky& sky : {test::panorama_of(128, linear_radiance), cube_of(linear_radiance)}) {
        for (const glm::vec3& normal : normals()) {
            const LightMap map = trace_texels(facing(normal), sky, {}, 128);
            for (int channel = 0; channel < 3; ++channel) {
                std::vector<double> values;
                for (const glm::vec4& texel : map.image.texels) {
                    values.push_back(texel[channel]);
                }
                const test::MeanEstimate found = test::estimate_mean(values);
                const Linear& linear = linear_sky[static_cast<std::size_t>(channel)];
                const double expected = linear.a + 2.0 / 3.0 * glm::dot(linear.b, glm::dvec3(normal));
                EXPECT_NEAR(found.mean, expected,
                            test::allowed_errors * found.standard_error + 2.5e-4 * glm::length(linear.b))
                    << sky.name << " channel " << channel << " normal " << normal.x << " " << normal.y << " "
                    << normal.z;
            }
        }
    }
}

TEST(BrightSpot, LightsTheFacesThatLookThere) {
    // A cap of half-angle r gives E/π = sin² r · n·d where it is wholly above the surface.
    const double share = std::sin(0.12) * std::sin(0.12);
    Settings settings;
    settings.rays = 1024;
    for (const bool cube : {false, true}) {
        // All octants, with the longest axis so chosen that each face of a cube holds the spot at least once.
        for (int place = 0; place < 8; ++place) {
            glm::dvec3 direction(0.0);
            for (int axis = 0; axis < 3; ++axis) {
                const double length = 0.5 + 0.25 * ((axis + place) % 3);
                direction[axis] = ((place >> axis) & 1) != 0 ? length : -length;
            }
            direction = glm::normalize(direction);
            const test::Radiance spot = [&](const glm::dvec3& towards) {
                return glm::dvec3(glm::dot(towards, direction) > std::cos(0.12) ? 1.0 : 0.0);
            };
            const Sky sky = cube ? cube_of(spot) : test::panorama_of(128, spot);
            for (int face = 0; face < 6; ++face) {
                glm::vec3 normal(0.0F);
                normal[face / 2] = face % 2 == 0 ? 1.0F : -1.0F;
                const LightMap map = trace_texels(facing(normal), sky, settings, 16);
                double mean = 0.0;
                for (const glm::vec4& texel : map.image.texels) {
                    mean += texel.x / 16.0;
                }
                const double cosine = glm::dot(direction, glm::dvec3(normal));
                if (cosine < 0.0) {
                    EXPECT_EQ(mean, 0.0) << "place " << place << " face " << face;
                } else {
                    // The spot's rim is good to a texel of 1.4° at 7°: 2 · 0.2 / 2; on average far better.
                    EXPECT_NEAR(mean / (share * cosine), 1.0, 0.1) << "place " << place << " face " << face;
                }
            }
        }
    }
}

} // namespace
} // namespace vkbake
