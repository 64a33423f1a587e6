// The octahedral map that rays look a picture up in.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <variant>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "base/luminance.hpp"
#include "base/random.hpp"
#include "highway_targets.hpp"
#include "same_bits.hpp"
#include "sky_looked_up.hpp"
#include "trace/resample_sky.hpp"

namespace vkbake {
namespace {

using test::picture;
using test::pseudo_random;
using test::pseudo_random_direction;
using test::radiances;

/// Directions to the points (x + ½, y + ½) of a map, row after row.
std::vector<glm::vec3> middles(int side) {
    std::vector<glm::vec3> directions;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            directions.emplace_back(glm::normalize(SkyMap::octahedron_point(side, x + 0.5, y + 0.5)));
        }
    }
    return directions;
}

MapLookup map_of(int side, const SkyMap::FillRow& fill_row) { return {SkyMap(side, fill_row, 0)}; }

MapLookup packed_map_of(int side, const SkyMap::FillRow& fill_row) {
    MapLookup sky = map_of(side, fill_row);
    sky.map.pack();
    return sky;
}

TEST(SkyMap, PointsLieOnTheOctahedronUnfolded) {
    // The middle is up, the middles of the sides are the horizon's ±X and ±Z, all four corners are down.
    EXPECT_EQ(SkyMap::octahedron_point(8, 4, 4), glm::dvec3(0, 1, 0));
    EXPECT_EQ(SkyMap::octahedron_point(8, 8, 4), glm::dvec3(1, 0, 0));
    EXPECT_EQ(SkyMap::octahedron_point(8, 0, 4), glm::dvec3(-1, 0, 0));
    EXPECT_EQ(SkyMap::octahedron_point(8, 4, 8), glm::dvec3(0, 0, 1));
    EXPECT_EQ(SkyMap::octahedron_point(8, 4, 0), glm::dvec3(0, 0, -1));
    for (const double x : {0.0, 8.0}) {
        for (const double y : {0.0, 8.0}) {
            EXPECT_EQ(SkyMap::octahedron_point(8, x, y).y, -1.0);
        }
    }
    EXPECT_EQ(SkyMap::octahedron_point(8, 7, 6), glm::dvec3(0.5, -0.25, 0.25));
}

TEST(SkyMap, EveryTexelIsFoundWithEveryInstructionSet) {
    constexpr int side = 62; // no power of two
    const auto numbers = [](int row, std::span<glm::dvec3> means) {
        for (std::size_t x = 0; x < means.size(); ++x) {
            means[x] = glm::dvec3(static_cast<double>(x), row, 63.0);
        }
    };
    std::vector<glm::vec3> expected;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            expected.emplace_back(x, y, 63);
        }
    }
    for (const SkyLookup& sky : {SkyLookup(map_of(side, numbers)), SkyLookup(packed_map_of(side, numbers))}) {
        test::for_every_target([&] { EXPECT_TRUE(test::same_bits(radiances(sky, middles(side)), expected)); });
        // Axes and zeros of either sign end in a texel that touches the point.
        for (const float zero : {0.0F, -0.0F}) {
            for (const float one : {1.0F, -1.0F}) {
                for (const glm::vec3& axis :
                     {glm::vec3(one, zero, zero), glm::vec3(zero, one, zero), glm::vec3(zero, zero, one)}) {
                    const glm::dvec3 found(radiances(sky, {axis}).front());
                    const glm::dvec3 middle =
                        glm::normalize(SkyMap::octahedron_point(side, found.x + 0.5, found.y + 0.5));
                    EXPECT_GT(glm::dot(middle, glm::dvec3(axis)), std::cos(2.0 * std::numbers::sqrt2 / side));
                }
            }
        }
    }
}

TEST(SkyMap, RoundsNoLightAwayFromARow) {
    constexpr int side = 128;
    std::vector<glm::dvec3> means(side);
    for (std::size_t x = 0; x < means.size(); ++x) { // channels far apart, and a slope of 2 octaves
        const double value = std::exp2(pseudo_random(x) + static_cast<double>(x) / 64.0);
        means[x] = value * glm::dvec3(1.0, 0.3, 0.0007);
    }
    const SkyLookup sky =
        packed_map_of(side, [&](int, std::span<glm::dvec3> row) { std::ranges::copy(means, row.begin()); });
    const std::vector<glm::vec3> found = radiances(sky, middles(side));
    const double greatest_unit = 8.0 / 512.0;
    glm::dvec3 lost(0.0);
    for (std::size_t x = 0; x < means.size(); ++x) {
        lost += means[x] - glm::dvec3(found[x]);
        for (int channel = 0; channel < 3; ++channel) {
            // Half a unit that is left of a texel on either side.
            ASSERT_LE(std::abs(lost[channel]), 0.5 * greatest_unit) << x;
            ASSERT_LE(std::abs(means[x][channel] - static_cast<double>(found[x][channel])), greatest_unit) << x;
        }
    }
}

