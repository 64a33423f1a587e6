// Samples whose answer others gave: what they spare, and that the light stays what it is.
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "amount.hpp"
#include "configuration_factors.hpp"
#include "hand_made.hpp"
#include "roof.hpp"
#include "trace/tracer.hpp"
#include "vkbake/error.hpp"

namespace vkbake {
namespace {

using test::Roof;

Settings reusing(std::uint32_t rays) {
    Settings settings;
    settings.rays = rays;
    settings.reuse = Switch::on;
    return settings;
}

/// Of maps of several seeds.
struct Sum {
    double squares = 0.0; ///< of relative errors
    double bias = 0.0;
    double rays = 0.0;

    void add(const LightMap& map, const Roof& roof) {
        const test::Errors errors = test::errors_of(map, roof);
        squares += errors.relative_rmse * errors.relative_rmse;
        bias += errors.bias;
        rays += static_cast<double>(map.statistics.rays);
    }
};

TEST(Reuse, SparesRaysAndNoError) {
    const Roof roof;
    for (const auto& [samples, traced] : {std::pair(256U, 0.7), std::pair(1024U, 0.5)}) {
        if (test::few_samples && samples > 256) {
            continue;
        }
        Sum plain;
        Sum spared;
        const auto seeds = test::amount<std::uint32_t>(4, 1);
        for (std::uint32_t seed = 0; seed < seeds; ++seed) {
            Settings settings = reusing(samples);
            settings.seed = seed;
            const LightMap map = roof.trace(settings);
            EXPECT_EQ(map.statistics.rays + map.statistics.spared_rays, roof.visible.size() * samples);
            spared.add(map, roof);
            settings.reuse = Switch::off;
            plain.add(roof.trace(settings), roof);
        }
        EXPECT_LT(spared.rays, traced * plain.rays) << samples;
        EXPECT_LT(std::sqrt(spared.squares), 1.05 * std::sqrt(plain.squares)) << samples;
        EXPECT_LT(std::abs(spared.bias - plain.bias) / seeds, 0.1 * std::sqrt(plain.squares / seeds)) << samples;
    }
}

TEST(Reuse, LeavesIntervalsThatHoldTheTruth) {
    const Roof roof;
    test::VisibilityTally tally;
    for (std::uint32_t seed = 0; seed < test::amount(16U, 1U); ++seed) {
        Settings settings = reusing(256);
        settings.seed = seed;
        settings.estimate_error = true;
        tally.add(roof.trace(settings), roof);
    }
    for (std::size_t tenth = 0; tenth < 10 && !test::few_samples; ++tenth) {
        EXPECT_GE(tally.share(tenth), 0.93) << tenth;
        EXPECT_LE(tally.share(tenth), 0.97) << tenth;
    }
}

/// Half the side of the hole, over the middle of the floor.
constexpr double hole = 0.03;
constexpr double height = 0.8;

/// A closed room but for a small hole in its ceiling.
Surface room_with_hole() {
    test::SurfaceMaker maker;
    const auto y = static_cast<float>(height);
    maker.add({-3, 0, 1}, {3, 0, 1}, {0, 0, -4}); // the floor, that of all points
    maker.add_quad({-0.9F, 0, -0.9F}, {0.9F, 0, -0.9F}, {0.9F, y, -0.9F}, {-0.9F, y, -0.9F});
    maker.add_quad({0.9F, 0, 0.9F}, {-0.9F, 0, 0.9F}, {-0.9F, y, 0.9F}, {0.9F, y, 0.9F});
    maker.add_quad({-0.9F, 0, 0.9F}, {-0.9F, 0, -0.9F}, {-0.9F, y, -0.9F}, {-0.9F, y, 0.9F});
    maker.add_quad({0.9F, 0, -0.9F}, {0.9F, 0, 0.9F}, {0.9F, y, 0.9F}, {0.9F, y, -0.9F});
    const auto h = static_cast<float>(hole);
    maker.add_quad({-0.9F, y, -0.9F}, {0.9F, y, -0.9F}, {0.9F, y, -h}, {-0.9F, y, -h});
    maker.add_quad({-0.9F, y, h}, {0.9F, y, h}, {0.9F, y, 0.9F}, {-0.9F, y, 0.9F});
    maker.add_quad({-0.9F, y, -h}, {-h, y, -h}, {-h, y, h}, {-0.9F, y, h});
    maker.add_quad({h, y, -h}, {0.9F, y, -h}, {0.9F, y, h}, {h, y, h});
    return maker.finish();
}

TEST(Reuse, DoesNotLoseWhatFewRaysMeet) {
    const Surface room = room_with_hole();
    const int side = test::amount(16, 8);
    std::vector<test::SamplePoint> points;
    double truth = 0.0;
    for (int i = 0; i < side * side; ++i) {
        const double x = -0.4 + 0.8 * (i % side + 0.4) / side;
        const int row = i / side;
        const double z = -0.4 + 0.8 * (row + 0.6) / side;
        points.push_back({glm::vec3(x, 0.0, z), {0, 1, 0}, {0, 1, 0}, 0});
        const auto factor = [&](double at_x, double at_z) {
            return test::element_to_parallel_rectangle(at_x - x, at_z - z, height);
        };
        truth += factor(hole, hole) - factor(-hole, hole) - factor(hole, -hole) + factor(-hole, -hole);
    }
    // The hole is a thousandth of what a texel sees: of its first 64 samples one in fifteen meets it. Where none of
    // a tile's does, it would stay dark for good if nothing contradicted.
    double sum = 0.0;
    const auto seeds = test::amount<std::uint32_t>(16, 1);
    for (std::uint32_t seed = 0; seed < seeds; ++seed) {
        Settings settings = reusing(16384);
        settings.seed = seed;
        const LightMap map = Tracer(room, test::white_sky(), settings).trace(test::geometry_image(points, side));
        for (const glm::vec4& texel : map.image.texels) {
            sum += static_cast<double>(texel.x) / seeds;
        }
        EXPECT_LT(map.statistics.rays, map.statistics.spared_rays);
    }
    if (!test::few_samples) {
        EXPECT_NEAR(sum / truth, 1.0, 0.03);
    }
}

TEST(Reuse, GivesTheSameBitsOnAnyNumberOfThreadsAndWithAnyAccelerator) {
    const Roof roof;
    Settings settings = reusing(256);
    settings.threads = 1;
    const LightMap one = roof.trace(settings);
    settings.threads = 0;
    settings.accelerator = Accelerator::brute;
    const LightMap all = roof.trace(settings);
    EXPECT_EQ(one.image.texels, all.image.texels);
    EXPECT_EQ(one.statistics.rays, all.statistics.rays);
    EXPECT_GT(one.statistics.spared_rays, 0U);
}

TEST(Reuse, TracesAllOfFewSamplesAndTellsNoErrorUnasked) {
    const Roof roof;
    for (const std::uint32_t rays : {1U, 7U, 15U, 64U, 100U}) {
        Settings settings = reusing(rays);
        const LightMap map = roof.trace(settings);
        EXPECT_FALSE(map.error.has_value());
        EXPECT_TRUE(map.standard_error.empty());
        if (rays <= 64) {
            EXPECT_EQ(map.statistics.spared_rays, 0U);
            settings.reuse = Switch::off;
            EXPECT_EQ(map.image.texels, roof.trace(settings).image.texels) << rays;
        }
    }
}

TEST(Reuse, IsUnaskedWhereAnErrorOrATimeIs) {
    Settings settings;
    EXPECT_FALSE(reuses_visibility(settings));
    settings.seconds = 1.0;
    EXPECT_TRUE(reuses_visibility(settings));
    settings.reuse = Switch::off;
    EXPECT_FALSE(reuses_visibility(settings));
    settings.seconds.reset();
    settings.reuse.reset();
    settings.target_error = 0.1;
    EXPECT_TRUE(reuses_visibility(settings));
}

TEST(Reuse, IsRefusedWhereSamplesHaveNoCells) {
    const Roof roof;
    Settings settings = reusing(256);
    settings.sampler = Sampler::uniform;
    EXPECT_THROW((void)roof.trace(settings), Error);
    settings = reusing(256);
    settings.mode = Mode::bent_normal;
    EXPECT_THROW((void)roof.trace(settings), Error);
}

} // namespace
} // namespace vkbake
