#include "trace/emitter_set.hpp"

#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "atlas/make_atlas.hpp"
#include "base/random.hpp"
#include "host_bake.hpp"
#include "surface/make_surface.hpp"

namespace vkbake {
namespace {

/// Small squares that look in all directions, and a floor which does not glow; light maps of one texel for each object.
struct Glow {
    Glow() : scene(test::scene_of(test::floor_of(3.0F))) {
        for (int i = 0; i < 12; ++i) {
            test::add_object(scene, "lamp", test::floor_of(0.05F + 0.01F * static_cast<float>(i)),
                             {0.5 * i - 3.0, 1.0 + 0.2 * (i % 3), 0.3 * (i % 5)}, test::odd_rotation());
        }
        surface = make_surface(scene);
        Settings settings;
        settings.size = 8;
        settings.layout = Layout::object;
        atlas = make_atlas(scene, surface, settings);
        pages.resize(atlas.pages.size());
        for (std::size_t triangle = 0; triangle < surface.triangle_count(); ++triangle) {
            const std::uint32_t instance = surface.objects[surface.parts[surface.parts_of[triangle]].object].instance;
            LeavingLight& page = pages[atlas.page[triangle]];
            page = {.width = 1, .height = 1, .covered = {1}};
            page.radiance = page.sought = {glm::vec3(instance == 0 ? 0.0F : 1.0F + static_cast<float>(instance))};
        }
        two_sided.assign(surface.parts.size(), 0);
    }
    Scene scene;
    Surface surface;
    Atlas atlas;
    std::vector<LeavingLight> pages;
    std::vector<std::uint8_t> two_sided;
};

TEST(EmitterSet, SamplesComeAsOftenAsTheirDensitySays) {
    const Glow glow;
    const SurfaceLight light(glow.surface, glow.atlas, glow.pages, glow.two_sided);
    const EmitterSet emitters(glow.surface, light, nullptr);
    ASSERT_EQ(emitters.count(), 24U);
    const auto area = [&](std::uint32_t triangle) {
        const std::size_t first = std::size_t{3} * triangle;
        const glm::dvec3 a(glow.surface.positions[first]);
        return 0.5 * glm::length(glm::cross(glm::dvec3(glow.surface.positions[first + 1]) - a,
                                            glm::dvec3(glow.surface.positions[first + 2]) - a));
    };
    constexpr std::uint64_t samples = 20000;
    for (const Receiver& receiver :
         {Receiver{}, Receiver{{0.1, -0.2, 0.05}, {0.0, 1.0, 0.0}}, Receiver{{0.0, 0.3, 0.0}, {0.0, -1.0, 0.0}}}) {
        std::map<double, std::uint64_t> counts; // by density, which is each triangle's own
        std::uint64_t none = 0;
        for (std::uint64_t i = 0; i < samples; ++i) {
            const auto number = [&](std::uint64_t key) { return static_cast<double>(mix64(key) >> 11U) * 0x1p-53; };
            const auto sample = emitters.sample(receiver, number(2 * i), number(2 * i + 1));
            sample ? ++counts[sample->density] : ++none;
        }
        double all = 0.0;
        for (std::uint32_t triangle = 0; triangle < glow.surface.triangle_count(); ++triangle) {
            const double density = emitters.density(receiver, triangle);
            const double probability = density * area(triangle);
            all += probability;
            double expected = 0.0; // of all triangles of this density
            for (std::uint32_t other = 0; density > 0.0 && other < glow.surface.triangle_count(); ++other) {
                expected += emitters.density(receiver, other) == density ? density * area(other) : 0.0;
            }
            const double found = density > 0.0 ? static_cast<double>(counts[density]) : 0.0;
            // Five standard deviations: over some 70 triangles once in 25,000 runs by chance.
            EXPECT_NEAR(found, expected * samples, 5.0 * std::sqrt(expected * samples) + 1.0) << triangle;
        }
        EXPECT_LT(all, 1.0 + 1e-9);
        EXPECT_NEAR(static_cast<double>(none), (1.0 - all) * samples, 5.0 * std::sqrt(samples * (1.0 - all)) + 1.0);
    }
}

TEST(EmitterSet, HasNothingOfARoomThatGlowsAllOver) {
    Glow glow;
    for (LeavingLight& page : glow.pages) {
        page.radiance = page.sought = {glm::vec3(2.0F)};
    }
    const SurfaceLight light(glow.surface, glow.atlas, glow.pages, glow.two_sided);
    EXPECT_TRUE(EmitterSet(glow.surface, light, nullptr).empty());
}

} // namespace
} // namespace vkbake