TEST(SkyMap, HoldsWhatNineBitsHoldToTheBit) {
    // From the greatest float's octave down by 31, and the least normal numbers.
    for (const int octave : {127, 100, 0, -100, -117}) {
        const SkyLookup sky = packed_map_of(16, [&](int row, std::span<glm::dvec3> means) {
            for (std::size_t x = 0; x < means.size(); ++x) {
                const int below = std::min(2 * row, octave + 117);
                means[x] = glm::dvec3(256.0 + static_cast<double>(x), 511.0, 0.0) * std::ldexp(1.0, octave - 8 - below);
            }
        });
        const std::vector<glm::vec3> found = radiances(sky, middles(16));
        for (std::size_t i = 0; i < found.size(); ++i) {
            const int below = std::min(2 * static_cast<int>(i / 16), octave + 117);
            const double unit = std::ldexp(1.0, octave - 8 - below);
            EXPECT_EQ(glm::dvec3(found[i]), glm::dvec3(256.0 + static_cast<double>(i % 16), 511.0, 0.0) * unit);
        }
    }
}

TEST(SkyMap, ATexelDoesNotBlackenThoseBesideItThatAreFarDarker) {
    const SkyLookup sky = packed_map_of(16, [](int, std::span<glm::dvec3> means) {
        std::ranges::fill(means, glm::dvec3(1.0));
        means[7] = glm::dvec3(99'999.0);
    });
    const std::vector<glm::vec3> found = radiances(sky, middles(16));
    for (std::size_t x = 0; x < 16; ++x) {
        EXPECT_NEAR(found[x].x, x == 7 ? 99'999.0F : 1.0F, x == 7 ? 100.0F : 2.0F / 256.0F);
    }
}

/// E/π of planes that face along the axes and against them, by points that lie evenly in an octahedron's faces.
std::vector<glm::dvec3> irradiances(const SkyLookup& sky) {
    constexpr int points = 3 * 128; // three to a texel, where the map was made of two
    static_assert(points * points % RayBlock::rays == 0);
    std::vector<glm::dvec3> sums(6, glm::dvec3(0.0));
    BlockedRays all{};
    all.fill(0xFFFF);
    RadianceRows radiance{};
    for (int first = 0; first < points * points; first += RayBlock::rays) {
        RayBlock block;
        std::array<glm::dvec3, RayBlock::rays> places{};
        for (std::size_t i = 0; i < RayBlock::rays; ++i) {
            const int point = first + static_cast<int>(i);
            const int row = point / points;
            places[i] = SkyMap::octahedron_point(points, point % points + 0.5, row + 0.5);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                block.direction[i / 16][axis][i % 16] =
                    static_cast<float>(glm::normalize(places[i])[static_cast<glm::length_t>(axis)]);
            }
        }
        look_up_sky(sky, block, all, radiance);
        for (std::size_t i = 0; i < RayBlock::rays; ++i) {
            const auto& [red, green, blue] = radiance[i / 16];
            // dω = p · (∂p/∂u × ∂p/∂v) du dv / |p|³, and on each face that product is |x| + |y| + |z| = 1.
            const double distance = glm::length(places[i]);
            const double solid_angle = 4.0 / (points * points) / (distance * distance * distance);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double cosine = places[i][static_cast<glm::length_t>(axis)] / distance;
                sums[2 * axis + (cosine < 0.0 ? 1 : 0)] += solid_angle / std::numbers::pi * std::abs(cosine) *
                                                           glm::dvec3(red[i % 16], green[i % 16], blue[i % 16]);
            }
        }
    }
    return sums;
}

/// Values of Radiance's files, each by itself within three octaves.
glm::vec3 noise(std::uint64_t key) {
    return packed_near(glm::vec3(static_cast<float>(std::exp2(3.0 * pseudo_random(2 * key))),
                                 static_cast<float>(pseudo_random(2 * key + 1)), 0.5F));
}

