// Node hierarchies, scenes and cameras.
#include <cmath>
#include <numbers>

#include <glm/matrix.hpp>

#include "amount.hpp"
#include "document_builder.hpp"

namespace vkbake::test {
namespace {

void expect_near(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance = 1e-12) {
    for (glm::length_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(actual[i], expected[i], tolerance) << "component " << i;
    }
}

glm::dvec3 apply(const Instance& instance, const glm::dvec3& point) {
    return instance.linear * point + instance.translation;
}

TEST(Nodes, TransformsComposeOverParents) {
    DocumentBuilder builder = triangle_document();
    // Node 0 shows the mesh. Node 1: turns by 90° about +Y and moves; node 2: scales unevenly, and holds node 1.
    const double half = std::numbers::sqrt2 / 2.0;
    builder.json["nodes"][0]["translation"] = {1, 0, 0};
    builder.json["nodes"].push_back({{"children", {0}}, {"rotation", {0, half, 0, half}}, {"translation", {0, 5, 0}}});
    builder.json["nodes"].push_back({{"children", {1}}, {"scale", {2, 3, 4}}, {"name", "top"}});
    builder.json["scenes"][0]["nodes"] = {2};
    const Scene scene = builder.load();
    ASSERT_EQ(scene.instances.size(), 1U);
    // By hand: (x, y, z) → (x+1, y, z) → rotation (x, z) → (z, −x): (z, y, −x−1) → +5 in y → scaled.
    expect_near(apply(scene.instances[0], {0.5, 0.25, 0.125}), {2 * 0.125, 3 * 5.25, 4 * -1.5});
    EXPECT_EQ(scene.instances[0].name, "node 0");
    EXPECT_EQ(scene.instances[0].source_node, 0U);
}

TEST(Nodes, MatricesAreColumnMajor) {
    DocumentBuilder builder = triangle_document();
    builder.json["nodes"][0]["matrix"] = {1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 10, 0, 20, 30, 40, 1};
    const Scene scene = builder.load();
    expect_near(apply(scene.instances[0], {1, 10, 100}), {1 + 40 + 700 + 20, 2 + 50 + 800 + 30, 3 + 60 + 1000 + 40});
}

TEST(Nodes, MayBePlacesOfLightProbes) {
    DocumentBuilder builder = triangle_document();
    builder.json["nodes"][0]["translation"] = {1, 0, 0};
    builder.json["nodes"][0]["children"] = {1, 2, 3};
    builder.json["nodes"].push_back(
        {{"name", "hall"}, {"translation", {0, 2, 0}}, {"extras", {{"vkbake", {{"probe", true}}}}}});
    builder.json["nodes"].push_back({{"extras", {{"vkbake", {{"probe", false}}}}}});
    builder.json["nodes"].push_back({{"extras", {{"vkbake", {{"probe", {{"zone", 3}}}}}}}});
    const Scene scene = builder.load();
    ASSERT_EQ(scene.probes.size(), 2U);
    EXPECT_EQ(scene.probes[0].name, "hall");
    expect_near(scene.probes[0].position, {1, 2, 0});
    EXPECT_EQ(scene.probes[1].name, "node 3");
    EXPECT_EQ(scene.probes[1].source_node, 3U);
}

TEST(Nodes, QuaternionsNeedNoUnitLength) {
    DocumentBuilder builder = triangle_document();
    builder.json["nodes"][0]["rotation"] = {0, 0, 3e-200, 3e-200}; // 90° about +Z
    const Scene scene = builder.load();
    expect_near(apply(scene.instances[0], {1, 0, 0}), {0, 1, 0});
    EXPECT_NEAR(glm::determinant(scene.instances[0].linear), 1.0, 1e-15);
}

TEST(Nodes, NegativeScaleKeepsItsDeterminant) {
    DocumentBuilder builder = triangle_document();
    builder.json["nodes"][0]["scale"] = {-1, 2, 3};
    const Scene scene = builder.load();
    EXPECT_EQ(glm::determinant(scene.instances[0].linear), -6.0);
    EXPECT_EQ(scene.meshes[0].primitives[0].indices, (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(Nodes, TranslationsKeepDoublePrecision) {
    DocumentBuilder builder = triangle_document();
    builder.json["nodes"][0]["translation"] = {1e-3, 0, 0};
    builder.json["nodes"].push_back({{"children", {0}}, {"translation", {1e9, 0, 0}}});
    builder.json["scenes"][0]["nodes"] = {1};
    EXPECT_EQ(builder.load().instances[0].translation.x, 1e9 + 1e-3);
}

TEST(Nodes, InstancesComeInDocumentOrderDepthFirst) {
    DocumentBuilder builder = triangle_document();
    builder.json["nodes"] = Json::array({{{"name", "a"}, {"mesh", 0}, {"children", {3, 1}}},
                                         {{"name", "b"}, {"mesh", 0}},
                                         {{"name", "c"}, {"mesh", 0}},
                                         {{"name", "d"}, {"mesh", 0}},
                                         {{"name", "not in the scene"}, {"mesh", 0}}});
    builder.json["scenes"][0]["nodes"] = {2, 0};
    std::string order;
    for (const Instance& instance : builder.load().instances) {
        order += instance.name;
    }
    EXPECT_EQ(order, "cadb");
}

TEST(Nodes, ScenesAreChosenWithANote) {
    DocumentBuilder builder = triangle_document();
    builder.json["nodes"].push_back({{"mesh", 0}, {"name", "second"}});
    builder.json["scenes"].push_back({{"nodes", {1}}});
    builder.json["scene"] = 1;
    EXPECT_EQ(builder.load().instances.at(0).name, "second");
    builder.json.erase("scene");
    const Scene first = builder.load();
    EXPECT_EQ(first.instances.at(0).name, "node 0");
    EXPECT_TRUE(has_note(first, "no default scene"));
    builder.json.erase("scenes");
    const Scene all = builder.load();
    EXPECT_EQ(all.instances.size(), 2U);
    EXPECT_TRUE(has_note(all, "no scene"));
}

TEST(Nodes, AVeryDeepHierarchyLoads) {
    DocumentBuilder builder = triangle_document();
    constexpr std::size_t depth = amount<std::size_t>(100'000, 10'000);
    for (std::size_t i = 1; i < depth; ++i) {
        builder.json["nodes"].push_back({{"children", {i - 1}}, {"translation", {1, 0, 0}}});
    }
    builder.json["scenes"][0]["nodes"] = {depth - 1};
    EXPECT_EQ(builder.load().instances.at(0).translation.x, static_cast<double>(depth - 1));
}

TEST(Nodes, FaultsAreRefusedByName) {
    const auto refused = [](const auto& change, const std::string& part) {
        DocumentBuilder builder = triangle_document();
        builder.json["nodes"].push_back({{"name", "second"}});
        builder.json["nodes"].push_back({{"name", "third"}});
        change(builder.json, builder.json["nodes"]);
        expect_refused(builder, part);
    };
    refused([](Json&, Json& n) { n[0]["children"] = {0}; }, "cycle of nodes (node 0)");
    refused([](Json&, Json& n) { n[1]["children"] = {2}, n[2]["children"] = {1}; },
            "cycle of nodes (node 1 \"second\")");
    refused([](Json&, Json& n) { n[0]["children"] = {2}, n[1]["children"] = {2}; }, "(node 2 \"third\")");
    refused([](Json&, Json& n) { n[0]["children"] = {1, 1}; }, "child of more than one node");
    refused([](Json&, Json& n) { n[0]["children"] = {3}; }, "holds 3, which is none of the 3");
    refused([](Json&, Json& n) { n[1]["mesh"] = 1; }, "\"mesh\" names number 1 of 1 (node 1 \"second\")");
    refused([](Json&, Json& n) { n[1]["mesh"] = "0"; }, "not an integer");
    refused([](Json&, Json& n) { n[0]["scale"] = {1, 2}; }, "\"scale\" is not an array of 3 numbers");
    refused([](Json&, Json& n) { n[0]["rotation"] = {0, 0, 0, 0}; }, "length 0");
    refused([](Json&, Json& n) { n[0]["matrix"] = std::vector<int>(16, 1); }, "last row");
    refused([](Json&, Json& n) { n[1]["children"] = {0}; }, "no root node (node 0)");
    refused([](Json& j, Json&) { j["scenes"][0]["nodes"] = {0, 0}; }, "lists it twice");
    refused([](Json& j, Json&) { j["scene"] = 1; }, "\"scene\" names number 1 of 1");
}

TEST(Nodes, TransformsThatOverflowAreRefused) {
    DocumentBuilder builder = triangle_document();
    builder.json["nodes"][0]["scale"] = {1e200, 1, 1};
    builder.json["nodes"].push_back({{"children", {0}}, {"scale", {1e200, 1, 1}}});
    builder.json["scenes"][0]["nodes"] = {1};
    expect_refused(builder, "not finite (node 0)");
}

TEST(Cameras, StandInTheWorld) {
    DocumentBuilder builder = triangle_document();
    builder.json["cameras"] = Json::array(
        {{{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.25}}}},
         {{"type", "orthographic"}, {"orthographic", {{"xmag", 3}, {"ymag", 2}, {"znear", 0.5}, {"zfar", 10}}}}});
    const double half = std::numbers::sqrt2 / 2.0;
    builder.json["nodes"].push_back({{"camera", 0}, {"name", "eye"}, {"rotation", {0, half, 0, half}}});
    builder.json["nodes"].push_back({{"children", {1, 3}}, {"scale", {2, 2, 2}}, {"translation", {1, 2, 3}}});
    builder.json["nodes"].push_back({{"camera", 1}, {"translation", {0, 1, 0}}});
    builder.json["scenes"][0]["nodes"] = {2};
    const Scene scene = builder.load();
    ASSERT_EQ(scene.cameras.size(), 2U);
    const Camera& eye = scene.cameras[0];
    EXPECT_EQ(eye.name, "eye");
    expect_near(eye.position, {1, 2, 3});
    expect_near(eye.orientation[0], {0, 0, -1}); // right
    expect_near(eye.orientation[1], {0, 1, 0});  // up
    expect_near(eye.orientation[2], {1, 0, 0});  // backward
    EXPECT_EQ(eye.vertical_field_of_view, 0.7);
    EXPECT_EQ(eye.near_plane, 0.25);
    const Camera& map = scene.cameras[1];
    expect_near(map.position, {1, 4, 3});
    EXPECT_EQ(map.vertical_field_of_view, 0.0);
    EXPECT_EQ(map.vertical_extent, 4.0);
}

} // namespace
} // namespace vkbake::test
