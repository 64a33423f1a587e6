#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "atlas/make_atlas.hpp"
#include "atlas/predicates.hpp"
#include "support.hpp"
#include "surface/make_surface.hpp"
#include "vkbake/error.hpp"

namespace vkbake {
namespace {

using namespace test; // NOLINT(google-build-using-namespace): the helpers of these tests

/// UVs of two triangles that fill the rectangle [low, high], as add_quad cuts it.
void append_rectangle(std::vector<glm::vec2>& uvs, const glm::vec2& low, const glm::vec2& high) {
    const glm::vec2 a(low.x, high.y);
    const glm::vec2 b(high.x, high.y);
    const glm::vec2 c(high.x, low.y);
    const glm::vec2 d(low.x, low.y);
    uvs.insert(uvs.end(), {a, b, c, a, c, d});
}

/// Two floors, 2 × 1 m and 1 × 1 m, with UVs that lie side by side.
Scene floors(const glm::vec2& second_low = {0.6F, 0.1F}, const glm::vec2& second_high = {0.9F, 0.4F}) {
    Scene scene = empty_scene();
    Primitive& primitive = scene.meshes[0].primitives[0];
    add_quad(primitive, {0, 0, 1}, {2, 0, 1}, {2, 0, 0}, {0, 0, 0});
    add_quad(primitive, {5, 0, 1}, {6, 0, 1}, {6, 0, 0}, {5, 0, 0});
    std::vector<glm::vec2> uvs;
    append_rectangle(uvs, {0.1F, 0.1F}, {0.5F, 0.3F});
    append_rectangle(uvs, second_low, second_high);
    set_light_map_uvs(primitive, uvs);
    return scene;
}

Settings settings_with(UvSource source, Layout layout = Layout::atlas) {
    Settings settings;
    settings.charts = ChartMaker::polypack; // whose densities are exact
    settings.size = 128;
    settings.uv = source;
    settings.layout = layout;
    return settings;
}

/// The UVs of the scene's own vertices, in the surface's order.
std::vector<glm::vec2> own_uvs(const Scene& scene, const Surface& surface) {
    std::vector<glm::vec2> uvs;
    for (std::size_t corner = 0; corner < surface.vertices.size(); ++corner) {
        const SurfacePart& part = surface.parts[surface.parts_of[corner / 3]];
        const Instance& instance = scene.instances[surface.objects[part.object].instance];
        const Primitive& primitive = scene.meshes[instance.mesh].primitives[part.primitive];
        uvs.push_back(primitive.tex_coords[1][surface.vertices[corner]]);
    }
    return uvs;
}

std::string error_of(const Scene& scene, const Settings& settings) {
    try {
        (void)make_atlas(scene, make_surface(scene), settings);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bad_input);
        return error.what();
    }
    return {};
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(KeptUvs, stay_as_they_are) {
    const Scene scene = floors();
    const Surface surface = make_surface(scene);
    for (const UvSource source : {UvSource::automatic, UvSource::keep}) {
        for (const Layout layout : {Layout::atlas, Layout::object}) {
            const Atlas atlas = make_atlas(scene, surface, settings_with(source, layout));
            EXPECT_EQ(atlas.uvs, own_uvs(scene, surface));
            EXPECT_EQ(atlas.pages.size(), 1U);
            EXPECT_EQ(atlas.pages[0].name, layout == Layout::atlas ? "lightmap" : surface.objects[0].name);
            EXPECT_EQ(atlas.density, 0.0);
            EXPECT_EQ(atlas.chart_count, 2U);
            expect_sound(surface, atlas);
            ASSERT_EQ(atlas.notes.size(), 1U);
            EXPECT_TRUE(contains(atlas.notes[0], "kept: " + surface.objects[0].name)) << atlas.notes[0];
        }
    }
}

TEST(KeptUvs, are_not_looked_at_where_uvs_are_made) {
    const Scene scene = floors();
    const Surface surface = make_surface(scene);
    const Atlas atlas = make_atlas(scene, surface, settings_with(UvSource::make));
    EXPECT_NE(atlas.uvs, own_uvs(scene, surface));
    expect_sound(surface, atlas);
    expect_one_density(surface, atlas);
    EXPECT_EQ(atlas.uvs, make_atlas(Scene{}, surface, settings_with(UvSource::make)).uvs);
}

TEST(KeptUvs, that_overlap_are_refused_and_named) {
    // By one float step only.
    const Scene scene = floors({std::nextafter(0.5F, 0.0F), 0.1F}, {0.9F, 0.4F});
    const std::string message = error_of(scene, settings_with(UvSource::keep));
    EXPECT_TRUE(contains(message, "mesh \"thing\"")) << message;
    EXPECT_TRUE(contains(message, "triangle 0 of primitive 0 and triangle 3 of primitive 0")) << message;

    const Surface surface = make_surface(scene);
    const Atlas atlas = make_atlas(scene, surface, settings_with(UvSource::automatic));
    ASSERT_EQ(atlas.notes.size(), 1U);
    EXPECT_TRUE(contains(atlas.notes[0], "overlaps itself: triangle 0")) << atlas.notes[0];
    expect_sound(surface, atlas);
    expect_one_density(surface, atlas);

    // Exactly side by side is no overlap.
    const Scene touching = floors({0.5F, 0.1F}, {0.9F, 0.4F});
    EXPECT_EQ(error_of(touching, settings_with(UvSource::keep)), "");
}

TEST(KeptUvs, that_overlap_stay_as_they_are_where_trusted_and_a_note_says_so) {
    const Scene scene = floors({0.4F, 0.2F}, {0.9F, 0.4F});
    const Surface surface = make_surface(scene);
    for (const Layout layout : {Layout::atlas, Layout::object}) {
        const Atlas atlas = make_atlas(scene, surface, settings_with(UvSource::trust, layout));
        EXPECT_EQ(atlas.uvs, own_uvs(scene, surface));
        ASSERT_EQ(atlas.notes.size(), 1U);
        EXPECT_TRUE(contains(atlas.notes[0], "kept, though it overlaps itself: triangle 0")) << atlas.notes[0];
    }
    // Trust is in what is there.
    EXPECT_TRUE(contains(error_of(floors({0.6F, 0.1F}, {1.1F, 0.4F}), settings_with(UvSource::trust)), "leaves [0,1]"));
}

TEST(KeptUvs, that_are_trusted_are_moved_apart_where_a_mesh_is_there_twice) {
    Scene scene = floors({0.4F, 0.2F}, {0.9F, 0.4F});
    scene.instances.push_back(scene.instances[0]);
    scene.instances[1].translation = {0.0, 5.0, 0.0};
    const Surface surface = make_surface(scene);
    const Atlas atlas = make_atlas(scene, surface, settings_with(UvSource::trust));
    const auto bounds = [&](std::uint32_t object) {
        glm::vec2 low(2.0F);
        glm::vec2 high(-1.0F);
        for (std::size_t corner = 0; corner < atlas.uvs.size(); ++corner) {
            if (surface.parts[surface.parts_of[corner / 3]].object == object) {
                low = glm::min(low, atlas.uvs[corner]);
                high = glm::max(high, atlas.uvs[corner]);
            }
        }
        return std::pair(low, high);
    };
    const auto [low, high] = bounds(0);
    const auto [other_low, other_high] = bounds(1);
    EXPECT_TRUE(high.x < other_low.x || other_high.x < low.x || high.y < other_low.y || other_high.y < low.y);
}

TEST(KeptUvs, may_be_mirrored) {
    Scene scene = floors();
    for (glm::vec2& uv : scene.meshes[0].primitives[0].tex_coords[1]) {
        uv.x = 1.0F - uv.x;
    }
    EXPECT_EQ(error_of(scene, settings_with(UvSource::keep)), "");
    // Folded onto itself: the second triangle mirrored over the first.
    auto& uvs = scene.meshes[0].primitives[0].tex_coords[1];
    uvs[5] = uvs[1];
    EXPECT_TRUE(contains(error_of(scene, settings_with(UvSource::keep)), "triangle 0 of primitive 0 and triangle 1"));
}

TEST(KeptUvs, must_be_there_finite_inside_and_have_area) {
    const auto refused = [](auto change) {
        Scene scene = floors();
        change(scene);
        return error_of(scene, settings_with(UvSource::keep));
    };
    const auto with_uv = [](std::size_t vertex, glm::vec2 uv) {
        return [=](Scene& scene) { scene.meshes[0].primitives[0].tex_coords[1][vertex] = uv; };
    };
    EXPECT_TRUE(contains(refused([](Scene& s) { s.meshes[0].primitives[0].tex_coords[1].clear(); }), "is absent"));
    EXPECT_TRUE(contains(refused(with_uv(7, {1.0000001F, 0.5F})), "leaves [0,1] at triangle 2 of primitive 0"));
    EXPECT_TRUE(contains(refused(with_uv(0, {0.5F, -1e-30F})), "leaves [0,1] at triangle 0"));
    EXPECT_TRUE(contains(refused(with_uv(0, {std::nanf(""), 0.5F})), "is not finite"));
    EXPECT_TRUE(contains(refused(with_uv(0, {0.5F, std::numeric_limits<float>::infinity()})), "is not finite"));
    EXPECT_TRUE(contains(refused([](Scene& s) {
                             auto& uvs = s.meshes[0].primitives[0].tex_coords[1];
                             std::fill(uvs.begin(), uvs.end(), glm::vec2(0.0F));
                         }),
                         "has no area"));
    // Not used by any triangle, so no fault.
    EXPECT_EQ(refused([](Scene& s) {
                  s.meshes[0].primitives[0].positions.emplace_back(0.0F);
                  s.meshes[0].primitives[0].tex_coords[1].emplace_back(9.0F);
              }),
              "");
}

TEST(KeptUvs, one_primitive_without_them_is_enough_to_make_all) {
    Scene scene = floors();
    scene.meshes[0].primitives.emplace_back();
    add_quad(scene.meshes[0].primitives[1], {0, 3, 1}, {2, 3, 1}, {2, 3, 0}, {0, 3, 0});
    EXPECT_TRUE(contains(error_of(scene, settings_with(UvSource::keep)), "is absent from primitive 1"));
    const Surface surface = make_surface(scene);
    const Atlas atlas = make_atlas(scene, surface, settings_with(UvSource::automatic));
    expect_sound(surface, atlas);
    expect_one_density(surface, atlas);
}

/// Expects each object's UVs to be its own UVs, moved, turned and scaled alike in u and v, at the atlas's density.
void expect_moved_as_one(const Scene& scene, const Surface& surface, const Atlas& atlas) {
    const std::vector<glm::vec2> own = own_uvs(scene, surface);
    double area = 0.0;
    double own_area = 0.0;
    for (std::size_t t = 0; t < surface.triangle_count(); ++t) {
        area += doubled_projected_area(surface, t);
        own_area += std::abs((own[3 * t + 1].x - own[3 * t].x) * (own[3 * t + 2].y - own[3 * t].y) -
                             (own[3 * t + 1].y - own[3 * t].y) * (own[3 * t + 2].x - own[3 * t].x));
    }
    const double texels = std::sqrt(area / own_area) * atlas.density; // a unit of own UVs
    for (const SurfaceObject& object : surface.objects) {
        const std::size_t first = 3 * std::size_t{object.first_triangle};
        for (std::size_t corner = first; corner < first + 3 * std::size_t{object.triangle_count}; ++corner) {
            const glm::dvec2 before = glm::dvec2(own[corner]) - glm::dvec2(own[first]);
            const glm::dvec2 after = (glm::dvec2(atlas.uvs[corner]) - glm::dvec2(atlas.uvs[first])) *
                                     static_cast<double>(atlas.pages[0].width);
            bool moved = false;
            glm::dvec2 turned = before * texels;
            for (int quarter = 0; quarter < 4; ++quarter) {
                moved = moved || (std::abs(after.x - turned.x) < 1e-3 && std::abs(after.y - turned.y) < 1e-3);
                turned = {turned.y, -turned.x};
            }
            ASSERT_TRUE(moved) << object.name << ", corner " << corner - first;
        }
    }
}

TEST(KeptUvs, of_instances_are_moved_apart_at_one_density) {
    Scene scene = floors();
    for (int i = 1; i < 5; ++i) {
        add_instance(scene, {0.0, i, 0.0});
    }
    const Surface surface = make_surface(scene);
    for (const UvSource source : {UvSource::automatic, UvSource::keep}) {
        const Atlas atlas = make_atlas(scene, surface, settings_with(source));
        EXPECT_EQ(atlas.pages.size(), 1U);
        EXPECT_EQ(atlas.chart_count, 10U);
        expect_sound(surface, atlas);
        expect_gutter(atlas, 2);
        // All instances are alike, so the sums over the scene stand for each.
        expect_moved_as_one(scene, surface, atlas);
    }
    // In layout object each stays as it is, on its page.
    const Atlas apart = make_atlas(scene, surface, settings_with(UvSource::keep, Layout::object));
    EXPECT_EQ(apart.pages.size(), 5U);
    EXPECT_EQ(apart.uvs, own_uvs(scene, surface));
    expect_sound(surface, apart);
}

TEST(KeptUvs, lie_among_charts_that_were_made) {
    Scene scene = floors();
    scene.meshes.emplace_back();
    scene.meshes[1].name = "box";
    scene.meshes[1].primitives.emplace_back();
    add_box(scene.meshes[1].primitives[0], {0, 2, 0}, {1, 3, 2});
    add_instance(scene, glm::dvec3(0.0));
    scene.instances[1].mesh = 1;
    const Surface surface = make_surface(scene);
    const Atlas atlas = make_atlas(scene, surface, settings_with(UvSource::automatic));
    EXPECT_EQ(atlas.chart_count, 8U);
    expect_sound(surface, atlas);
    expect_gutter(atlas, 2);
    double texels = 0.0;
    double square_metres = 0.0;
    for (std::size_t t = 0; t < surface.triangle_count(); ++t) {
        if (surface.parts[surface.parts_of[t]].object == 0) {
            texels += std::abs(doubled_texel_area(atlas, t));
            square_metres += doubled_projected_area(surface, t);
        } else {
            EXPECT_NEAR(-doubled_texel_area(atlas, t),
                        doubled_projected_area(surface, t) * atlas.density * atlas.density, 0.01);
        }
    }
    EXPECT_NEAR(texels, square_metres * atlas.density * atlas.density, 0.01);
    EXPECT_TRUE(contains(error_of(scene, settings_with(UvSource::keep)), "mesh \"box\""));
}

TEST(KeptUvs, of_objects_that_share_one_atlas_stay_in_it) {
    Scene scene = empty_scene();
    for (std::uint32_t mesh = 0; mesh < 4; ++mesh) {
        if (mesh > 0) {
            scene.meshes.emplace_back();
            scene.meshes[mesh].primitives.emplace_back();
            add_instance(scene, {0.0, mesh, 0.0});
            scene.instances[mesh].mesh = mesh;
        }
        Primitive& primitive = scene.meshes[mesh].primitives[0];
        add_quad(primitive, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}, {0, 0, 0});
        std::vector<glm::vec2> uvs;
        const float at = 0.25F * static_cast<float>(mesh);
        append_rectangle(uvs, {at, 0.0F}, {at + 0.25F, 1.0F}); // they share edges
        set_light_map_uvs(primitive, uvs);
    }
    const Surface surface = make_surface(scene);
    const Atlas atlas = make_atlas(scene, surface, settings_with(UvSource::automatic));
    EXPECT_EQ(atlas.uvs, own_uvs(scene, surface));
    EXPECT_EQ(atlas.pages.size(), 1U);
    EXPECT_EQ(atlas.chart_count, 4U);
    Settings settings = settings_with(UvSource::automatic);
    settings.density = 10.0;
    const Atlas dense = make_atlas(scene, surface, settings);
    EXPECT_EQ(dense.uvs, atlas.uvs);
    EXPECT_TRUE(std::any_of(dense.notes.begin(), dense.notes.end(),
                            [](const std::string& note) { return contains(note, "density"); }));
}

TEST(KeptUvs, of_objects_without_area_make_no_nan) {
    Scene scene = floors();
    // The second instance is flattened to a point: UVs with area, a surface without.
    add_instance(scene, {0.0, 1.0, 0.0});
    scene.instances[1].linear = glm::dmat3(0.0);
    const Surface surface = make_surface(scene);
    const Atlas atlas = make_atlas(scene, surface, settings_with(UvSource::automatic));
    expect_sound(surface, atlas);
    EXPECT_TRUE(std::isfinite(atlas.density));
    EXPECT_GT(atlas.density, 0.0);
}

// What one bake wrote another must be able to keep: made UVs are free of overlap by the test that judges kept ones.
TEST(KeptUvs, that_were_made_here_will_do) {
    Scene scene = empty_scene();
    add_rough_ground(scene.meshes[0].primitives[0], 16, 3.0F);
    const Surface surface = make_surface(scene);
    const Atlas made = make_atlas(scene, surface, settings_with(UvSource::make));
    auto& uvs = scene.meshes[0].primitives[0].tex_coords[1];
    uvs.resize(scene.meshes[0].primitives[0].positions.size());
    for (std::size_t corner = 0; corner < surface.vertices.size(); ++corner) {
        uvs[surface.vertices[corner]] = made.uvs[corner];
    }
    const Atlas kept = make_atlas(scene, surface, settings_with(UvSource::keep));
    EXPECT_EQ(kept.uvs, made.uvs);
    EXPECT_EQ(kept.chart_count, made.chart_count);
    EXPECT_EQ(kept.chart, made.chart);
}

} // namespace
} // namespace vkbake
