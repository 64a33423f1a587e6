// What a map says of its own error, held against the truth.
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "amount.hpp"
#include "base/random.hpp"
#include "hand_made.hpp"
#include "roof.hpp"
#include "trace/contrasts.hpp"
#include "trace/tracer.hpp"

namespace vkbake {
namespace {

using test::errors_of;
using test::Roof;
using test::roof_side;

/// All of them in a plain build; under sanitizers the first alone, which costs least.
template<typename Value>
std::vector<Value> cases(std::vector<Value> all) {
    all.resize(test::amount<std::size_t>(all.size(), 1));
    return all;
}

TEST(ErrorEstimate, IntervalsHoldTheTruthInEachTenthOfVisibility) {
    const Roof roof;
    for (const std::uint32_t rays : cases<std::uint32_t>({100, 256})) {
        test::VisibilityTally tally;
        for (std::uint64_t seed = 0; seed < test::amount(16U, 1U); ++seed) {
            Settings settings;
            settings.rays = rays;
            settings.seed = seed;
            settings.estimate_error = true;
            tally.add(roof.trace(settings), roof);
        }
        for (std::size_t tenth = 0; tenth < 10 && !test::few_samples; ++tenth) {
            ASSERT_GT(tally.texels[tenth], 500);
            EXPECT_GE(tally.share(tenth), 0.93) << rays << " rays, tenth " << tenth;
            EXPECT_LE(tally.share(tenth), 0.97) << rays << " rays, tenth " << tenth;
        }
    }
}

TEST(ErrorEstimate, TellsTheMapsErrorToATenth) {
    const Roof roof;
    for (const std::uint32_t rays : cases<std::uint32_t>({64, 100, 512})) {
        Settings settings;
        settings.rays = rays;
        settings.estimate_error = true;
        const LightMap map = roof.trace(settings);
        EXPECT_NEAR(map.error->relative_rmse / errors_of(map, roof).relative_rmse, 1.0, 0.1) << rays;
        // A straight border: in theory −¾.
        EXPECT_NEAR(map.error->slope, -0.75, 0.08) << rays;
        settings.estimate_error = false;
        const LightMap plain = roof.trace(settings);
        EXPECT_FALSE(plain.error.has_value());
        EXPECT_TRUE(plain.standard_error.empty());
        for (std::size_t i = 0; i < map.image.texels.size(); ++i) {
            ASSERT_NEAR(map.image.texels[i].x, plain.image.texels[i].x, 1e-6); // the same samples
        }
        EXPECT_EQ(map.statistics.rays, plain.statistics.rays);
        EXPECT_EQ(map.statistics.probed_hits, plain.statistics.probed_hits);
    }
}

TEST(ErrorEstimate, IsNeverBelowWhatNoHitAllows) {
    test::SurfaceMaker maker;
    maker.add_quad({-0.9F, 0, 0.9F}, {0.9F, 0, 0.9F}, {0.9F, 0, -0.9F}, {-0.9F, 0, -0.9F});
    const Surface surface = maker.finish();
    Settings settings;
    settings.rays = 64;
    settings.estimate_error = true;
    const std::vector<test::SamplePoint> points(20, test::point_on(surface, 0, {0.4, 0.3, 0.3}));
    const LightMap map = Tracer(surface, test::white_sky(), settings).trace(test::geometry_image(points, 8));
    for (std::size_t i = 0; i < map.standard_error.size(); ++i) {
        EXPECT_NEAR(interval_95 * static_cast<double>(map.standard_error[i]), i < 20 ? 3.0 / 64.0 : 0.0, 1e-6);
        EXPECT_EQ(map.texel_rays[i], i < 20 ? 64U : 0U);
    }
    EXPECT_EQ(map.error->relative_rmse, 0.0);
}

TEST(TargetError, IsWhatTheMapHas) {
    const Roof roof;
    for (const double target : cases<double>({0.02, 0.01, 0.005})) {
        test::VisibilityTally tally;
        double bias = 0.0;
        constexpr std::uint64_t seeds = 8;
        for (std::uint64_t seed = 0; seed < seeds; ++seed) {
            Settings settings;
            settings.seed = seed;
            settings.target_error = target;
            const LightMap map = roof.trace(settings);
            const test::Errors errors = errors_of(map, roof);
            EXPECT_GT(errors.relative_rmse, 0.9 * target);
            EXPECT_LT(errors.relative_rmse, 1.1 * target);
            EXPECT_TRUE(map.error->target_reached);
            tally.add(map, roof);
            bias += errors.bias / seeds;
        }
        for (std::size_t tenth = 0; tenth < 10; ++tenth) {
            EXPECT_GE(tally.share(tenth), 0.93) << target << ", tenth " << tenth;
        }
        EXPECT_LT(std::abs(bias), 0.1 * target); // by chance less than a hundredth
    }
}

TEST(TargetError, IsNotOvershotWhereErrorsFallUnevenly) {
    // A night of many small lamps: what a few samples tell of them is little, and each doubling brings more than the
    // one before foretold.
    Image night{.width = 64, .height = 32};
    for (std::uint64_t i = 0; i < 64 * 32; ++i) {
        night.texels.emplace_back(glm::vec3(mix64(i) % 32 == 0 ? 20.0F : 0.1F), 1.0F);
    }
    const Sky sky{.source = EquirectangularSky{night}};
    const Roof roof;
    for (const double target : cases<double>({0.3, 0.04})) {
        Settings settings;
        settings.target_error = target;
        settings.sun = Switch::off;
        const LightMap map = Tracer(roof.surface, sky, settings).trace(test::geometry_image(roof.points, roof_side));
        EXPECT_TRUE(map.error->target_reached);
        EXPECT_GT(map.error->relative_rmse, 0.9 * target) << target;
        EXPECT_LE(map.error->relative_rmse, target) << target;
    }
}

/// A filter that takes a known share of every texel's error away, and says so.
class PerfectlyKnownFilter {
public:
    PerfectlyKnownFilter(const Roof& roof, double left) : m_roof(roof), m_left(left) {}

