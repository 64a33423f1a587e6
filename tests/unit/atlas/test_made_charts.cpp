#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "amount.hpp"
#include "atlas/make_atlas.hpp"
#include "support.hpp"
#include "surface/make_surface.hpp"
#include "vkbake/error.hpp"

namespace vkbake {
namespace {

using namespace test; // NOLINT(google-build-using-namespace): the helpers of these tests

Settings made(int size) { return made_by(ChartMaker::polypack, size); }

void expect_good(const Surface& surface, const Atlas& atlas, const Settings& settings) {
    expect_sound(surface, atlas);
    expect_gutter(atlas, settings.gutter);
    expect_one_density(surface, atlas);
}

Scene cube() {
    Scene scene = empty_scene();
    add_box(scene.meshes[0].primitives[0], glm::vec3(0.0F), glm::vec3(2.0F));
    return scene;
}

TEST(MadeCharts, no_triangles_give_no_page) {
    const Scene scene = empty_scene();
    const Atlas atlas = make_atlas(scene, make_surface(scene), made(64));
    EXPECT_TRUE(atlas.pages.empty());
    EXPECT_EQ(atlas.chart_count, 0U);
}

// Six equal squares lie in three columns: each may take ⌊(S + g) / 3⌋ − g texels, and a box e long takes ⌈e + ½⌉.
TEST(MadeCharts, a_cube_gives_six_squares_of_the_greatest_density) {
    const Scene scene = cube();
    const Surface surface = make_surface(scene);
    for (const int size : {16, 64, 100, 256, amount(1024, 128)}) {
        for (const int gutter : {0, 1, 2, 5}) {
            Settings settings = made(size);
            settings.gutter = gutter;
            const Atlas atlas = make_atlas(scene, surface, settings);
            ASSERT_EQ(atlas.pages.size(), 1U);
            EXPECT_EQ(atlas.pages[0].name, "lightmap");
            EXPECT_EQ(atlas.chart_count, 6U);
            const int square = (size + gutter) / 3 - gutter;
            const double side = square - 0.5; // texels for 2 m
            if (side >= 1.0) {
                EXPECT_LE(atlas.density, side / 2.0);
                EXPECT_GT(atlas.density, side / 2.0 * (1.0 - 0x1p-11)) << size << ", " << gutter;
            }
            expect_good(surface, atlas, settings);
        }
    }
}

TEST(MadeCharts, a_given_density_holds) {
    const Scene scene = cube();
    const Surface surface = make_surface(scene);
    Settings settings = made(128);
    settings.density = 7.25;
    const Atlas atlas = make_atlas(scene, surface, settings);
    EXPECT_EQ(atlas.density, 7.25);
    expect_good(surface, atlas, settings);
}

// Seen from the front u runs right and v down, so a picture drawn into the map is not mirrored on the surface.
TEST(MadeCharts, nothing_is_mirrored_and_up_is_up) {
    Scene scene = empty_scene();
    // A wall that faces +Z, 3 wide and 1 high: lies as it is or turned by 90°, but never mirrored.
    add_quad(scene.meshes[0].primitives[0], {0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0});
    Settings settings = made(64);
    settings.layout = Layout::object;
    const Surface surface = make_surface(scene);
    const Atlas atlas = make_atlas(scene, surface, settings);
    EXPECT_EQ(atlas.pages[0].name, surface.objects[0].name);
    EXPECT_EQ(atlas.chart_count, 1U);
    expect_one_density(surface, atlas);
    // A mirrored instance of it must not be mirrored in the map either.
    scene.instances[0].linear[0][0] = -1.0;
    const Surface mirrored = make_surface(scene);
    expect_one_density(mirrored, make_atlas(scene, mirrored, settings));
}

TEST(MadeCharts, triangles_that_touch_in_a_corner_alone_are_two_charts) {
    Scene scene = empty_scene();
    Primitive& primitive = scene.meshes[0].primitives[0];
    add_quad(primitive, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
    add_quad(primitive, {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0});
    const Surface surface = make_surface(scene);
    EXPECT_EQ(make_atlas(scene, surface, made(64)).chart_count, 2U);
}

TEST(MadeCharts, a_slope_of_45_degrees_is_one_chart) {
    Scene scene = empty_scene();
    Primitive& primitive = scene.meshes[0].primitives[0];
    for (int i = 0; i < 16; ++i) {
        const float low = 0.1F * static_cast<float>(i);
        const float high = 0.1F * static_cast<float>(i + 1);
        add_quad(primitive, {low, low, 0.3F}, {low, low, -0.7F}, {high, high, -0.7F}, {high, high, 0.3F});
    }
    for (glm::vec3& position : primitive.positions) {
        std::swap(position.x, position.z); // also turns the front
    }
    const Surface surface = make_surface(scene);
    const Atlas atlas = make_atlas(scene, surface, made(128));
    EXPECT_EQ(atlas.chart_count, 1U);
    expect_sound(surface, atlas);
}

/// A spiral stair without steps: two and a half turns of a ramp about the Y axis, all of it facing up.
Scene spiral() {
    Scene scene = empty_scene();
    constexpr int steps = 60;
    constexpr double turns = 2.5;
    const auto at = [&](int i, double radius) {
        const double angle = turns * 2.0 * std::numbers::pi * i / steps;
        return glm::vec3(radius * std::cos(angle), 0.02 * i, -radius * std::sin(angle));
    };
    for (int i = 0; i < steps; ++i) {
        add_quad(scene.meshes[0].primitives[0], at(i, 0.5), at(i, 1.0), at(i + 1, 1.0), at(i + 1, 0.5));
    }
    return scene;
}

TEST(MadeCharts, a_spiral_is_cut_where_it_would_overlap_itself) {
    const Scene scene = spiral();
    const Surface surface = make_surface(scene);
    for (const glm::vec3& normal : surface.geometric_normals) {
        ASSERT_GT(normal.y, 0.9F);
    }
    const Settings settings = made(200);
    const Atlas atlas = make_atlas(scene, surface, settings);
    EXPECT_GE(atlas.chart_count, 3U); // two and a half turns
    EXPECT_LE(atlas.chart_count, 6U);
    expect_good(surface, atlas, settings);
}

TEST(MadeCharts, triangles_that_lie_on_each_other_are_charts_of_their_own) {
    Scene scene = empty_scene();
    Primitive& primitive = scene.meshes[0].primitives[0];
    for (int i = 0; i < 5; ++i) {
        add_quad(primitive, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
    }
    const Surface surface = make_surface(scene);
    const Settings settings = made(64);
    const Atlas atlas = make_atlas(scene, surface, settings);
    EXPECT_EQ(atlas.chart_count, 5U);
    expect_good(surface, atlas, settings);
}

TEST(MadeCharts, triangles_without_area_never_fail) {
    Scene scene = cube();
    Primitive& primitive = scene.meshes[0].primitives[0];
    add_triangle(primitive, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}); // on an edge of the cube
    add_triangle(primitive, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}); // a point, at its corner
    add_triangle(primitive, {5, 5, 5}, {5, 5, 5}, {6, 6, 6}); // a line, apart
    const Surface surface = make_surface(scene);
    const Settings settings = made(64);
    const Atlas atlas = make_atlas(scene, surface, settings);
    EXPECT_EQ(atlas.chart_count, 6U);
    expect_good(surface, atlas, settings);

    Scene points = empty_scene();
    add_triangle(points.meshes[0].primitives[0], {5, 5, 5}, {5, 5, 5}, {6, 6, 6});
    const Surface point_surface = make_surface(points);
    const Atlas point_atlas = make_atlas(points, point_surface, settings);
    EXPECT_EQ(point_atlas.chart_count, 1U);
    expect_sound(point_surface, point_atlas);
}

TEST(MadeCharts, rough_ground_holds_every_promise) {
    for (const int gutter : {0, 2, 3}) {
        Scene scene = empty_scene();
        add_rough_ground(scene.meshes[0].primitives[0], 16, 3.0F);
        const Surface surface = make_surface(scene);
        Settings settings = made(250);
        settings.gutter = gutter;
        const Atlas atlas = make_atlas(scene, surface, settings);
        EXPECT_GT(atlas.chart_count, 20U);
        expect_good(surface, atlas, settings);
    }
}

// A corner of one quad lies on the long edge of another, at a slant: rounding pushes it across at some sizes.
TEST(MadeCharts, rounding_makes_no_overlap_at_t_junctions) {
    Scene scene = empty_scene();
    Primitive& primitive = scene.meshes[0].primitives[0];
    for (int i = 0; i < 24; ++i) {
        const auto along = [&](int numerator, float side) {
            const float t = static_cast<float>(numerator) / 24.0F;
            return glm::vec3(3.0F * t - 0.37F * side, 0.71F * t + side, 0.0F);
        };
        add_triangle(primitive, along(i, 0.0F), along(i + 1, 0.0F), along(i, 0.2F));
        add_triangle(primitive, along(i + 1, 0.0F), along(i + 1, 0.2F), along(i, 0.2F));
    }
    add_triangle(primitive, {0.0F, 0.0F, 0.0F}, {1.5F, -1.0F, 0.0F}, {3.0F, 0.71F, 0.0F});
    const Surface surface = make_surface(scene);
    for (int size = 40; size < 60; ++size) {
        const Atlas atlas = make_atlas(scene, surface, made(size));
        expect_good(surface, atlas, made(size));
    }
}

TEST(MadeCharts, needles_hold_every_promise) {
    Scene scene = empty_scene();
    Primitive& primitive = scene.meshes[0].primitives[0];
    for (int i = 0; i < 300; ++i) {
        const auto rim = [](int k) {
            const double angle = 2.0 * std::numbers::pi * k / 300.0;
            return glm::vec3(std::cos(angle), std::sin(angle), 0.0);
        };
        add_triangle(primitive, glm::vec3(0.0F), rim(i), rim(i + 1));
    }
    add_triangle(primitive, {2.0F, 0.0F, 0.0F}, {3.0F, 1.0F, 0.0F}, {2.5F, 0.50000006F, 0.0F});
    const Surface surface = make_surface(scene);
    const Atlas atlas = make_atlas(scene, surface, made(amount(4000, 1000)));
    expect_sound(surface, atlas);
    expect_one_density(surface, atlas);
}

TEST(MadeCharts, the_order_of_triangles_changes_nothing) {
    Scene scene = spiral();
    add_rough_ground(scene.meshes[0].primitives[0], 12, 2.0F);
    add_box(scene.meshes[0].primitives[0], {20, 0, 0}, {21, 2, 3});
    const Surface surface = make_surface(scene);
    const Settings settings = made(256);
    const Atlas atlas = make_atlas(scene, surface, settings);
    for (const std::uint32_t seed : {1U, 2U, 3U}) {
        Scene shuffled = scene;
        shuffle_triangles(shuffled.meshes[0].primitives[0], seed);
        const Surface other_surface = make_surface(shuffled);
        const Atlas other = make_atlas(shuffled, other_surface, settings);
        ASSERT_EQ(other.density, atlas.density);
        ASSERT_EQ(other.chart_count, atlas.chart_count);
        for (std::size_t rank = 0; rank < surface.canonical_order.size(); ++rank) {
            const std::size_t a = surface.canonical_order[rank];
            const std::size_t b = other_surface.canonical_order[rank];
            for (std::size_t c = 0; c < 3; ++c) {
                ASSERT_EQ(surface.positions[3 * a + c], other_surface.positions[3 * b + c]);
                ASSERT_EQ(atlas.uvs[3 * a + c], other.uvs[3 * b + c]);
            }
            ASSERT_EQ(atlas.chart[a], other.chart[b]);
            ASSERT_EQ(atlas.page[a], other.page[b]);
        }
    }
}

TEST(MadeCharts, instances_get_places_of_their_own) {
    Scene scene = cube();
    for (int i = 1; i < 9; ++i) {
        add_instance(scene, {3.0 * i, 0.0, 0.0});
    }
    const Surface surface = make_surface(scene);
    Settings settings = made(256);
    const Atlas atlas = make_atlas(scene, surface, settings);
    EXPECT_EQ(atlas.chart_count, 54U);
    EXPECT_EQ(atlas.pages.size(), 1U);
    expect_good(surface, atlas, settings);

    settings.layout = Layout::object;
    const Atlas apart = make_atlas(scene, surface, settings);
    ASSERT_EQ(apart.pages.size(), 9U);
    std::set<std::string> names;
    for (const AtlasPage& page : apart.pages) {
        names.insert(page.name);
    }
    EXPECT_EQ(names.size(), 9U);
    expect_good(surface, apart, settings);
}

/// Squares of 1 m, apart from each other.
Scene tiles(int count) {
    Scene scene = empty_scene();
    for (int i = 0; i < count; ++i) {
        const float x = 2.0F * static_cast<float>(i % 64);
        const int row = i / 64;
        const float y = 2.0F * static_cast<float>(row);
        add_quad(scene.meshes[0].primitives[0], {x, y, 0}, {x + 1, y, 0}, {x + 1, y + 1, 0}, {x, y + 1, 0});
    }
    return scene;
}

TEST(MadeCharts, what_does_not_fit_opens_pages_and_then_is_an_error_that_names_a_size) {
    const Scene scene = tiles(40);
    const Surface surface = make_surface(scene);
    Settings settings = made(32);
    settings.density = 8.0; // 9 texels a square, 2 between: nine to a page
    const Atlas atlas = make_atlas(scene, surface, settings);
    EXPECT_EQ(atlas.pages.size(), 5U);
    EXPECT_EQ(atlas.pages[4].name, "lightmap-4");
    expect_good(surface, atlas, settings);

    settings.max_pages = 4;
    try {
        (void)make_atlas(scene, surface, settings);
        FAIL() << "40 squares on 4 pages of 9";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        const std::string message = error.what();
        const std::size_t at = message.find("--size ");
        ASSERT_NE(at, std::string::npos) << message;
        settings.size = std::stoi(message.substr(at + 7));
    }
    EXPECT_EQ(settings.size, 42); // four in a row, sixteen to a page
    const Atlas fitted = make_atlas(scene, surface, settings);
    EXPECT_LE(fitted.pages.size(), 4U);
    expect_good(surface, fitted, settings);
}

TEST(MadeCharts, an_object_that_does_not_fit_its_page_is_an_error) {
    const Scene scene = tiles(10);
    const Surface surface = make_surface(scene);
    Settings settings = made(32);
    settings.layout = Layout::object;
    settings.density = 8.0;
    EXPECT_THROW((void)make_atlas(scene, surface, settings), Error);
    settings.density = 1e9;
    try {
        (void)make_atlas(scene, surface, settings);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::usage);
        EXPECT_NE(std::string(error.what()).find("no size up to 16384"), std::string::npos) << error.what();
    }
}

TEST(MadeCharts, more_charts_than_a_page_has_room_for) {
    const Scene scene = tiles(200);
    const Surface surface = make_surface(scene);
    Settings settings = made(16); // 6 × 6 charts of one texel, 2 between
    const Atlas atlas = make_atlas(scene, surface, settings);
    EXPECT_EQ(atlas.pages.size(), 6U);
    expect_good(surface, atlas, settings);
    settings.max_pages = 5;
    EXPECT_THROW((void)make_atlas(scene, surface, settings), Error);
}

TEST(MadeCharts, thousands_of_small_charts) {
    Scene scene = tiles(2500);
    add_box(scene.meshes[0].primitives[0], {-900.0F, -900.0F, -30.0F}, {-100.0F, -300.0F, -20.0F});
    const Surface surface = make_surface(scene);
    Settings settings = made(512);
    const Atlas atlas = make_atlas(scene, surface, settings);
    EXPECT_EQ(atlas.chart_count, 2506U);
    EXPECT_EQ(atlas.pages.size(), 1U);
    expect_gutter(atlas, settings.gutter);
    expect_one_density(surface, atlas);
}

TEST(MadeCharts, a_page_of_one_texel) {
    Scene scene = empty_scene();
    add_quad(scene.meshes[0].primitives[0], {0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0});
    const Surface surface = make_surface(scene);
    const Atlas atlas = make_atlas(scene, surface, made(1));
    expect_good(surface, atlas, made(1));
    // Half a texel long, in the middle of it.
    EXPECT_NEAR(atlas.density, 0.5 / 3.0, 1e-3);
}

TEST(MadeCharts, settings_out_of_range_are_refused) {
    const Scene scene = cube();
    const Surface surface = make_surface(scene);
    const auto refused = [&](auto change) {
        Settings settings = made(64);
        change(settings);
        try {
            (void)make_atlas(scene, surface, settings);
        } catch (const Error& error) {
            return error.kind() == ErrorKind::usage;
        }
        return false;
    };
    EXPECT_TRUE(refused([](Settings& s) { s.size = 0; }));
    EXPECT_TRUE(refused([](Settings& s) { s.size = 16385; }));
    EXPECT_TRUE(refused([](Settings& s) { s.gutter = -1; }));
    EXPECT_TRUE(refused([](Settings& s) { s.gutter = 65; }));
    EXPECT_TRUE(refused([](Settings& s) { s.max_pages = 0; }));
    EXPECT_TRUE(refused([](Settings& s) { s.density = 0.0; }));
    EXPECT_TRUE(refused([](Settings& s) { s.density = -1.0; }));
    EXPECT_TRUE(refused([](Settings& s) { s.density = std::nan(""); }));
    EXPECT_TRUE(refused([](Settings& s) { s.density = HUGE_VAL; }));
}

} // namespace
} // namespace vkbake