std::vector<Sky> noisy_skies(bool packable) {
    const auto value = [&](std::uint64_t face, int x, int y) {
        const glm::vec3 some = noise((64 * face + static_cast<std::uint64_t>(y)) * 256 + static_cast<std::uint64_t>(x));
        return packable ? some : some * 1.1F;
    };
    CubeSky cube;
    for (std::size_t face = 0; face < 6; ++face) {
        cube.faces.at(face) = picture(32, 32, [&](int x, int y) { return value(face, x, y); });
    }
    std::vector<Sky> skies(2);
    skies[0].source = EquirectangularSky{picture(128, 64, [&](int x, int y) { return value(7, x, y); })};
    skies[1].source = cube;
    for (Sky& sky : skies) {
        sky.rotation_degrees = 25.0;
    }
    return skies;
}

SkyLookup resampled(const Sky& sky, int threads = 0) {
    SkyLookup lookup = make_sky_lookup(sky);
    resample(lookup, threads);
    return lookup;
}

TEST(ResampledSkies, KeepTheLightThatReachesAPlane) {
    for (const bool packable : {true, false}) {
        for (const Sky& sky : noisy_skies(packable)) {
            const SkyLookup found = resampled(sky);
            ASSERT_EQ(std::get<MapLookup>(found).map.is_packed(), packable);
            const std::vector<glm::dvec3> expected = irradiances(make_sky_lookup(sky));
            const std::vector<glm::dvec3> light = irradiances(found);
            for (std::size_t plane = 0; plane < light.size(); ++plane) {
                for (int channel = 0; channel < 3; ++channel) {
                    EXPECT_NEAR(light[plane][channel], expected[plane][channel], 5e-4 * expected[plane][channel])
                        << plane;
                }
            }
        }
    }
}

/// So large that it is halved: the light of a plane by a sum over the picture's texels.
TEST(ResampledSkies, KeepTheLightOfLargePictures) {
    constexpr int width = 2736; // about the least that is
    constexpr int height = width / 2;
    const glm::dvec3 normal = glm::normalize(glm::dvec3(0.3, 0.5, -0.7));
    glm::dvec3 expected(0.0);
    Sky sky;
    sky.source = EquirectangularSky{picture(width, height, [&](int x, int y) {
        const std::uint64_t some = mix64(static_cast<std::uint64_t>(y) * width + static_cast<std::uint64_t>(x));
        const auto channel = [&](unsigned shift, int odd) {
            return static_cast<float>((some >> shift & 63U) + (odd % 2 == 0 ? 0U : 64U));
        };
        const glm::vec3 value(128.0F + channel(0, y), channel(8, x), channel(16, x / 2 + y / 2)); // as bytes are
        const double polar = (y + 0.5) / height * std::numbers::pi;
        const double around = ((x + 0.5) / width - 0.5) * 2.0 * std::numbers::pi;
        const glm::dvec3 direction(std::sin(polar) * std::cos(around), std::cos(polar),
                                   std::sin(polar) * std::sin(around));
        const double solid_angle = 2.0 * std::numbers::pi * std::numbers::pi / width / height * std::sin(polar);
        expected += std::max(glm::dot(direction, normal), 0.0) * solid_angle / std::numbers::pi * glm::dvec3(value);
        return value;
    })};
    const SkyLookup found = resampled(sky);
    const auto& map = std::get<MapLookup>(found).map;
    ASSERT_TRUE(map.is_packed());
    const int side = map.side();
    const std::vector<glm::vec3> means = radiances(found, middles(side));
    glm::dvec3 light(0.0);
    for (int texel = 0; texel < side * side; ++texel) {
        const int row = texel / side;
        const glm::dvec3 point = SkyMap::octahedron_point(side, texel % side + 0.5, row + 0.5);
        const double distance = glm::length(point);
        const double cosine = std::max(glm::dot(point, normal) / distance, 0.0);
        light += cosine / std::numbers::pi * 4.0 / (side * side) / (distance * distance * distance) *
                 glm::dvec3(means[static_cast<std::size_t>(texel)]);
    }
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(light[channel], expected[channel], 5e-4 * expected[channel]);
    }
}

