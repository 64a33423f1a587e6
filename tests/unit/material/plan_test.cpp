// Which light is modelled, and what is said of it.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host_bake.hpp"
#include "imageio/encode.hpp"
#include "memory_plan.hpp"
#include "opacity.hpp"
#include "vkbake/plan.hpp"

namespace vkbake {
namespace {

PlanEntry entry(const Scene& scene, const Settings& settings, const std::string& phenomenon) {
    for (const PlanEntry& found : make_plan(scene, settings)) {
        if (found.phenomenon == phenomenon) {
            return found;
        }
    }
    ADD_FAILURE() << "no entry for " << phenomenon;
    return {};
}

bool says(const PlanEntry& entry, const std::string& words) { return entry.reason.find(words) != std::string::npos; }

TEST(Plan, SaysWhatBouncesWouldBring) {
    const Scene grey = test::painted_floor({.base_color = {0.5F, 0.25F, 0.25F, 1.0F}});
    Settings settings;
    EXPECT_FALSE(entry(grey, settings, "bounces").modelled);
    EXPECT_TRUE(says(entry(grey, settings, "bounces"), "up to 50 %"));
    settings.bounces = 3;
    EXPECT_TRUE(entry(grey, settings, "bounces").modelled);
    EXPECT_TRUE(says(entry(grey, settings, "bounces"), "at most 12.5 %")); // 0.5³
    EXPECT_TRUE(says(entry(grey, settings, "bounces"), "64 rays a texel each"));
    settings.target_error = 0.01;
    EXPECT_TRUE(says(entry(grey, settings, "bounces"), "as its error takes"));
    EXPECT_TRUE(says(entry(grey, settings, "sky"), "as its error takes"));
    settings.target_error.reset();
    EXPECT_FALSE(entry(test::painted_floor({.metallic = 1.0F}), settings, "bounces").modelled);
    settings.mode = Mode::ao;
    EXPECT_FALSE(entry(grey, settings, "bounces").modelled);
    EXPECT_FALSE(entry(grey, settings, "sky").modelled);
}

TEST(Plan, CountsLampsAndTheirRays) {
    Scene scene = test::painted_floor({});
    Settings settings;
    EXPECT_FALSE(entry(scene, settings, "lamps").modelled);
    scene.lamps = {{.kind = LampKind::point}, {.kind = LampKind::spot, .radius = 0.1}, {.kind = LampKind::point}};
    EXPECT_TRUE(entry(scene, settings, "lamps").modelled);
    EXPECT_TRUE(says(entry(scene, settings, "lamps"), "2 hard lamps, 1 ray a texel each; 1 soft lamp, 256 rays"));
    settings.lamps = Switch::off;
    EXPECT_FALSE(entry(scene, settings, "lamps").modelled);
    settings.lamps = Switch::on;
    settings.mode = Mode::ao;
    EXPECT_FALSE(entry(scene, settings, "lamps").modelled);
}

TEST(Plan, SaysHowFarVisibilityIsAsked) {
    const Scene scene = test::painted_floor({});
    Settings settings;
    EXPECT_FALSE(entry(scene, settings, "visibility").modelled);
    settings.mode = Mode::bent_normal;
    EXPECT_TRUE(entry(scene, settings, "visibility").modelled);
    EXPECT_TRUE(says(entry(scene, settings, "visibility"), "mean direction"));
    settings.mode = Mode::ao;
    settings.ao_distance = 2.5;
    settings.ao_falloff = Falloff::linear;
    EXPECT_TRUE(says(entry(scene, settings, "visibility"), "within 2.5 m"));
    EXPECT_TRUE(says(entry(scene, settings, "visibility"), "(linear), 256 rays a texel"));
}

TEST(Plan, DirectionsAreThereWhereTheyAreAskedFor) {
    Scene scene = test::painted_floor({});
    Settings settings;
    EXPECT_FALSE(entry(scene, settings, "directions").modelled);
    EXPECT_TRUE(says(entry(scene, settings, "directions"), "no material has a normal map"));
    scene.materials[0].normal_map = NormalMapUse{};
    EXPECT_TRUE(says(entry(scene, settings, "directions"), "1 of 1 materials has a normal map"));
    settings.directional = Switch::on;
    settings.directional_rays = 100;
    EXPECT_TRUE(entry(scene, settings, "directions").modelled);
    EXPECT_TRUE(says(entry(scene, settings, "directions"), "100 rays a texel more"));
    const MemoryNeed need = memory_need(scene, {}, settings);
    settings.directional = Switch::off;
    EXPECT_GT(peak_memory(need), peak_memory(memory_need(scene, {}, settings)));
}

TEST(Plan, EmissionComesWithTheFirstBounce) {
    const Scene lamp = test::painted_floor({.emissive = {0.0F, 3.0F, 0.0F}});
    Settings settings;
    EXPECT_FALSE(entry(lamp, settings, "emission").modelled);
    EXPECT_TRUE(says(entry(lamp, settings, "emission"), "1 of 1 materials"));
    settings.bounces = 1;
    EXPECT_TRUE(entry(lamp, settings, "emission").modelled);
    EXPECT_FALSE(entry(test::painted_floor({}), settings, "emission").modelled);
}

TEST(Plan, TexturesAreReadForBouncesOnly) {
    Scene scene = test::painted_floor({.base_color_texture = TextureUse{}});
    scene.images.resize(1);
    Settings settings;
    EXPECT_FALSE(entry(scene, settings, "albedo textures").modelled);
    settings.bounces = 1;
    EXPECT_TRUE(entry(scene, settings, "albedo textures").modelled);
}

TEST(Plan, CountsTheTexturesThatOpacityTakes) {
    Scene scene = test::painted_floor({.base_color_texture = TextureUse{}, .alpha_mode = AlphaMode::mask});
    const Image image{
        .width = 300, .height = 200, .texels = std::vector<glm::vec4>(60000, glm::vec4(0.5F)), .coverage = {}};
    const std::vector<std::uint8_t> bytes = encode_image(image, ImageFormat::png8).bytes;
    scene.images.resize(2);
    for (const std::uint8_t byte : bytes) {
        scene.images[0].bytes.push_back(std::byte{byte});
    }
    EXPECT_EQ(opacity_bytes(scene, {}), 100000U + 9U * 60000U);
    EXPECT_EQ(memory_need(scene, {}, {}).opacity, 640000U);
    EXPECT_EQ(memory_need(scene, {}, {.alpha = Alpha::opaque}).opacity, 0U);
    scene.materials[0].transmission = 0.5F; // three channels more
    EXPECT_EQ(opacity_bytes(scene, {}), 400000U + 9U * 60000U);
    scene.images[0].bytes.resize(20); // no header: refused when it is decoded
    EXPECT_EQ(opacity_bytes(scene, {}), 0U);
    scene.materials[0] = {};
    EXPECT_EQ(opacity_bytes(scene, {}), 0U);
}

TEST(Plan, SaysWhichTrianglesLetLightThrough) {
    Scene scene = test::painted_floor({.base_color = glm::vec4(1, 1, 1, 0.25F), .alpha_mode = AlphaMode::mask});
    test::add_object(scene, "box", test::box_of({-1, 0, -1}, {1, 1, 1}));
    test::paint(scene, 1, {.alpha_mode = AlphaMode::blend}); // of alpha 1
    EXPECT_TRUE(entry(scene, {}, "alpha").modelled);
    EXPECT_TRUE(says(entry(scene, {}, "alpha"), "1 of 2 materials, 14.3 % of the triangles")); // 2 of 14
    EXPECT_FALSE(entry(scene, {.alpha = Alpha::opaque}, "alpha").modelled);
    EXPECT_TRUE(says(entry(scene, {.alpha = Alpha::opaque}, "alpha"), "--alpha opaque"));
    scene.materials[0].base_color.a = 0.5F; // its cutoff
    EXPECT_FALSE(entry(scene, {}, "alpha").modelled);
    scene.materials[1].transmission = 0.5F;
    EXPECT_TRUE(entry(scene, {}, "alpha").modelled);
    scene.materials[1].metallic = 1.0F;
    EXPECT_FALSE(entry(scene, {}, "alpha").modelled);
}

} // namespace
} // namespace vkbake
