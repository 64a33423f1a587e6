// Where lamps go that are in the light maps.
#include <gtest/gtest.h>

#include "write/baked_lamps.hpp"

namespace vkbake {
namespace {

/// Three lights; node 2 lies outside the baked scene.
Json lit_json() {
    return Json::parse(R"({
        "extensionsUsed": ["KHR_materials_unlit", "KHR_lights_punctual"],
        "extensionsRequired": ["KHR_lights_punctual"],
        "extensions": {"KHR_lights_punctual": {"lights": [
            {"type": "spot", "name": "a"}, {"type": "point", "intensity": 5}, {"type": "directional"}]}},
        "nodes": [
            {"extensions": {"KHR_lights_punctual": {"light": 1}}, "extras": {"vkbake": {"radius": 0.5}}},
            {"extensions": {"KHR_lights_punctual": {"light": 0}, "OTHER": {}}, "extras": {"mine": 1}},
            {"extensions": {"KHR_lights_punctual": {"light": 2}}},
            {"name": "bare"}]})");
}

std::vector<Lamp> lamps_of_nodes(std::initializer_list<std::uint32_t> nodes) {
    std::vector<Lamp> lamps;
    for (const std::uint32_t node : nodes) {
        lamps.push_back({.source_node = node});
    }
    return lamps;
}

TEST(BakedLamps, AreKeptInTheirNodesExtras) {
    Json json = lit_json();
    put_lamps_aside(json, lamps_of_nodes({0, 1}));
    EXPECT_EQ(json["nodes"][0], Json::parse(R"({"extras": {"vkbake": {"radius": 0.5,
        "bakedLight": {"type": "point", "intensity": 5}}}})"));
    EXPECT_EQ(json["nodes"][1], Json::parse(R"({"extensions": {"OTHER": {}}, "extras": {"mine": 1,
        "vkbake": {"bakedLight": {"type": "spot", "name": "a"}}}})"));
    // The light that was not baked lights on, under its new number.
    EXPECT_EQ(json["extensions"]["KHR_lights_punctual"]["lights"], Json::parse(R"([{"type": "directional"}])"));
    EXPECT_EQ(json["nodes"][2]["extensions"]["KHR_lights_punctual"]["light"], 0);
    EXPECT_EQ(json["extensionsUsed"].size(), 2U);
}

TEST(BakedLamps, TakeTheExtensionWithThemWhenAllWereBaked) {
    Json json = lit_json();
    put_lamps_aside(json, lamps_of_nodes({0, 1, 2}));
    EXPECT_FALSE(json.contains("extensions"));
    EXPECT_FALSE(json.contains("extensionsRequired"));
    EXPECT_EQ(json["extensionsUsed"], Json::parse(R"(["KHR_materials_unlit"])"));
}

TEST(BakedLamps, ComeBack) {
    Json json = lit_json();
    put_lamps_aside(json, lamps_of_nodes({0, 1, 2}));
    put_lamps_aside(json, lamps_of_nodes({0, 1, 2})); // a baked scene that is baked again keeps them
    bring_lamps_back(json);
    EXPECT_EQ(json["extensions"]["KHR_lights_punctual"]["lights"],
              Json::parse(R"([{"type": "point", "intensity": 5}, {"type": "spot", "name": "a"},
                              {"type": "directional"}])"));
    EXPECT_EQ(json["nodes"][0], Json::parse(R"({"extras": {"vkbake": {"radius": 0.5}},
        "extensions": {"KHR_lights_punctual": {"light": 0}}})"));
    EXPECT_EQ(json["nodes"][1]["extensions"]["KHR_lights_punctual"]["light"], 1);
    EXPECT_FALSE(json["nodes"][1]["extras"].contains("vkbake"));
    EXPECT_FALSE(json["nodes"][2].contains("extras"));
    EXPECT_EQ(json["extensionsUsed"].size(), 2U);
}

TEST(BakedLamps, OfSceneWithoutLampsNothingChanges) {
    Json json = lit_json();
    put_lamps_aside(json, {});
    EXPECT_EQ(json, lit_json());
    bring_lamps_back(json);
    EXPECT_EQ(json, lit_json());
}

} // namespace
} // namespace vkbake