    void operator()(LightMap& map, const std::vector<float>& /*variance*/) {
        ++calls;
        // Were it given what it has filtered, that would err by less than it tells.
        EXPECT_NEAR(errors_of(map, m_roof).relative_rmse, map.error->relative_rmse, 0.1 * map.error->relative_rmse);
        for (std::size_t i = 0; i < m_roof.visible.size(); ++i) {
            const double truth = m_roof.visible[i];
            map.image.texels[i].x =
                static_cast<float>(truth + m_left * (static_cast<double>(map.image.texels[i].x) - truth));
        }
        map.error->relative_rmse *= m_left;
    }

    int calls = 0;

private:
    const Roof& m_roof;
    double m_left;
};

TEST(TargetError, IsOfTheFilteredMapWhereThereIsAFilter) {
    const Roof roof;
    Settings settings;
    settings.target_error = test::amount(0.01, 0.02);
    settings.reuse = Switch::off; // its rays fall faster than the error's square
    const double plain_rays = roof.trace(settings).error->mean_rays;
    for (const double left : {0.5, 0.25, 0.02}) {
        PerfectlyKnownFilter filter(roof, left);
        const LightMap map = roof.trace(settings, std::ref(filter));
        EXPECT_TRUE(map.error->target_reached);
        EXPECT_LT(errors_of(map, roof).relative_rmse, 1.1 * *settings.target_error) << left;
        EXPECT_LT(filter.calls, 6) << left;
        if (left > 0.1) { // else four times the error is asked for first, and does
            EXPECT_GT(errors_of(map, roof).relative_rmse, 0.8 * *settings.target_error) << left;
        }
        EXPECT_LT(map.error->mean_rays, plain_rays * std::max(left, 0.25)) << left; // no error falls faster than 1/rays
    }
    PerfectlyKnownFilter useless(roof, 1.0);
    const LightMap map = roof.trace(settings, std::ref(useless));
    EXPECT_GT(errors_of(map, roof).relative_rmse, 0.8 * *settings.target_error);
    EXPECT_LT(errors_of(map, roof).relative_rmse, 1.1 * *settings.target_error);
}

TEST(TargetError, GivesEachTexelTheFirstSamplesOfItsSequence) {
    const Roof roof;
    Settings settings;
    settings.reuse = Switch::off;
    settings.target_error = test::amount(0.01, 0.05);
    const LightMap map = roof.trace(settings);
    std::vector<std::uint32_t> counts = map.texel_rays;
    std::sort(counts.begin(), counts.end());
    counts.erase(std::unique(counts.begin(), counts.end()), counts.end());
    ASSERT_GE(counts.size(), 2U);
    settings.target_error.reset();
    for (const std::uint32_t count : counts) {
        settings.rays = count;
        const LightMap plain = roof.trace(settings);
        for (std::size_t i = 0; i < map.texel_rays.size(); ++i) {
            if (map.texel_rays[i] == count) {
                ASSERT_NEAR(map.image.texels[i].x, plain.image.texels[i].x, 1e-6) << count << " rays, texel " << i;
            }
        }
    }
}

TEST(TargetError, GivesTheSameBitsOnAnyNumberOfThreads) {
    const Roof roof;
    Settings settings;
    settings.target_error = test::amount(0.015, 0.05);
    settings.threads = 1;
    const LightMap one = roof.trace(settings);
    settings.threads = 0;
    const LightMap all = roof.trace(settings);
    EXPECT_EQ(one.image.texels, all.image.texels);
    EXPECT_EQ(one.standard_error, all.standard_error);
    EXPECT_EQ(one.texel_rays, all.texel_rays);
}

} // namespace
} // namespace vkbake
