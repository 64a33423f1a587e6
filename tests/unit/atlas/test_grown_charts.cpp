#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "amount.hpp"
#include "atlas/make_atlas.hpp"
#include "atlas/measure_uvs.hpp"
#include "base/parallel.hpp"
#include "support.hpp"
#include "surface/make_surface.hpp"

namespace vkbake {
namespace {

using namespace test; // NOLINT(google-build-using-namespace): the helpers of these tests

Settings grown(int size) { return made_by(ChartMaker::grown, size); }

UvFigures figures_of(const Surface& surface, const Atlas& atlas) {
    std::vector<glm::dvec2> page_sizes;
    for (const AtlasPage& page : atlas.pages) {
        page_sizes.emplace_back(page.width, page.height);
    }
    return measure_uvs({surface.positions, atlas.uvs, atlas.page, page_sizes});
}

Atlas expect_good_atlas(const Scene& scene, const Settings& settings) {
    const Surface surface = make_surface(scene);
    Atlas atlas = make_atlas(scene, surface, settings);
    expect_sound(surface, atlas);
    expect_gutter(atlas, settings.gutter);
    const UvFigures figures = figures_of(surface, atlas);
    EXPECT_EQ(figures.overlapping, 0U);
    EXPECT_EQ(figures.mirrored, 0U);
    for (std::size_t t = 0; t < surface.triangle_count(); ++t) {
        EXPECT_LE(doubled_texel_area(atlas, t), 0.0) << "triangle " << t << " is mirrored";
    }
    return atlas;
}

/// n × 2n quads; the poles are triangles.
Scene sphere(int n) {
    Scene scene = empty_scene();
    const auto at = [&](int ring, int k) {
        const double polar = std::numbers::pi * ring / n;
        const double around = std::numbers::pi * (k % (2 * n)) / n;
        return glm::vec3(ring == 0 || ring == n ? 0.0 : std::sin(polar) * std::cos(around), std::cos(polar),
                         ring == 0 || ring == n ? 0.0 : std::sin(polar) * std::sin(around));
    };
    for (int ring = 0; ring < n; ++ring) {
        for (int k = 0; k < 2 * n; ++k) {
            if (ring > 0) {
                add_triangle(scene.meshes[0].primitives[0], at(ring, k), at(ring, k + 1), at(ring + 1, k));
            }
            if (ring < n - 1) {
                add_triangle(scene.meshes[0].primitives[0], at(ring, k + 1), at(ring + 1, k + 1), at(ring + 1, k));
            }
        }
    }
    return scene;
}

/// A box on a large ground, which decides how many texels a metre there are.
Scene box_on_ground() {
    Scene scene = empty_scene();
    Primitive& primitive = scene.meshes[0].primitives[0];
    add_box(primitive, {0.0F, 1.0F, 0.0F}, {1.0F, 2.0F, 1.5F});
    add_quad(primitive, {-25, 0, 25}, {25, 0, 25}, {25, 0, -25}, {-25, 0, -25});
    return scene;
}

// Its faces get different light, which would run into each other along the edges that they share.
TEST(GrownCharts, a_box_is_cut_along_its_edges) {
    const Scene scene = box_on_ground();
    const Atlas atlas = expect_good_atlas(scene, grown(512));
    EXPECT_EQ(atlas.chart_count, 7U);
    const Surface surface = make_surface(scene);
    EXPECT_NEAR(figures_of(surface, atlas).stretch, 1.0, 1e-3);
}

// Around faces of a few texels gutters would take more room than they do.
TEST(GrownCharts, a_box_of_few_texels_is_one_chart) {
    const Atlas atlas = expect_good_atlas(box_on_ground(), grown(128));
    EXPECT_EQ(atlas.chart_count, 2U);
}

// Light that falls on what is shaded smoothly changes smoothly, whatever the triangles do.
TEST(GrownCharts, a_roof_is_cut_along_its_ridge_unless_it_is_shaded_smoothly) {
    for (const bool smooth : {false, true}) {
        Scene scene = empty_scene();
        Primitive& primitive = scene.meshes[0].primitives[0];
        add_quad(primitive, {0, 0, 1}, {3, 0, 1}, {3, 1, 0}, {0, 1, 0});
        add_quad(primitive, {0, 1, 0}, {3, 1, 0}, {3, 0, -1}, {0, 0, -1});
        if (smooth) {
            primitive.normals.assign(primitive.positions.size(), {0.0F, 1.0F, 0.0F});
        }
        EXPECT_EQ(expect_good_atlas(scene, grown(256)).chart_count, smooth ? 1U : 2U);
    }
}

// A wall is a face of its own, whatever triangles it has.
TEST(GrownCharts, a_room_keeps_its_walls_whole) {
    Scene scene = empty_scene();
    add_box(scene.meshes[0].primitives[0], {0, 0, 0}, {4, 3, 5});
    const Surface surface = make_surface(scene);
    const Atlas atlas = expect_good_atlas(scene, grown(256));
    EXPECT_LE(atlas.chart_count, 6U);
    for (std::size_t a = 0; a < surface.triangle_count(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            EXPECT_TRUE(surface.geometric_normals[a] != surface.geometric_normals[b] ||
                        atlas.chart[a] == atlas.chart[b]);
        }
    }
}

// No flat map of the whole sphere stays within any bound, but a few charts do.
TEST(GrownCharts, a_sphere_takes_few_charts_of_little_stretch) {
    const Scene scene = sphere(amount(20, 10));
    const Surface surface = make_surface(scene);
    for (const double stretch : {1.003, 1.01, 1.05}) {
        Settings settings = grown(512);
        settings.stretch = stretch;
        const Atlas atlas = expect_good_atlas(scene, settings);
        EXPECT_GE(atlas.chart_count, 2U);
        EXPECT_LE(atlas.chart_count, 24U);
        EXPECT_LE(figures_of(surface, atlas).stretch, stretch);
    }
}

// A cylinder without caps is cut once and unrolled.
TEST(GrownCharts, a_tube_is_unrolled) {
    Scene scene = empty_scene();
    constexpr int sides = 40;
    const auto at = [&](int k, float y) {
        const double angle = 2.0 * std::numbers::pi * (k % sides) / sides;
        return glm::vec3(std::cos(angle), y, -std::sin(angle));
    };
    for (int k = 0; k < sides; ++k) {
        add_quad(scene.meshes[0].primitives[0], at(k, 0), at(k + 1, 0), at(k + 1, 3), at(k, 3));
    }
    const Atlas atlas = expect_good_atlas(scene, grown(256));
    EXPECT_EQ(atlas.chart_count, 1U);
}

// Four times the area for twice the density; the wall is long enough that a texel's rounding is little.
TEST(GrownCharts, an_instance_may_ask_for_more_density) {
    Scene scene = empty_scene();
    add_quad(scene.meshes[0].primitives[0], {0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {0, 2, 0});
    add_instance(scene, {10.0, 0.0, 0.0});
    scene.instances[1].density = 2.0;
    Settings settings = grown(512);
    settings.density = 50.0;
    const Atlas atlas = expect_good_atlas(scene, settings);
    EXPECT_NEAR(-doubled_texel_area(atlas, 0), 6.0 * 50.0 * 50.0, 0.01 * 15000.0);
    EXPECT_NEAR(-doubled_texel_area(atlas, 2), 6.0 * 100.0 * 100.0, 0.01 * 60000.0);
}

// Borders of a wall lie on texel centres, so that the wall beside it has the same values there.
TEST(GrownCharts, straight_borders_lie_on_texel_centres) {
    Scene scene = empty_scene();
    add_quad(scene.meshes[0].primitives[0], {0, 0, 0}, {3.3F, 0, 0}, {3.3F, 2.1F, 0}, {0, 2.1F, 0});
    Settings settings = grown(256);
    settings.density = 37.3;
    const Atlas atlas = expect_good_atlas(scene, settings);
    for (const glm::vec2& uv : atlas.uvs) {
        EXPECT_EQ(std::fmod(uv.x * 256.0, 1.0), 0.5);
        EXPECT_EQ(std::fmod(uv.y * 256.0, 1.0), 0.5);
    }
}

// Slivers and specks: each holds the centre of a texel.
TEST(GrownCharts, every_chart_holds_a_texel_centre) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> place(0.0F, 0.3F);
    Scene scene = empty_scene();
    for (int i = 0; i < 300; ++i) {
        const int row = i / 20;
        const float x = 5.0F * static_cast<float>(i % 20);
        const float y = 5.0F * static_cast<float>(row);
        const auto point = [&] {
            return glm::vec3(x + place(random) * (i % 3 == 0 ? 10.0F : 1.0F), y + place(random), 0);
        };
        add_triangle(scene.meshes[0].primitives[0], point(), point(), point());
    }
    Settings settings = grown(256);
    settings.density = 1.0;
    const Surface surface = make_surface(scene);
    const Atlas atlas = make_atlas(scene, surface, settings);
    expect_gutter(atlas, settings.gutter);
    ASSERT_EQ(atlas.chart_count, 300U);
    for (std::size_t t = 0; t < 300; ++t) {
        glm::dvec2 corners[3];
        for (std::size_t c = 0; c < 3; ++c) {
            corners[c] = glm::dvec2(atlas.uvs[3 * t + c]) * 256.0;
        }
        bool holds = false;
        for (int k = 0; k < 256 * 256 && !holds; ++k) {
            const int row = k / 256;
            const glm::dvec2 centre(k % 256 + 0.5, row + 0.5);
            int inside = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                const glm::dvec2 along = corners[(c + 1) % 3] - corners[c];
                const glm::dvec2 way = centre - corners[c];
                inside += along.x * way.y - along.y * way.x <= 1e-4 ? 1 : 0;
            }
            holds = inside == 3;
        }
        EXPECT_TRUE(holds) << "triangle " << t;
    }
}

// Soups of triangles: some share vertices, some lie on each other, some have no area.
TEST(GrownCharts, random_meshes_hold_every_promise) {
    for (std::uint32_t seed = 0; seed < 6; ++seed) {
        std::mt19937 random(seed);
        const auto pick = [&](std::uint32_t below) { return random() % below; };
        std::vector<glm::vec3> points;
        for (int i = 0; i < 40; ++i) {
            const std::uint32_t steps = seed % 3 == 0 ? 3 : 1000;
            points.emplace_back(static_cast<float>(pick(steps)), static_cast<float>(pick(steps)),
                                static_cast<float>(pick(seed % 4 == 1 ? 2 : steps)));
        }
        Scene scene = empty_scene();
        for (int i = 0; i < 80; ++i) {
            add_triangle(scene.meshes[0].primitives[0], points[pick(40)], points[pick(40)], points[pick(40)]);
        }
        SCOPED_TRACE(seed);
        (void)expect_good_atlas(scene, grown(200));
    }
}

TEST(GrownCharts, rough_ground_and_needles_hold_every_promise) {
    Scene scene = empty_scene();
    Primitive& primitive = scene.meshes[0].primitives[0];
    add_rough_ground(primitive, 12, 3.0F);
    for (int i = 0; i < 100; ++i) {
        const auto rim = [](int k) {
            const double angle = 2.0 * std::numbers::pi * k / 100.0;
            return glm::vec3(20.0 + std::cos(angle), std::sin(angle), 0.0);
        };
        add_triangle(primitive, {20, 0, 0}, rim(i), rim(i + 1));
    }
    add_triangle(primitive, {30.0F, 0.0F, 0.0F}, {31.0F, 1.0F, 0.0F}, {30.5F, 0.50000006F, 0.0F});
    (void)expect_good_atlas(scene, grown(500));
}

TEST(GrownCharts, the_order_of_triangles_changes_nothing) {
    Scene scene = sphere(12);
    add_rough_ground(scene.meshes[0].primitives[0], 8, 1.0F);
    add_box(scene.meshes[0].primitives[0], {20, 0, 0}, {21, 2, 3});
    const Surface surface = make_surface(scene);
    const Atlas atlas = make_atlas(scene, surface, grown(256));
    for (const std::uint32_t seed : {1U, 2U}) {
        Scene shuffled = scene;
        shuffle_triangles(shuffled.meshes[0].primitives[0], seed);
        const Surface other_surface = make_surface(shuffled);
        const Atlas other = make_atlas(shuffled, other_surface, grown(256));
        ASSERT_EQ(other.chart_count, atlas.chart_count);
        for (std::size_t rank = 0; rank < surface.canonical_order.size(); ++rank) {
            const std::size_t a = surface.canonical_order[rank];
            const std::size_t b = other_surface.canonical_order[rank];
            for (std::size_t c = 0; c < 3; ++c) {
                ASSERT_EQ(atlas.uvs[3 * a + c], other.uvs[3 * b + c]);
            }
            ASSERT_EQ(atlas.chart[a], other.chart[b]);
        }
    }
}

TEST(GrownCharts, the_number_of_threads_changes_nothing) {
    Scene scene = sphere(16);
    add_rough_ground(scene.meshes[0].primitives[0], 12, 1.0F);
    for (int k = 0; k < 40; ++k) {
        const auto x = static_cast<float>(30 + 3 * k);
        add_box(scene.meshes[0].primitives[0], {x, 0, 0}, {x + 1, 2, 3});
    }
    const Surface surface = make_surface(scene);
    Atlas alone;
    with_threads(1, [&] { alone = make_atlas(scene, surface, grown(256)); });
    for (const int threads : {2, 0}) {
        with_threads(threads, [&] {
            const Atlas atlas = make_atlas(scene, surface, grown(256));
            EXPECT_EQ(atlas.uvs, alone.uvs);
            EXPECT_EQ(atlas.chart, alone.chart);
            EXPECT_EQ(atlas.page, alone.page);
        });
    }
}

/// n × m quads over the unit square, bent by `at`.
template<typename At>
void add_sheet(Primitive& primitive, int n, int m, const At& at) {
    for (int i = 0; i < n; ++i) {
        for (int k = 0; k < m; ++k) {
            const double u[]{static_cast<double>(i) / n, static_cast<double>(i + 1) / n};
            const double v[]{static_cast<double>(k) / m, static_cast<double>(k + 1) / m};
            add_quad(primitive, at(u[0], v[0]), at(u[1], v[0]), at(u[1], v[1]), at(u[0], v[1]));
        }
    }
}

// Whatever hangs together in a way that no flat map has is cut.
TEST(GrownCharts, surfaces_of_any_kind_hold_every_promise) {
    constexpr double full_turn = 2.0 * std::numbers::pi;
    const auto torus = [](double u, double v) {
        const double radius = 2.0 + 0.7 * std::cos(full_turn * std::fmod(v, 1.0));
        return glm::vec3(radius * std::cos(full_turn * std::fmod(u, 1.0)),
                         0.7 * std::sin(full_turn * std::fmod(v, 1.0)),
                         -radius * std::sin(full_turn * std::fmod(u, 1.0)));
    };
    const auto moebius_strip = [](double u, double v) {
        // Its two ends are the same points, in opposite order.
        const double way = (u < 1.0 ? 1.0 : -1.0) * (v - 0.5);
        const double turn = full_turn * std::fmod(u, 1.0);
        const double radius = 2.0 + way * std::cos(0.5 * turn);
        return glm::vec3(6.0 + radius * std::cos(turn), way * std::sin(0.5 * turn), radius * std::sin(turn));
    };
    const auto spiral_stair = [](double u, double v) {
        const double turn = 3.0 * full_turn * u;
        return glm::vec3(12.0 + (1.0 + v) * std::cos(turn), 4.0 * u, (1.0 + v) * std::sin(turn));
    };
    Scene scene = empty_scene();
    Primitive& primitive = scene.meshes[0].primitives[0];
    add_sheet(primitive, 24, 12, torus);
    add_sheet(primitive, 30, 3, moebius_strip);
    add_sheet(primitive, 60, 2, spiral_stair);
    for (int leaf = 0; leaf < 5; ++leaf) { // of a book, at one edge
        const double turn = full_turn * leaf / 5.0;
        const auto x = static_cast<float>(16.0 + std::cos(turn));
        const auto z = static_cast<float>(std::sin(turn));
        add_quad(primitive, {16, 0, 0}, {x, 0, z}, {x, 1, z}, {16, 1, 0});
    }
    for (int copy = 0; copy < 8; ++copy) {
        add_triangle(primitive, {18, 0, 0}, {19, 0, 0}, {18, 1, 0});
    }
    const Atlas atlas = expect_good_atlas(scene, grown(512));
    // The stair lies on itself three times over as a shadow; its charts must not.
    EXPECT_GE(atlas.chart_count, 8U + 5U);
}

// A square metre on 10 × 10 texels beside the same at half the density.
TEST(MeasureUvs, stretch_of_known_maps) {
    const std::vector<glm::vec3> positions{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    std::vector<glm::vec2> texels{{0, 0}, {10, 0}, {10, 10}, {0, 0}, {10, 10}, {0, 10}};
    const std::vector<std::uint32_t> page{0, 0};
    const std::vector<glm::dvec2> ones{{1, 1}};
    UvFigures figures = measure_uvs({positions, texels, page, ones});
    EXPECT_EQ(figures.charts, 1U);
    EXPECT_DOUBLE_EQ(figures.stretch, 1.0);
    EXPECT_DOUBLE_EQ(figures.uv_area, 100.0);
    // Twice as long along u: σ = 1/20, 1/10, so L2² · area ratio = (1/400 + 1/100) / 2 · 200 = 1.25.
    for (glm::vec2& texel : texels) {
        texel.x *= 2.0F;
    }
    EXPECT_NEAR(measure_uvs({positions, texels, page, ones}).stretch, std::sqrt(1.25), 1e-12);
    // The second triangle folded over onto the first.
    texels = {{0, 0}, {10, 0}, {10, 10}, {0, 0}, {10, 10}, {10, 0}};
    figures = measure_uvs({positions, texels, page, ones});
    EXPECT_EQ(figures.overlapping, 2U);
    EXPECT_EQ(figures.charts, 1U);
}

// Two thin triangles that meet along a side, on a page whose size is no power of two. In texels as floats the side's
// corners are rounded, and the triangles lie on each other.
TEST(MeasureUvs, texels_are_not_rounded) {
    const std::vector<glm::vec3> positions{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {5, 0, 0}, {6, 1, 0}, {5, 1, 0}};
    const float step = 0x1p-23F;
    const std::vector<std::uint32_t> page{0, 0};
    const std::vector<glm::dvec2> pages{{1000.0, 1000.0}};
    int overlapping_as_floats = 0;
    for (int k = 0; k < 64; ++k) {
        const float x = 0.7F + static_cast<float>(k) * step;
        // From (x, 0.5) to (x + 3, 0.5 + 2) steps and on to (x + 6, 0.5 + 4): all on one line.
        const glm::vec2 a{x, 0.5F};
        const glm::vec2 b{x + 3.0F * step, 0.5F + 2.0F * step};
        const glm::vec2 c{x + 6.0F * step, 0.5F + 4.0F * step};
        const std::vector<glm::vec2> uvs{a, c, {0.9F, 0.5F}, a, {0.5F, 0.9F}, b};
        EXPECT_EQ(measure_uvs({positions, uvs, page, pages}).overlapping, 0U);
        std::vector<glm::vec2> texels = uvs;
        for (glm::vec2& texel : texels) {
            texel *= 1000.0F;
        }
        const std::vector<glm::dvec2> ones{{1, 1}};
        overlapping_as_floats += measure_uvs({positions, texels, page, ones}).overlapping > 0 ? 1 : 0;
    }
    EXPECT_GT(overlapping_as_floats, 0); // else this shows nothing
}

} // namespace
} // namespace vkbake
