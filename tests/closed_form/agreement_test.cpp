// The same bytes from every accelerator and number of threads.
#include <array>
#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "amount.hpp"
#include "base/random.hpp"
#include "hand_made.hpp"
#include "highway_targets.hpp"
#include "same_bits.hpp"
#include "trace/tracer.hpp"

namespace vkbake {
namespace {

float number(std::uint64_t key) {
    return static_cast<float>(static_cast<double>(mix64(key) >> 11U) * 0x1p-53 * 2.0 - 1.0);
}

glm::vec3 place(std::uint64_t key) { return {number(3 * key), number(3 * key + 1), number(3 * key + 2)}; }

/// Triangles of all sizes, some of them upon each other, in a heap.
Surface heap() {
    test::SurfaceMaker maker;
    for (std::uint64_t i = 0; i < test::amount(120U, 32U); ++i) {
        const glm::vec3 middle = 0.7F * place(4 * i);
        const float size = i % 5 == 0 ? 0.3F : 0.08F;
        maker.add(middle + size * place(4 * i + 1), middle + size * place(4 * i + 2), middle + size * place(4 * i + 3));
    }
    maker.add_box({-0.2F, -0.2F, -0.2F}, {0.1F, 0.2F, 0.3F}, false);
    maker.add_box({0.1F, -0.2F, -0.2F}, {0.4F, 0.2F, 0.3F}, false); // shares a face
    return maker.finish();
}

GeometryImage texels_of(const Surface& surface) {
    std::vector<test::SamplePoint> points;
    for (std::uint32_t triangle = 0; triangle < surface.triangle_count(); ++triangle) {
        for (const glm::dvec3& weights : {glm::dvec3(1.0, 1.0, 1.0) / 3.0, glm::dvec3(0.5, 0.5, 0.0)}) {
            test::SamplePoint point = test::point_on(surface, triangle, weights);
            point.shading_normal = glm::normalize(point.geometric_normal + 0.4F * place(7777 + triangle));
            points.push_back(point);
        }
    }
    GeometryImage image = test::geometry_image(points, 24);
    // Holes, so that chunks and tiles do not fall together.
    for (std::size_t i = 0; i < image.texel_count(); i += 7) {
        image.triangle[i] = GeometryImage::empty;
    }
    return image;
}

void expect_same(const LightMap& found, const LightMap& expected) {
    ASSERT_EQ(found.image.texels.size(), expected.image.texels.size());
    EXPECT_TRUE(test::same_bits(found.image.texels, expected.image.texels));
    EXPECT_EQ(found.image.coverage, expected.image.coverage);
    EXPECT_EQ(found.statistics.covered_texels, expected.statistics.covered_texels);
    EXPECT_EQ(found.statistics.rays, expected.statistics.rays);
    EXPECT_EQ(found.statistics.occluded_rays, expected.statistics.occluded_rays);
    EXPECT_EQ(found.statistics.skipped_directions, expected.statistics.skipped_directions);
    EXPECT_EQ(found.statistics.probed_hits, expected.statistics.probed_hits);
    EXPECT_EQ(found.statistics.back_side_hits, expected.statistics.back_side_hits);
}

TEST(Agreement, AcceleratorsAndThreadCountsGiveTheSameBytes) {
    const Surface surface = heap();
    const GeometryImage geometry = texels_of(surface);
    for (const Mode mode : {Mode::irradiance, Mode::ao}) {
        for (const Sampler sampler : {Sampler::cosine, Sampler::thesis}) {
            Settings settings;
            settings.mode = mode;
            settings.sampler = sampler;
            settings.rays = 50;
            if (mode == Mode::ao) {
                settings.ao_distance = 0.2;
                settings.ao_falloff = sampler == Sampler::thesis ? Falloff::square : Falloff::none;
            }
            settings.accelerator = Accelerator::brute;
            settings.threads = 1;
            const LightMap oracle = Tracer(surface, {}, settings).trace(geometry);
            EXPECT_GT(oracle.statistics.occluded_rays, 0U);
            EXPECT_LT(oracle.statistics.occluded_rays, oracle.statistics.rays);
            EXPECT_GT(oracle.statistics.back_side_hits, 0U);
            EXPECT_GT(oracle.statistics.skipped_directions, 0U);
            for (const Accelerator accelerator : {Accelerator::brute, Accelerator::clusters, Accelerator::bvh}) {
                for (const int threads : {1, 2}) {
                    SCOPED_TRACE(testing::Message() << static_cast<int>(accelerator) << ", threads " << threads);
                    settings.accelerator = accelerator;
                    settings.threads = threads;
                    expect_same(Tracer(surface, {}, settings).trace(geometry), oracle);
                }
            }
        }
    }
}

TEST(Agreement, InstructionSetsGiveTheSameBytes) {
    const Surface surface = heap();
    const GeometryImage geometry = texels_of(surface);
    for (const std::uint32_t rays : {50U, 256U}) {
        Settings settings;
        settings.rays = rays;
        settings.threads = 1;
        const Tracer tracer(surface, {}, settings);
        const LightMap expected = tracer.trace(geometry);
        test::for_every_target([&] { expect_same(tracer.trace(geometry), expected); });
    }
}

/// Which texels are traced together hangs on which there are; what one gets does not.
TEST(Agreement, ATexelsLightDoesNotDependOnTheOthers) {
    const Surface surface = heap();
    const GeometryImage geometry = texels_of(surface);
    Settings settings;
    settings.rays = 70;
    const Tracer tracer(surface, {}, settings);
    const LightMap expected = tracer.trace(geometry);
    for (std::size_t keep = 2; keep <= 5; ++keep) {
        GeometryImage some = geometry;
        for (std::size_t i = 0; i < some.texel_count(); ++i) {
            if (i % keep != 0) {
                some.triangle[i] = GeometryImage::empty;
            }
        }
        const LightMap found = tracer.trace(some);
        for (std::size_t i = 0; i < some.texel_count(); i += keep) {
            ASSERT_EQ(found.image.texels[i], expected.image.texels[i]) << i;
        }
    }
}

/// The key of a texel is its place and the seed: numbers of triangles are not in it.
TEST(Agreement, OrderOfTrianglesDoesNotMatterAndTheSeedDoes) {
    const Surface surface = heap();
    const GeometryImage geometry = texels_of(surface);
    const auto count = static_cast<std::uint32_t>(surface.triangle_count());
    test::SurfaceMaker maker;
    for (std::uint32_t triangle = count; triangle-- > 0;) {
        maker.add(surface.positions[3 * triangle], surface.positions[3 * triangle + 1],
                  surface.positions[3 * triangle + 2]);
    }
    const Surface reversed = maker.finish();
    GeometryImage renamed = geometry;
    for (std::uint32_t& triangle : renamed.triangle) {
        triangle = triangle == GeometryImage::empty ? triangle : count - 1 - triangle;
    }
    Settings settings;
    settings.rays = 64;
    const LightMap expected = Tracer(surface, {}, settings).trace(geometry);
    expect_same(Tracer(reversed, {}, settings).trace(renamed), expected);
    settings.seed = 1;
    EXPECT_NE(Tracer(surface, {}, settings).trace(geometry).image.texels, expected.image.texels);
}

} // namespace
} // namespace vkbake
