// KHR_lights_punctual, and the sizes that extras.vkbake gives its lights.
#include <cmath>
#include <numbers>

#include "document_builder.hpp"

namespace vkbake::test {
namespace {

/// The triangle, and a node for each light.
DocumentBuilder lit_document(const Json& lights) {
    DocumentBuilder builder = triangle_document();
    builder.json["extensionsUsed"] = {"KHR_lights_punctual"};
    builder.json["extensions"]["KHR_lights_punctual"]["lights"] = lights;
    for (std::size_t light = 0; light < lights.size(); ++light) {
        builder.json["scenes"][0]["nodes"].push_back(builder.json["nodes"].size());
        builder.json["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", light}}}}}});
    }
    return builder;
}

Json light_of(const char* type) { return {{"type", type}}; }

void expect_close(const glm::dvec3& actual, const glm::dvec3& expected) {
    for (glm::length_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(actual[i], expected[i], 1e-12) << "component " << i;
    }
}

TEST(Lamps, HaveTheExtensionsDefaults) {
    const Scene scene = lit_document({light_of("directional"), light_of("point"), light_of("spot")}).load();
    ASSERT_EQ(scene.lamps.size(), 3U);
    EXPECT_TRUE(scene.notes.empty());
    EXPECT_EQ(scene.lamps[0].kind, LampKind::directional);
    EXPECT_EQ(scene.lamps[1].kind, LampKind::point);
    EXPECT_EQ(scene.lamps[2].kind, LampKind::spot);
    for (const Lamp& lamp : scene.lamps) {
        EXPECT_EQ(lamp.color, glm::dvec3(1.0));
        EXPECT_EQ(lamp.intensity, 1.0);
        EXPECT_FALSE(lamp.range);
        EXPECT_FALSE(lamp.is_soft());
        expect_close(lamp.direction, {0, 0, -1});
    }
    EXPECT_EQ(scene.lamps[2].inner_cone, 0.0);
    EXPECT_NEAR(scene.lamps[2].outer_cone, std::numbers::pi / 4, 1e-15);
    EXPECT_EQ(scene.lamps[2].name, "node 3");
}

TEST(Lamps, SayWhatTheFileSays) {
    Json spot = light_of("spot");
    spot.update(Json{{"color", {1, 0.5, 0.25}},
                     {"intensity", 300},
                     {"range", 12},
                     {"name", "stage"},
                     {"spot", {{"innerConeAngle", 0.25}, {"outerConeAngle", 0.5}}},
                     {"extras", {{"vkbake", {{"radius", 0.1}}}}}});
    Json sun = light_of("directional");
    sun["extras"]["vkbake"]["angularDiameter"] = 0.53;
    DocumentBuilder builder = lit_document({spot, sun});
    builder.json["nodes"][1]["extras"]["vkbake"]["radius"] = 0.2; // the node's word is the last
    const Scene scene = builder.load();
    const Lamp& lamp = scene.lamps.at(0);
    EXPECT_EQ(lamp.name, "stage");
    EXPECT_EQ(lamp.color, glm::dvec3(1.0, 0.5, 0.25));
    EXPECT_EQ(lamp.intensity, 300.0);
    EXPECT_EQ(lamp.range.value(), 12.0);
    EXPECT_EQ(lamp.inner_cone, 0.25);
    EXPECT_EQ(lamp.outer_cone, 0.5);
    EXPECT_EQ(lamp.radius, 0.2);
    EXPECT_EQ(scene.lamps.at(1).angular_diameter, 0.53);
    EXPECT_TRUE(lamp.is_soft());
    EXPECT_TRUE(scene.lamps.at(1).is_soft());
}

TEST(Lamps, StandWhereTheirNodesStandAndShineAlongMinusZ) {
    DocumentBuilder builder = lit_document(Json::array({light_of("spot")}));
    // By hand: the turn by 90° about +Y takes −Z to −X, and (1, 2, 3) to (3, 2, −1); the parent's scale makes it
    // (6, 6, −4), and −X stays −X whatever the scale; its move adds (0, 1, 0).
    const double half = std::numbers::sqrt2 / 2.0;
    builder.json["nodes"][1]["translation"] = {1, 2, 3};
    builder.json["nodes"].push_back({{"children", {1}}, {"rotation", {0, half, 0, half}}});
    builder.json["nodes"].push_back({{"children", {2}}, {"scale", {2, 3, 4}}, {"translation", {0, 1, 0}}});
    builder.json["scenes"][0]["nodes"] = {0, 3};
    const Lamp lamp = builder.load().lamps.at(0);
    expect_close(lamp.position, {6, 7, -4});
    expect_close(lamp.direction, {-1, 0, 0});
    EXPECT_EQ(lamp.source_node, 1U);
}

