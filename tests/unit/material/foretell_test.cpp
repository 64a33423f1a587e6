// What inspect foretells of tracing, held against tracing.
#include "foretell.hpp"

#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

#include "amount.hpp"
#include "geometry_image/reference.hpp"
#include "host_bake.hpp"
#include "vkbake/vkbake.hpp"

namespace vkbake {
namespace {

/// Boxes on a floor, in whose corners it is dark.
Scene boxes() {
    Scene scene = test::scene_of(test::floor_of(3.0F));
    test::add_object(scene, "low", test::box_of({-0.5F, 0.0F, -0.5F}, {0.5F, 0.6F, 0.5F}), {-1.0, 0.0, 0.5});
    test::add_object(scene, "high", test::box_of({-0.3F, 0.0F, -0.3F}, {0.3F, 2.0F, 0.3F}), {0.8, 0.0, -0.6});
    return scene;
}

struct Truth {
    std::uint64_t covered = 0;
    double rays = 0.0;
    double error = 0.0;
};

Truth baked(const Scene& scene, const Settings& settings) {
    const test::HostBake bake = test::bake_on_host(scene, {}, settings);
    const LightMap& map = bake.maps.at(0);
    return {map.statistics.covered_texels, static_cast<double>(map.statistics.rays), map.error->relative_rmse};
}

ForetoldTrace foretold(const Scene& scene, const Settings& settings, std::uint64_t covered) {
    const Surface surface = make_surface(scene);
    return foretell_trace(scene, surface, make_atlas(scene, surface, settings), settings, {}, covered);
}

TEST(Foretell, ComesWithinAFactorOfOneAndAHalf) {
    const Scene scene = boxes();
    Settings by_rays;
    by_rays.size = test::amount(256, 128); // four times the texels that are traced to foretell it
    by_rays.rays = 64;
    by_rays.estimate_error = true;
    Settings by_error = by_rays;
    by_error.target_error = 0.02; // finer than what it traces for
    for (const Settings& settings : {by_rays, by_error}) {
        const Truth truth = baked(scene, settings);
        ASSERT_GT(truth.covered, test::amount(30000U, 5000U));
        const ForetoldTrace trace = foretold(scene, settings, truth.covered);
        EXPECT_GT(trace.rays, truth.rays / 1.5);
        EXPECT_LT(trace.rays, truth.rays * 1.5);
        ASSERT_TRUE(trace.error.has_value());
        EXPECT_GT(*trace.error, truth.error / 1.5);
        EXPECT_LT(*trace.error, truth.error * 1.5);
        EXPECT_GT(trace.seconds, 0.0);
    }
}

TEST(Foretell, ManyRaysAreForetoldFromFewer) {
    const Scene scene = boxes();
    Settings settings;
    settings.size = 64;
    settings.rays = 1U << 20U;
    const ForetoldTrace trace = foretold(scene, settings, 2000);
    EXPECT_NEAR(trace.rays, 2000.0 * settings.rays, 0.1 * 2000.0 * settings.rays) << "hardly any is below the plane";
    EXPECT_LT(trace.error.value(), 2e-4);
}

TEST(Foretell, WithoutAnErrorItTellsNone) {
    Settings settings;
    settings.size = 64;
    settings.rays = 16;
    settings.mode = Mode::bent_normal;
    EXPECT_FALSE(foretold(boxes(), settings, 2000).error.has_value());
}

TEST(Foretell, InspectSaysIt) {
    Settings settings;
    settings.size = 64;
    settings.target_error = 0.05;
    settings.bounces = 2;
    const Inspection inspection = inspect(boxes(), settings);
    EXPECT_NEAR(inspection.error.value(), 0.05, 0.01);
    EXPECT_GT(inspection.rays, inspection.covered_texels * 2 * settings.bounce_rays);
    settings.memory_limit = 1;
    EXPECT_EQ(inspect(boxes(), settings).trace_seconds, 0.0);
}

} // namespace
} // namespace vkbake
