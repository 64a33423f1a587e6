// Sizes that one frame of floats cannot hold together: baked right, or refused by name.
#include <gtest/gtest.h>

#include "host_bake.hpp"
#include "surface/resolution.hpp"

namespace vkbake::test {
namespace {

/// The message of the refusal, or nothing.
std::string refusal_of(const std::function<void()>& work) {
    try {
        work();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bad_input);
        return error.what();
    }
    return {};
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A box of 1 cm that stands on a ground.
Scene box_on_a_ground(double side) {
    Scene scene = scene_of(floor_of(0.5F), {}, glm::dmat3(side));
    scene.instances[0].name = "ground";
    add_object(scene, "box", box_of({-0.005F, 0.0F, -0.005F}, {0.005F, 0.01F, 0.005F}));
    return scene;
}

/// Its top sees the whole sky; its sides the upper half of what they face, the ground the other.
TEST(Frame, ABoxOfOneCentimetreIsBakedRightOrRefused) {
    for (const double side : {1.0, 100.0, 1000.0}) {
        SCOPED_TRACE(side);
        const Scene scene = box_on_a_ground(side);
        EXPECT_EQ(check_resolution(scene, make_surface(scene)).empty(), true);
        Settings settings = small_settings(32, 256);
        settings.layout = Layout::object;
        const HostBake bake = bake_on_host(scene, {}, settings);
        double sides = 0.0;
        int count = 0;
        for (std::size_t texel = 0; texel < bake.maps[1].image.texels.size(); ++texel) {
            const float light = bake.maps[1].image.texels[texel].x;
            const float up = bake.geometry[1].geometric_normal[texel].y;
            if (bake.maps[1].image.coverage[texel] < 0.5F || up < -0.5F) {
                continue;
            }
            if (up > 0.5F) {
                ASSERT_EQ(light, 1.0F);
            } else {
                ASSERT_NEAR(light, 0.5, 6.0 * std::sqrt(0.25 / settings.rays));
                sides += static_cast<double>(light);
                ++count;
            }
        }
        ASSERT_GT(count, 200);
        EXPECT_NEAR(sides / count, 0.5, 6.0 * std::sqrt(0.25 / settings.rays / count));
    }
    for (const double side : {1e5, 1e7}) {
        const Scene scene = box_on_a_ground(side);
        const std::string message = refusal_of([&] { (void)check_resolution(scene, make_surface(scene)); });
        EXPECT_TRUE(holds(message, "\"box\"")) << message;
        EXPECT_TRUE(holds(message, side < 1e6 ? "0.00781 m" : "1 m")) << message; // 2^17 and 2^24 m, times 2^-24
    }
}

/// inspect says it before anything is baked; of bake the same is asked in tests/gpu.
TEST(Frame, InspectNamesWhatIsTooSmall) {
    const std::string message = refusal_of([] { (void)inspect(box_on_a_ground(1e5), small_settings()); });
    EXPECT_TRUE(holds(message, "\"box\"") && holds(message, "0.00781 m")) << message;
    Scene scene = scene_of(floor_of(500.0F));
    add_object(scene, "detail", floor_of(0.05F), {0.0, 1.0, 0.0});
    Settings settings = small_settings(64);
    settings.layout = Layout::object;
    const std::vector<std::string> notes = inspect(scene, settings).notes;
    EXPECT_TRUE(std::ranges::any_of(notes, [](const std::string& note) {
        return holds(note, "texels are smaller than 64 steps") && holds(note, "detail");
    }));
}

TEST(Frame, WhatIsFarFromTheRestIsRefusedByName) {
    Scene scene = scene_of(floor_of(0.5F));
    add_object(scene, "far", floor_of(0.5F), {1e7, 0.0, 0.0});
    EXPECT_TRUE(holds(refusal_of([&] { (void)check_resolution(scene, make_surface(scene)); }), "\"thing\""));
    scene.instances[1].translation = {1e5, 0.0, 0.0}; // a step of 8 mm: 1 m is 128 steps
    EXPECT_TRUE(check_resolution(scene, make_surface(scene)).empty());
}

TEST(Frame, SmallAndLostTrianglesAreNoted) {
    Scene scene = scene_of(floor_of(500.0F));
    Primitive parts = floor_of(1.0F);
    add_quad(parts, {0, 1, 0.001F}, {0.001F, 1, 0.001F}, {0.001F, 1, 0}, {0, 1, 0}); // 16 steps of 2^-14 m
    add_quad(parts, {-90, 2, 1e-6F}, {90, 2, 1e-6F}, {90, 2, 0}, {-90, 2, 0});       // 1/61 step wide
    add_object(scene, "parts", parts, {0.0, 0.0, 300.0}); // at the centre floats would be denser
    const std::vector<std::string> notes = check_resolution(scene, make_surface(scene));
    ASSERT_EQ(notes.size(), 2U);
    EXPECT_TRUE(holds(notes[0], "2 triangles span fewer than 64 steps") && holds(notes[0], "parts")) << notes[0];
    EXPECT_TRUE(holds(notes[1], "2 triangles are thinner") && holds(notes[1], "6.1e-05 m")) << notes[1];

    Scene strip = scene_of(floor_of(0.5F), {}, glm::dmat3(1e7));
    add_object(strip, "strip", floor_of(0.5F), {0.0, 0.0, 3e6}, glm::dmat3(1e6, 0, 0, 0, 1, 0, 0, 0, 0.1));
    EXPECT_TRUE(holds(refusal_of([&] { (void)check_resolution(strip, make_surface(strip)); }), "thinner than a step"));
}

TEST(Frame, TexelsBelowTheStepsAreNoted) {
    Scene scene = scene_of(floor_of(500.0F));
    Settings settings = small_settings(64);
    EXPECT_TRUE(note_small_texels(make_surface(scene), make_atlas(scene, make_surface(scene), settings)).empty());
    add_object(scene, "detail", floor_of(0.05F), {0.0, 1.0, 0.0});
    settings.layout = Layout::object; // 10 cm over 64 texels: 1.6 mm, 26 steps of 2^-14 m
    const Surface surface = make_surface(scene);
    const std::vector<std::string> notes = note_small_texels(surface, make_atlas(scene, surface, settings));
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_TRUE(holds(notes[0], "detail") && !holds(notes[0], "parts")) << notes[0];
}

/// Beyond these no area or reciprocal would be a normal double.
TEST(Frame, SizesBeyondDoublesAreRefused) {
    for (const double size : {0x1p-310, 1e-320, 0x1p310, 1e300}) {
        EXPECT_TRUE(
            holds(refusal_of([&] { (void)make_surface(scene_of(floor_of(0.5F), {}, glm::dmat3(size))); }), "2^"))
            << size;
    }
    EXPECT_TRUE(holds(refusal_of([&] {
                          (void)make_surface(scene_of(floor_of(0.5F), {0x1p310, 0.0, 0.0}));
                      }),
                      "farther"));
    for (const double size : {0x1p-290, 0x1p290}) {
        const HostBake bake = bake_on_host(scene_of(floor_of(0.5F), {}, glm::dmat3(size)), {}, small_settings(8));
        EXPECT_GT(bake.maps.at(0).statistics.covered_texels, 40U) << size;
        EXPECT_TRUE(std::isfinite(bake.atlas.density));
    }
}

} // namespace
} // namespace vkbake::test
