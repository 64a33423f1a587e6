#include "trace/tracer.hpp"

#include <functional>
#include <limits>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "closed_form/hand_made.hpp"
#include "vkbake/error.hpp"

namespace vkbake {
namespace {

Surface floor_surface() {
    test::SurfaceMaker maker;
    maker.add_quad({-0.9F, 0, 0.9F}, {0.9F, 0, 0.9F}, {0.9F, 0, -0.9F}, {-0.9F, 0, -0.9F});
    return maker.finish();
}

GeometryImage floor_texels(const Surface& surface, std::size_t count, int width) {
    return test::geometry_image(std::vector(count, test::point_on(surface, 0, {0.4, 0.3, 0.3})), width);
}

Sky constant_sky(float radiance) {
    Sky sky;
    sky.source = ConstantSky{glm::vec3(radiance)};
    return sky;
}

TEST(Tracer, EmptyTexelsAreZeroAndBlackOnesStayCovered) {
    const Surface surface = floor_surface();
    const LightMap map = Tracer(surface, constant_sky(0.0F), {}).trace(floor_texels(surface, 21, 8));
    ASSERT_EQ(map.image.width, 8);
    ASSERT_EQ(map.image.height, 3);
    ASSERT_EQ(map.image.texels.size(), 24U);
    ASSERT_EQ(map.image.coverage.size(), 24U);
    for (std::size_t i = 0; i < 24; ++i) {
        EXPECT_EQ(map.image.texels[i], i < 21 ? glm::vec4(0, 0, 0, 1) : glm::vec4(0.0F)) << i;
        EXPECT_EQ(map.image.coverage[i], i < 21 ? 1.0F : 0.0F) << i;
    }
    EXPECT_EQ(map.statistics.covered_texels, 21U);
    EXPECT_EQ(map.statistics.rays, 21U * 256U);
    EXPECT_TRUE(map.name.empty());
}

TEST(Tracer, TexelsOfATriangleWithoutAreaGoByTheirShadingNormal) {
    test::SurfaceMaker maker;
    maker.add({0, 0, 0}, {0.5F, 0, 0}, {0.2F, 0, 0});
    const Surface surface = maker.finish();
    const std::vector<test::SamplePoint> points(4, {{0.1F, 0, 0}, {0, 1, 0}, {0, 0, 0}, 0});
    const LightMap map = Tracer(surface, constant_sky(1.0F), {}).trace(test::geometry_image(points, 2));
    EXPECT_EQ(map.image.texels[0], glm::vec4(1.0F));
    EXPECT_EQ(map.statistics.skipped_directions, 0U);
}

/// Wherever a texel's rays start, its own triangle lets them pass: here from well below it, through its middle.
TEST(Tracer, NoRayMeetsTheTriangleThatItLeaves) {
    const glm::vec3 up(0, 1, 0);
    test::SurfaceMaker maker;
    maker.add({-0.5F, 0, 0.5F}, {0.5F, 0, 0.5F}, {0, 0, -0.5F});
    const Surface surface = maker.finish();
    const std::vector<test::SamplePoint> points(4, {{0, -0x1p-10F, 0.1F}, up, up, 0});
    EXPECT_EQ(Tracer(surface, constant_sky(1.0F), {}).trace(test::geometry_image(points, 2)).statistics.occluded_rays,
              0U);
}

TEST(Tracer, MapsWithoutATexelAreMaps) {
    const Surface surface = floor_surface();
    const Tracer tracer(surface, constant_sky(1.0F), {});
    int reports = 0;
    const LightMap map = tracer.trace(floor_texels(surface, 0, 4), [&](double share, std::uint64_t, double) {
        EXPECT_EQ(share, 1.0);
        return ++reports > 0;
    });
    EXPECT_TRUE(map.image.texels.empty());
    EXPECT_EQ(reports, 1);
    GeometryImage holes = floor_texels(surface, 16, 4);
    holes.triangle.assign(16, GeometryImage::empty);
    EXPECT_EQ(tracer.trace(holes).image.texels, std::vector<glm::vec4>(16, glm::vec4(0.0F)));
}

TEST(Tracer, ReportsFromTheCallersThreadUpToTheEnd) {
    const Surface surface = floor_surface();
    const auto caller = std::this_thread::get_id();
    double last = 0.0;
    std::uint64_t rays = 0;
    const LightMap map = Tracer(surface, constant_sky(1.0F), {})
                             .trace(floor_texels(surface, 5000, 64), [&](double share, std::uint64_t so_far, double) {
                                 EXPECT_EQ(std::this_thread::get_id(), caller);
                                 EXPECT_GE(share, last);
                                 EXPECT_GE(so_far, rays);
                                 last = share;
                                 rays = so_far;
                                 return true;
                             });
    EXPECT_EQ(last, 1.0);
    EXPECT_EQ(rays, map.statistics.rays);
    EXPECT_EQ(rays, 5000U * 256U);
}

ErrorKind refusal(const std::function<void()>& work) {
    try {
        work();
    } catch (const Error& error) {
        return error.kind();
    }
    ADD_FAILURE() << "was taken";
    return ErrorKind::bake_failed;
}

TEST(Tracer, StopsWhenAsked) {
    const Surface surface = floor_surface();
    const Tracer tracer(surface, constant_sky(1.0F), {});
    const GeometryImage geometry = floor_texels(surface, 5000, 64);
    int reports = 0;
    EXPECT_EQ(
        refusal([&] { (void)tracer.trace(geometry, [&](double, std::uint64_t, double) { return ++reports < 2; }); }),
        ErrorKind::interrupted);
    EXPECT_EQ(reports, 2);
}

TEST(Tracer, RefusesSettingsThatContradictEachOther) {
    const Surface surface = floor_surface();
    const auto expect_usage = [&](const std::function<void(Settings&)>& change) {
        Settings settings;
        change(settings);
        EXPECT_EQ(refusal([&] { const Tracer tracer(surface, {}, settings); }), ErrorKind::usage);
    };
    expect_usage([](Settings& s) { s.rays = 0; });
    expect_usage([](Settings& s) { s.ao_distance = 1.0; });
    for (const double distance : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
        expect_usage([&](Settings& s) {
            s.mode = Mode::ao;
            s.ao_distance = distance;
        });
    }
    expect_usage([](Settings& s) { s.triangle_test = TriangleTest::moller_trumbore; });
    expect_usage([](Settings& s) { s.cluster_splits = 65; });
    expect_usage([](Settings& s) { s.threads = -1; });
}

TEST(Tracer, RefusesAGeometryImageOfAnotherSurface) {
    const Surface surface = floor_surface();
    const Tracer tracer(surface, constant_sky(1.0F), {});
    GeometryImage geometry = floor_texels(surface, 16, 4);
    geometry.triangle[3] = 2;
    EXPECT_EQ(refusal([&] { (void)tracer.trace(geometry); }), ErrorKind::bake_failed);
    geometry = floor_texels(surface, 16, 4);
    geometry.position = ZeroedArray<glm::vec3>(15);
    EXPECT_EQ(refusal([&] { (void)tracer.trace(geometry); }), ErrorKind::bake_failed);
}

} // namespace
} // namespace vkbake