/// A sky that is linear in the direction has means that are linear too: 1 + a · d for a texel's own mean direction.
TEST(ResampledSkies, ShowWhatThePictureShows) {
    const glm::dvec3 slope(0.5, -0.25, 0.3);
    Sky sky;
    sky.source = EquirectangularSky{picture(256, 128, [&](int x, int y) {
        const double polar = (y + 0.5) / 128.0 * std::numbers::pi;
        const double around = ((x + 0.5) / 256.0 - 0.5) * 2.0 * std::numbers::pi;
        const glm::dvec3 direction(std::sin(polar) * std::cos(around), std::cos(polar),
                                   std::sin(polar) * std::sin(around));
        return glm::vec3(static_cast<float>(1.0 + glm::dot(slope, direction)));
    })};
    const SkyLookup found = resampled(sky);
    for (std::uint64_t i = 0; i < 1000; ++i) {
        const glm::vec3 direction = pseudo_random_direction(i);
        // A texel is no wider than 4.9 / 128, so its middle no farther than 0.7 of that, times the slope's length 0.63;
        // bilinear between texels adds (2π / 256)² / 8.
        EXPECT_NEAR(radiances(found, {direction}).front().x, 1.0 + glm::dot(slope, glm::dvec3(direction)), 0.018);
    }
}

TEST(ResampledSkies, HaveTheSameBitsForAnyNumberOfThreads) {
    const std::vector<glm::vec3> directions = middles(32);
    for (const bool packable : {true, false}) {
        for (const Sky& sky : noisy_skies(packable)) {
            EXPECT_TRUE(
                test::same_bits(radiances(resampled(sky, 1), directions), radiances(resampled(sky), directions)));
        }
    }
}

TEST(ResampledSkies, ArePackedOnlyWhereTheFileIsNoFiner) {
    const auto packed = [](const glm::vec3& one, const glm::vec3& other) {
        Sky sky;
        sky.source = EquirectangularSky{picture(8, 4, [&](int x, int y) { return x == 5 && y == 2 ? other : one; })};
        return std::get<MapLookup>(resampled(sky)).map.is_packed();
    };
    const glm::vec3 one(1.0F);
    for (const glm::vec3& other : {glm::vec3(255.0F, 0.0F, 1.0F), glm::vec3(0.0F), glm::vec3(0x1p29F)}) {
        EXPECT_TRUE(packed(one, other));
    }
    for (const glm::vec3& other : {glm::vec3(257.0F, 0.0F, 0.0F), glm::vec3(128.0F, 0.25F, 0.0F), glm::vec3(1e-40F),
                                   glm::vec3(0x1p31F), glm::vec3(0x1p-31F)}) {
        EXPECT_FALSE(packed(one, other));
    }
}

TEST(ResampledSkies, AddUpWhatEachOfTheirRaysBrings) {
    for (const bool packable : {true, false}) {
        const SkyLookup sky = resampled(noisy_skies(packable).front());
        for (const bool even : {true, false}) {
            RayBlock block;
            BlockedRays open{};
            std::array<double, RayBlock::strata> weights{};
            std::array<glm::dvec3, RayBlock::lanes> expected{};
            for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
                weights[stratum] = even ? 1.0 : pseudo_random(stratum / 3);
                open[stratum] = static_cast<RayBlock::LaneBits>(mix64(stratum));
                for (std::size_t lane = 0; lane < RayBlock::lanes; ++lane) {
                    const glm::vec3 direction = pseudo_random_direction(stratum * 16 + lane);
                    for (std::size_t axis = 0; axis < 3; ++axis) {
                        block.direction[stratum][axis][lane] = direction[static_cast<int>(axis)];
                    }
                    if (((open[stratum] >> lane) & 1U) != 0) {
                        expected[lane] += weights[stratum] * glm::dvec3(radiances(sky, {direction}).front());
                    }
                }
            }
            LaneSums sums;
            LuminanceRows luminances{};
            RadianceRows rows{};
            add_sky(sky, block, open, weights, sums, &luminances);
            look_up_sky(sky, block, open, rows);
            for (std::size_t lane = 0; lane < RayBlock::lanes; ++lane) {
                glm::dvec3 sum(0.0);
                for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
                    const glm::dvec3 ray(rows[stratum][0][lane], rows[stratum][1][lane], rows[stratum][2][lane]);
                    sum += weights[stratum] * ray;
                    if (((open[stratum] >> lane) & 1U) != 0) {
                        EXPECT_NEAR(luminances[stratum][lane], luminance(ray), 1e-6 * luminance(ray));
                    }
                }
                EXPECT_LT(glm::distance(total(sky, sums, lane), expected[lane]), 1e-12 * glm::length(expected[lane]));
                EXPECT_LT(glm::distance(sum, expected[lane]), 1e-12 * glm::length(expected[lane]));
            }
        }
    }
}

} // namespace
} // namespace vkbake