TEST(Lamps, ScaledToNothingAreLeftOutWithANote) {
    DocumentBuilder builder = lit_document({light_of("directional"), light_of("point")});
    builder.json["nodes"][1]["scale"] = {1, 1, 0};
    builder.json["nodes"][2]["scale"] = {0, 0, 0}; // a point has no direction to lose
    const Scene scene = builder.load();
    ASSERT_EQ(scene.lamps.size(), 1U);
    EXPECT_EQ(scene.lamps[0].kind, LampKind::point);
    EXPECT_TRUE(has_note(scene, "node 1 holds a lamp that is scaled to nothing"));
}

TEST(Lamps, OfABakedSceneAreFoundAgain) {
    DocumentBuilder builder = triangle_document();
    builder.json["nodes"][0]["extras"]["vkbake"]["bakedLight"] = {{"type", "point"}, {"intensity", 7}};
    builder.json["nodes"][0]["extras"]["vkbake"]["radius"] = 0.5;
    const Scene scene = builder.load();
    ASSERT_EQ(scene.lamps.size(), 1U);
    EXPECT_EQ(scene.lamps[0].intensity, 7.0);
    EXPECT_EQ(scene.lamps[0].radius, 0.5);
}

TEST(Lamps, MayBeRequired) {
    DocumentBuilder builder = lit_document(Json::array({light_of("point")}));
    builder.json["extensionsRequired"] = {"KHR_lights_punctual"};
    EXPECT_EQ(builder.load().lamps.size(), 1U);
}

TEST(Lamps, FaultsAreRefusedByName) {
    const auto refused = [](const auto& change, const std::string& part) {
        DocumentBuilder builder = lit_document({light_of("spot"), light_of("directional")});
        change(builder.json["extensions"]["KHR_lights_punctual"]["lights"], builder.json["nodes"]);
        expect_refused(builder, part);
    };
    refused([](Json& l, Json&) { l[0]["type"] = "area"; }, "\"type\" is \"area\"");
    refused([](Json& l, Json&) { l[1].erase("type"); }, "\"type\" is missing (light 1)");
    refused([](Json& l, Json&) { l[0]["intensity"] = -1; }, "\"intensity\" is below 0");
    refused([](Json& l, Json&) { l[0]["intensity"] = "bright"; }, "\"intensity\" is not a");
    refused([](Json& l, Json&) { l[0]["color"] = {1, 1}; }, "\"color\" is not an array of 3 numbers");
    refused([](Json& l, Json&) { l[0]["color"] = {1, -1, 1}; }, "\"color\" holds a number below 0");
    refused([](Json& l, Json&) { l[0]["range"] = 0; }, "\"range\" is not above 0");
    refused([](Json& l, Json&) { l[0]["spot"] = {{"outerConeAngle", 1.6}}; }, "\"outerConeAngle\"");
    refused(
        [](Json& l, Json&) {
            l[0]["spot"] = {{"innerConeAngle", 1.0}, {"outerConeAngle", 0.9}};
        },
        "\"innerConeAngle\" is greater");
    refused([](Json& l, Json&) { l[0]["extras"]["vkbake"]["radius"] = -0.1; }, "\"radius\" is below 0");
    refused([](Json& l, Json&) { l[1]["extras"]["vkbake"]["angularDiameter"] = 91; }, "above 90 degrees");
    refused([](Json& l, Json&) { l = 5; }, "\"lights\" is missing, or not an array");
    refused([](Json&, Json& n) { n[1]["extensions"]["KHR_lights_punctual"]["light"] = 2; },
            "\"light\" names number 2 of 2 (node 1)");
    refused([](Json&, Json& n) { n[1]["extensions"]["KHR_lights_punctual"] = Json::object(); }, "\"light\"");
}

} // namespace
} // namespace vkbake::test
