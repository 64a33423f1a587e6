// The sky cut in two, and the directions to its brightest places.
#include "trace/sky_peaks.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include "amount.hpp"
#include "base/luminance.hpp"
#include "base/random.hpp"
#include "chi_squared.hpp"
#include "highway_targets.hpp"
#include "sky_looked_up.hpp"
#include "trace/peak_cut.hpp"
#include "trace/peak_directions.hpp"
#include "trace/sky_sum.hpp"

namespace vkbake {
namespace {

/// A dim sky with bright texels where tents meet the picture's borders: at the seam, at a pole, in the middle.
Sky panorama_with_suns() {
    const auto value = [](int x, int y) {
        glm::vec3 result(0.5F + 0.01F * static_cast<float>(x), 0.4F, 0.3F + 0.01F * static_cast<float>(y));
        const bool sun = (x == 0 && y == 5) || (x == 31 && y == 6) || (x == 9 && y == 0) || (x == 20 && y == 7) ||
                         (x == 21 && y == 7);
        return sun ? glm::vec3(900.0F, 700.0F, 300.0F + 20.0F * static_cast<float>(x)) : result;
    };
    return {.source = EquirectangularSky{test::picture(32, 16, value)}, .rotation_degrees = 25.0};
}

/// The same on a cube: at an edge, at a corner, within a face.
Sky cube_with_suns() {
    CubeSky cube;
    for (int face = 0; face < 6; ++face) {
        cube.faces[static_cast<std::size_t>(face)] = test::picture(8, 8, [&](int x, int y) {
            const bool sun =
                (face == 2 && x == 7 && y == 3) || (face == 4 && x == 0 && y == 0) || (face == 0 && x == 3 && y == 2);
            return sun ? glm::vec3(500.0F, 400.0F, 600.0F) : glm::vec3(0.5F, 0.25F, 0.125F * static_cast<float>(face));
        });
    }
    return {.source = cube, .rotation_degrees = -40.0};
}

/// E/π of a surface with that normal, by a sum over polar angle and azimuth.
glm::dvec3 quadrature(const SkyLookup& sky, const glm::dvec3& normal) {
    const int steps = test::amount(300, 60);
    glm::dvec3 sum(0.0);
    for (int i = 0; i < steps; ++i) {
        const double polar = std::numbers::pi * (i + 0.5) / steps;
        for (int j = 0; j < 2 * steps; ++j) {
            const double around = std::numbers::pi * (j + 0.5) / steps;
            const glm::dvec3 direction(std::sin(polar) * std::cos(around), std::cos(polar),
                                       std::sin(polar) * std::sin(around));
            const double cosine = glm::dot(direction, normal);
            if (cosine > 0.0) {
                sum += std::sin(polar) * cosine * glm::dvec3(radiance(sky, glm::vec3(direction)));
            }
        }
    }
    return sum * (std::numbers::pi / (1.0 * steps * steps));
}

struct PeakSample {
    glm::dvec3 direction{0.0};
    glm::dvec3 light{0.0};
    std::size_t peak = 0;
};

/// The samples of these points of the unit square, some blocks of them, put as set_points does.
std::vector<PeakSample> samples_at(const SkyPeaks& peaks, const std::vector<glm::dvec2>& points) {
    std::vector<PeakSample> result;
    RayBlock block;
    PeakSamples samples;
    for (std::size_t first = 0; first + RayBlock::rays <= points.size(); first += RayBlock::rays) {
        for (std::size_t i = 0; i < RayBlock::rays; ++i) {
            auto& [x, y, z] = block.direction[i / RayBlock::lanes];
            const auto number = [](double share) {
                return static_cast<float>((2.0 * std::floor(share * 0x1p24) + 1.0) * 0x1p-24 - 1.0);
            };
            x[i % RayBlock::lanes] = number(points[first + i].x);
            y[i % RayBlock::lanes] = number(points[first + i].y);
        }
        set_peak_directions(peaks, block, samples);
        for (std::size_t i = 0; i < RayBlock::rays; ++i) {
            const std::size_t stratum = i / RayBlock::lanes;
            const std::size_t lane = i % RayBlock::lanes;
            const auto vector = [&](const std::array<RayBlock::LaneRow, 3>& rows) {
                return glm::dvec3(rows[0][lane], rows[1][lane], rows[2][lane]);
            };
            result.push_back(
                {vector(block.direction[stratum]), vector(samples.light[stratum]), samples.peak[stratum][lane]});
        }
    }
    return result;
}

/// At least `count`, in whole blocks.
std::vector<glm::dvec2> random_points(std::uint64_t key, int count) {
    const std::size_t whole = (static_cast<std::size_t>(count) + RayBlock::rays - 1) / RayBlock::rays * RayBlock::rays;
    std::vector<glm::dvec2> points;
    for (std::size_t i = 0; i < whole; ++i) {
        const auto number = [&] { return (static_cast<double>(mix64(++key) >> 11U) + 0.5) * 0x1p-53; };
        const double u = number();
        points.emplace_back(u, number());
    }
    return points;
}

/// What the peaks add to it, by a sequence of low discrepancy (M. Roberts's R2).
glm::dvec3 of_peaks(const SkyPeaks& peaks, const glm::dvec3& normal) {
    const int count = test::amount(1'000'000, 20'000);
    std::vector<glm::dvec2> points;
    glm::dvec2 point(0.5);
    for (int i = 0; i < count; ++i) {
        point = glm::fract(point + glm::dvec2(0.7548776662466927, 0.5698402909980532));
        points.push_back(point);
    }
    glm::dvec3 sum(0.0);
    const std::vector<PeakSample> samples = samples_at(peaks, points);
    for (const PeakSample& sample : samples) {
        EXPECT_NEAR(glm::length(sample.direction), 1.0, 0x1p-21);
        sum += std::max(glm::dot(normal, sample.direction), 0.0) * sample.light;
    }
    return sum / static_cast<double>(samples.size());
}

TEST(SkyPeaks, WithTheRestGiveTheLightOfTheWhole) {
    for (const Sky& sky : {panorama_with_suns(), cube_with_suns()}) {
        const SkyLookup whole = make_sky_lookup(sky);
        SkyLookup rest = whole;
        const PeakCut cut = find_peaks(whole);
        ASSERT_TRUE(cut.worthwhile());
        const SkyPeaks peaks(rest, cut.threshold);
        for (const glm::dvec3& direction :
             {glm::dvec3(0, 1, 0), glm::dvec3(1, 0.2, 0), glm::dvec3(-0.3, 0.4, 1), glm::dvec3(0.5, -1, 0.7)}) {
            const glm::dvec3 normal = glm::normalize(direction);
            const glm::dvec3 expected = quadrature(whole, normal);
            const glm::dvec3 found = quadrature(rest, normal) + of_peaks(peaks, normal);
            for (int channel = 0; channel < 3; ++channel) {
                EXPECT_NEAR(found[channel], expected[channel], test::amount(2e-3, 3e-2) * glm::length(expected));
            }
        }
    }
}

TEST(SkyPeaks, LeaveNothingAboveTheThreshold) {
    SkyLookup sky = make_sky_lookup(panorama_with_suns());
    const PeakCut cut = find_peaks(sky);
    const SkyPeaks peaks(sky, cut.threshold);
    EXPECT_GE(peaks.count(), 5U);
    for (std::uint64_t i = 0; i < 2000; ++i) {
        const auto number = [&](std::uint64_t part) {
            return static_cast<double>(mix64(3 * i + part) >> 11U) * 0x1p-52;
        };
        const glm::dvec3 direction = glm::normalize(glm::dvec3(number(0), number(1), number(2)) - 1.0);
        EXPECT_LE(luminance(glm::dvec3(radiance(sky, glm::vec3(direction)))), cut.threshold * (1.0 + 1e-6));
    }
}

TEST(SkyPeaks, AreFoundBySolidAngleAndLight) {
    // One texel of 64 × 32 is the sun, 10⁵ times as bright as all others, which are 1.
    const int row = 9;
    const Sky sky{.source = EquirectangularSky{test::picture(
                      64, 32, [&](int x, int y) { return glm::vec3(x == 40 && y == row ? 1e5F : 1.0F); })}};
    const PeakCut cut = find_peaks(make_sky_lookup(sky));
    const double texel = 2.0 * std::numbers::pi / 64 * std::numbers::pi / 32 *
                         std::sin(std::numbers::pi * (row + 0.5) / 32) / (4.0 * std::numbers::pi);
    EXPECT_NEAR(cut.solid_share, texel, 0.01 * texel);
    EXPECT_NEAR(cut.light_share, 1e5 * texel / (1e5 * texel + 1.0), 0.01);
    EXPECT_TRUE(cut.worthwhile());
}

TEST(SkyPeaks, AreNotMadeOfSmoothSkies) {
    const auto worthwhile = [](const Sky& sky) { return find_peaks(make_sky_lookup(sky)).worthwhile(); };
    EXPECT_FALSE(worthwhile({.source = ConstantSky{}}));
    EXPECT_FALSE(worthwhile({.source = ClearSky{}}));
    EXPECT_FALSE(
        worthwhile({.source = EquirectangularSky{test::picture(32, 16, [](int, int) { return glm::vec3(3.0F); })}}));
    EXPECT_FALSE(
        worthwhile({.source = EquirectangularSky{test::picture(32, 16, [](int, int) { return glm::vec3(0.0F); })}}));
    EXPECT_FALSE(worthwhile({.source = EquirectangularSky{test::picture(32, 16, [](int, int y) {
                                 return glm::vec3(y < 8 ? 1.0F + 0.2F * static_cast<float>(y) : 0.1F);
                             })}}));
    EXPECT_FALSE(worthwhile({.source = EquirectangularSky{test::picture(8, 4, [](int x, int) { // too coarse
                                 return glm::vec3(x == 3 ? 1000.0F : 1.0F);
                             })}}));
}

TEST(SkyPeaks, SamplesComeAsOftenAsTheirProbabilitySays) {
    // Both χ² tests of two skies: Šidák's correction for four.
    const double level = test::corrected_level(1e-4, 4);
    std::uint64_t key = 0;
    for (const Sky& sky : {panorama_with_suns(), cube_with_suns()}) {
        SkyLookup lookup = make_sky_lookup(sky);
        const SkyPeaks peaks(lookup, find_peaks(lookup).threshold);
        std::vector<double> counts(peaks.count(), 0.0);
        std::array<std::uint32_t, 16> quarters{};
        const std::vector<glm::dvec2> points = random_points(key, test::amount(200'000, 20'000));
        key += 2 * points.size();
        for (const glm::dvec2& point : points) {
            ++quarters[static_cast<std::size_t>(4.0 * point.x) + 4 * static_cast<std::size_t>(4.0 * point.y)];
        }
        for (const PeakSample& sample : samples_at(peaks, points)) {
            counts[sample.peak] += 1.0;
        }
        double statistic = 0.0;
        double whole = 0.0;
        for (std::size_t peak = 0; peak < counts.size(); ++peak) {
            const double expected = peaks.probability(peak) * static_cast<double>(points.size());
            ASSERT_GT(expected, 5.0);
            statistic += (counts[peak] - expected) * (counts[peak] - expected) / expected;
            whole += peaks.probability(peak);
        }
        EXPECT_NEAR(whole, 1.0, 1e-12);
        EXPECT_GT(test::chi_squared_tail(statistic, static_cast<double>(counts.size() - 1)), level);
        EXPECT_GT(test::uniform_p_value(quarters), level); // that the test's own numbers are fair
    }
}

TEST(SkyPeaks, SamplesOfATexelFollowItsTent) {
    const Sky sky{.source = EquirectangularSky{
                      test::picture(32, 16, [](int x, int y) { return glm::vec3(x == 24 && y == 8 ? 1e4F : 0.0F); })}};
    SkyLookup lookup = make_sky_lookup(sky);
    const SkyPeaks peaks(lookup, find_peaks(lookup).threshold);
    ASSERT_EQ(peaks.count(), 1U);
    constexpr int bins = 20;
    const std::vector<glm::dvec2> points = random_points(0, test::amount(100'000, 10'000));
    const auto samples = static_cast<double>(points.size());
    std::array<std::array<double, bins>, 2> counts{};
    for (const PeakSample& sample : samples_at(peaks, points)) {
        const glm::dvec3& d = sample.direction;
        const double x = (std::atan2(d.z, d.x) / (2.0 * std::numbers::pi) + 0.5) * 32.0 - 0.5 - 24.0;
        const double y = std::acos(d.y) / std::numbers::pi * 16.0 - 0.5 - 8.0;
        for (const auto& [axis, t] : {std::pair{0, x}, std::pair{1, y}}) {
            ASSERT_LE(std::abs(t), 1.0 + 1e-4);
            const auto bin = std::clamp(static_cast<int>((t + 1.0) * bins / 2), 0, bins - 1);
            counts[static_cast<std::size_t>(axis)][static_cast<std::size_t>(bin)] += 1.0;
        }
    }
    for (const auto& of_axis : counts) {
        double statistic = 0.0;
        for (int bin = 0; bin < bins; ++bin) {
            const double middle = std::abs((bin + 0.5) * 2.0 / bins - 1.0);
            const double expected = (1.0 - middle) * 2.0 / bins * samples; // of a tent's straight side, exactly
            const double difference = of_axis[static_cast<std::size_t>(bin)] - expected;
            statistic += difference * difference / expected;
        }
        EXPECT_GT(test::chi_squared_tail(statistic, bins - 1), test::corrected_level(1e-4, 2));
    }
}

TEST(SkyPeaks, AreSampledAlikeOnEveryTarget) {
    for (const Sky& sky : {panorama_with_suns(), cube_with_suns()}) {
        SkyLookup lookup = make_sky_lookup(sky);
        const SkyPeaks peaks(lookup, find_peaks(lookup).threshold);
        const std::vector<glm::dvec2> points = random_points(0, 2048);
        std::vector<PeakSample> first;
        test::for_every_target([&] {
            const std::vector<PeakSample> samples = samples_at(peaks, points);
            if (first.empty()) {
                first = samples;
            }
            for (std::size_t i = 0; i < samples.size(); ++i) {
                ASSERT_EQ(samples[i].peak, first[i].peak);
                ASSERT_EQ(samples[i].direction, first[i].direction);
                ASSERT_EQ(samples[i].light, first[i].light);
            }
        });
    }
}

TEST(SkyPeaks, BesideASunLoseNothing) {
    // A sun of 10⁹ and, in its row, texels whose share is far below a step of the choosing number: their light, the
    // sum of powers by what is sampled, is all there.
    const auto value = [](int x, int y) { return glm::vec3(y != 8 ? 0.0F : x == 24 ? 1e9F : 0.5F); };
    SkyLookup lookup = make_sky_lookup({.source = EquirectangularSky{test::picture(32, 16, value)}});
    const SkyPeaks peaks(lookup, 0.25);
    double dim = 0.0;
    double whole = 0.0;
    for (std::size_t peak = 0; peak < peaks.count(); ++peak) {
        EXPECT_GE(peaks.probability(peak), 0x1p-24);
        whole += peaks.probability(peak);
        const double light = peaks.probability(peak) * static_cast<double>(peaks.peaks()[peak].light[0]);
        dim += light < 1.0 ? light : 0.0;
    }
    EXPECT_NEAR(whole, 1.0, 1e-15);
    // 31 texels, their picture wrapping, of an excess of a quarter (what packs below it is left), each by 1 / π.
    EXPECT_NEAR(dim, 31 * 0.25 / std::numbers::pi, 0.01 * dim);
}

} // namespace
} // namespace vkbake
