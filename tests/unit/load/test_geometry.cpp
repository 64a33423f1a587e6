// Vertices, indices and topologies.
#include <cmath>
#include <limits>

#include "document_builder.hpp"

namespace vkbake::test {
namespace {

using Indices = std::vector<std::uint32_t>;

const Primitive& only_primitive(const Scene& scene) { return scene.meshes.at(0).primitives.at(0); }

TEST(Geometry, NonIndexedTriangleIsIndexedInOrder) {
    const Scene scene = triangle_document().load();
    const Primitive& primitive = only_primitive(scene);
    ASSERT_EQ(primitive.positions.size(), 3U);
    EXPECT_EQ(primitive.positions[1], glm::vec3(1, 0, 0));
    EXPECT_EQ(primitive.indices, (Indices{0, 1, 2}));
    EXPECT_TRUE(primitive.normals.empty());
    EXPECT_FALSE(primitive.material.has_value());
}

TEST(Geometry, IndicesOfEveryWidth) {
    const auto check = [](auto value) {
        using Value = decltype(value);
        DocumentBuilder builder = triangle_document();
        builder.json["meshes"][0]["primitives"][0]["indices"] = builder.add(std::vector<Value>{2, 0, 1}, "SCALAR");
        const Scene scene = builder.load();
        EXPECT_EQ(only_primitive(scene).indices, (Indices{2, 0, 1}));
    };
    check(std::uint8_t{});
    check(std::uint16_t{});
    check(std::uint32_t{});
}

/// Five vertices in a row of a strip; glTF 2.0 §3.7.2.1 writes the triangles down as p_i.
TEST(Geometry, StripAndFanFollowTheSpecification) {
    const std::vector<float> corners = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 2, 0, 0};
    const auto triangles = [&](int mode) {
        DocumentBuilder builder;
        builder.add_mesh({{"POSITION", builder.add(corners, "VEC3")}}, mode);
        return only_primitive(builder.load()).indices;
    };
    EXPECT_EQ(triangles(5), (Indices{0, 1, 2, 1, 3, 2, 2, 3, 4}));
    EXPECT_EQ(triangles(6), (Indices{1, 2, 0, 2, 3, 0, 3, 4, 0}));
}

TEST(Geometry, IndexedStrip) {
    DocumentBuilder builder = triangle_document();
    Json& primitive = builder.json["meshes"][0]["primitives"][0];
    primitive["mode"] = 5;
    primitive["indices"] = builder.add(std::vector<std::uint16_t>{0, 1, 2, 0}, "SCALAR");
    EXPECT_EQ(only_primitive(builder.load()).indices, (Indices{0, 1, 2, 1, 0, 2}));
}

TEST(Geometry, PointsAndLinesAreSkippedWithANote) {
    for (const int mode : {0, 1, 2, 3}) {
        DocumentBuilder builder = triangle_document();
        Json& primitives = builder.json["meshes"][0]["primitives"];
        primitives[0]["mode"] = mode;
        primitives.push_back({{"attributes", {{"POSITION", 0}}}});
        const Scene scene = builder.load();
        ASSERT_EQ(scene.meshes[0].primitives.size(), 1U);
        EXPECT_EQ(scene.meshes[0].primitives[0].source_primitive, 1U);
        EXPECT_TRUE(has_note(scene, "skipped"));
    }
}

TEST(Geometry, InterleavedVertices) {
    DocumentBuilder builder;
    const std::vector<float> data = {0, 0, 0, /*normal*/ 0, 0, 1, 1, 0, 0, 0, 0, 2, 0, 1, 0, 0, 0, 3};
    const std::size_t view = builder.add_view(raw(data), 24);
    for (const std::size_t offset : {0U, 12U}) {
        builder.json["accessors"].push_back(
            {{"bufferView", view}, {"byteOffset", offset}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}});
    }
    builder.add_mesh({{"POSITION", 0}, {"NORMAL", 1}});
    const Scene scene = builder.load();
    EXPECT_EQ(only_primitive(scene).positions[2], glm::vec3(0, 1, 0));
    EXPECT_EQ(only_primitive(scene).normals[1], glm::vec3(0, 0, 2));
}

TEST(Geometry, NormalisedIntegersFollowTheSpecification) {
    DocumentBuilder builder = triangle_document();
    Json& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
    const std::size_t bytes = builder.add(std::vector<std::uint8_t>{0, 255, 51, 0, 128, 1}, "VEC2", true);
    const std::size_t shorts = builder.add(std::vector<std::uint16_t>{0, 65535, 13107, 0, 1, 2}, "VEC2", true);
    const std::size_t colors = builder.add(std::vector<std::uint8_t>(12, 255), "VEC4", true);
    attributes["TEXCOORD_0"] = bytes;
    attributes["TEXCOORD_1"] = shorts;
    attributes["COLOR_0"] = colors;
    const Scene scene = builder.load();
    const Primitive& primitive = only_primitive(scene);
    EXPECT_EQ(primitive.tex_coords[0][0], glm::vec2(0, 1));
    EXPECT_FLOAT_EQ(primitive.tex_coords[0][1].x, 0.2F);
    EXPECT_FLOAT_EQ(primitive.tex_coords[0][2].x, 128.0F / 255.0F);
    EXPECT_EQ(primitive.tex_coords[1][0], glm::vec2(0, 1));
    EXPECT_FLOAT_EQ(primitive.tex_coords[1][1].x, 0.2F);
    EXPECT_EQ(primitive.colors[2], glm::vec4(1.0F));
    EXPECT_TRUE(primitive.tex_coords[2].empty());
}

TEST(Geometry, QuantisedAttributes) {
    DocumentBuilder builder;
    // Shorts of 8 bytes a vertex, as the extension's alignment rule asks.
    const std::size_t view =
        builder.add_view(raw(std::vector<std::int16_t>{0, 0, 0, 0, 100, 0, -7, 0, 0, 300, 0, 0}), 8);
    builder.json["accessors"].push_back(
        {{"bufferView", view}, {"componentType", 5122}, {"count", 3}, {"type", "VEC3"}});
    const std::size_t normals =
        builder.add_view(std::string("\x00\x00\x7F\x00\x00\x00\x80\x00\x00\x81\x00\x00", 12), 4);
    builder.json["accessors"].push_back(
        {{"bufferView", normals}, {"componentType", 5120}, {"count", 3}, {"type", "VEC3"}, {"normalized", true}});
    builder.add_mesh({{"POSITION", 0}, {"NORMAL", 1}});
    expect_refused(builder, "without KHR_mesh_quantization");
    builder.json["extensionsUsed"] = {"KHR_mesh_quantization"};
    builder.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    const Scene scene = builder.load();
    EXPECT_EQ(only_primitive(scene).positions[1], glm::vec3(100, 0, -7));
    EXPECT_EQ(only_primitive(scene).positions[2], glm::vec3(0, 300, 0));
    EXPECT_EQ(only_primitive(scene).normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(only_primitive(scene).normals[1], glm::vec3(0, 0, -1)); // −128 is clamped
    EXPECT_EQ(only_primitive(scene).normals[2], glm::vec3(0, -1, 0));
    EXPECT_NE(scene.source->json.find("KHR_mesh_quantization"), std::string::npos);
}

TEST(Geometry, SparseValuesReplaceThoseOfTheBase) {
    DocumentBuilder builder = triangle_document();
    const std::size_t indices = builder.add_view(std::string("\x00\x02", 2));
    const std::size_t values = builder.add_view(raw(std::vector<float>{7, 8, 9, -1, -2, -3}));
    builder.json["accessors"][0]["sparse"] = {{"count", 2},
                                              {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                                              {"values", {{"bufferView", values}}}};
    const Scene scene = builder.load();
    EXPECT_EQ(only_primitive(scene).positions[0], glm::vec3(7, 8, 9));
    EXPECT_EQ(only_primitive(scene).positions[1], glm::vec3(1, 0, 0));
    EXPECT_EQ(only_primitive(scene).positions[2], glm::vec3(-1, -2, -3));
    EXPECT_EQ(scene.source->json.find("sparse"), std::string::npos);

    builder.json["accessors"][0].erase("bufferView"); // over zeros
    EXPECT_EQ(only_primitive(builder.load()).positions[1], glm::vec3(0, 0, 0));

    builder.json["accessors"][0]["count"] = 4'000'000'000U;
    expect_refused(builder, "zeros that no file holds");
    builder.json["accessors"][0]["count"] = 2;
    expect_refused(builder, "sparse index 2 is out of range");
}

/// Of an accessor of three elements with two sparse ones.
TEST(Geometry, SparseFaultsAreRefusedByName) {
    const auto refused = [](const auto& change, const std::string& part) {
        DocumentBuilder builder = triangle_document();
        const std::size_t indices = builder.add_view(std::string("\x00\x02", 2));
        const std::size_t values = builder.add_view(raw(std::vector<float>{7, 8, 9, -1, -2, -3}));
        Json& sparse = builder.json["accessors"][0]["sparse"];
        sparse = {{"count", 2},
                  {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                  {"values", {{"bufferView", values}}}};
        change(builder, sparse);
        expect_refused(builder, part);
    };
    refused([](auto&, Json& s) { s["count"] = 0; }, "sparse \"count\" is 0 of 3 elements (accessor 0)");
    refused([](auto&, Json& s) { s["count"] = 4; }, "sparse \"count\" is 4 of 3 elements (accessor 0)");
    refused([](auto&, Json& s) { s["count"] = 3; }, "3 elements from byte 0 on do not fit its bufferView of 2 bytes");
    refused([](auto&, Json& s) { s["indices"]["byteOffset"] = 1; }, "2 elements from byte 1 on do not fit");
    refused([](auto&, Json& s) { s["indices"]["componentType"] = 5125; }, "2 elements from byte 0 on do not fit");
    refused([](auto&, Json& s) { s["indices"]["componentType"] = 5126; }, "not unsigned integers");
    refused([](auto&, Json& s) { s["values"]["byteOffset"] = 4; }, "2 elements from byte 4 on do not fit");
    refused([](auto&, Json& s) { s["indices"]["bufferView"] = 9; }, "names number 9 of 3");
    refused([](auto&, Json& s) { s["values"].erase("bufferView"); }, "\"bufferView\" is missing");
    refused(
        [](auto& b, Json& s) {
            b.json["bufferViews"][s["values"]["bufferView"].template get<std::size_t>()]["byteStride"] = 12;
        },
        "with a byteStride");
    refused([](auto& b, Json&) { b.binary[36] = 2; }, "sparse index 2 does not increase"); // 2, 2
}

TEST(Geometry, BadNormalsAreReplaced) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    DocumentBuilder builder = triangle_document();
    Json& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["NORMAL"] = builder.add(std::vector<float>{0, 0, 0, 1, 0, 0, 1, 0, 0}, "VEC3");
    const Scene one_bad = builder.load();
    EXPECT_EQ(only_primitive(one_bad).normals[0], glm::vec3(0, 0, 1)); // the triangle's own
    EXPECT_EQ(only_primitive(one_bad).normals[1], glm::vec3(1, 0, 0));
    EXPECT_TRUE(has_note(one_bad, "1 of its 3 normals"));

    attributes["NORMAL"] = builder.add(std::vector<float>{0, 0, 0, 1, nan, 0, 1, 0, 0}, "VEC3");
    const Scene most_bad = builder.load();
    EXPECT_TRUE(only_primitive(most_bad).normals.empty());
    EXPECT_TRUE(has_note(most_bad, "flat"));
}

/// A bake can do without them.
TEST(Geometry, TexCoordsAndColoursThatAreNotFiniteAreLeftOutWithANote) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    DocumentBuilder builder = triangle_document();
    Json& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["TEXCOORD_1"] = builder.add(std::vector<float>{0, 0, 1, nan, 0, 1}, "VEC2");
    attributes["COLOR_0"] = builder.add(std::vector<float>{0, 0, 1, infinity, 0, 1, 1, 1, 1}, "VEC3");
    const Scene scene = builder.load();
    EXPECT_TRUE(only_primitive(scene).tex_coords[1].empty());
    EXPECT_TRUE(only_primitive(scene).colors.empty());
    EXPECT_TRUE(has_note(scene, "TEXCOORD_1 holds values that are not finite"));
    EXPECT_TRUE(has_note(scene, "COLOR_0 holds values that are not finite"));
}

TEST(Geometry, FaultsAreRefusedByName) {
    const auto refused = [](const auto& change, const std::string& part) {
        DocumentBuilder builder = triangle_document();
        builder.json["accessors"][0]["name"] = "corners";
        change(builder, builder.json["meshes"][0]["primitives"][0]);
        expect_refused(builder, part);
    };
    const float infinity = std::numeric_limits<float>::infinity();
    refused(
        [](auto& b, Json& p) {
            p["indices"] = b.add(std::vector<std::uint8_t>{0, 1, 3}, "SCALAR");
        },
        "index 3 is none of the 3 vertices (mesh 0, primitive 0, accessor 1)");
    refused(
        [](auto& b, Json& p) {
            p["indices"] = b.add(std::vector<std::uint16_t>{0, 65535, 1}, "SCALAR");
        },
        "primitive restart");
    refused(
        [](auto& b, Json& p) {
            p["indices"] = b.add(std::vector<float>{0, 1, 2}, "SCALAR");
        },
        "unsigned integer type");
    refused([](auto& b, Json& p) { p["attributes"]["NORMAL"] = b.add(std::vector<float>(6, 1.0F), "VEC3"); },
            "NORMAL has 2 vertices, POSITION 3");
    refused([](auto& b, Json& p) { p["attributes"]["NORMAL"] = b.add(std::vector<float>(6, 1.0F), "VEC2"); },
            "NORMAL has");
    refused(
        [&](auto& b, Json& p) {
            p["attributes"]["POSITION"] = b.add(std::vector<float>{0, 0, 0, infinity, 0, 0, 0, 0, 0}, "VEC3");
        },
        "the position of vertex 1 is not finite (mesh 0, primitive 0, accessor 1)");
    refused([](auto&, Json& p) { p["attributes"]["POSITION"] = 9; }, "\"POSITION\" names number 9 of 1");
    refused([](auto&, Json& p) { p["mode"] = 7; }, "\"mode\"");
    refused([](auto& b, Json&) { b.json["accessors"][0]["count"] = 4; },
            "do not fit its bufferView of 36 bytes (accessor 0 \"corners\")");
    refused([](auto& b, Json&) { b.json["accessors"][0]["byteOffset"] = 2; }, "multiple of 4");
    refused([](auto& b, Json&) { b.json["bufferViews"][0]["byteLength"] = 37; },
            "does not fit its buffer of 36 bytes (bufferView 0)");
    refused([](auto& b, Json&) { b.json["bufferViews"][0]["byteOffset"] = 9007199254740991; },
            "does not fit its buffer");
    refused([](auto& b, Json&) { b.json["bufferViews"][0]["byteStride"] = 8; }, "less than the element's size");
    refused([](auto& b, Json&) { b.json["accessors"][0]["componentType"] = 5124; }, "componentType");
    refused([](auto& b, Json&) { b.json["accessors"][0]["count"] = 0; }, "\"count\" is 0");
    refused([](auto& b, Json&) { b.json["accessors"][0]["count"] = "3"; }, "not an integer");
    refused([](auto& b, Json&) { b.json["accessors"][0]["count"] = -3; }, "not an integer");
    refused([](auto& b, Json&) { b.json["accessors"][0]["count"] = (1ULL << 53U) + 1; },
            "not an integer"); // JSON's limit
    refused([](auto& b, Json&) { b.json["buffers"] = Json::array({Json{{"byteLength", 4096}}}); }, "only 36 bytes");
}

TEST(Geometry, AnEmptySceneLoads) {
    const DocumentBuilder builder;
    const Scene scene = builder.load();
    EXPECT_TRUE(scene.meshes.empty());
    EXPECT_TRUE(scene.instances.empty());
    ASSERT_TRUE(scene.source.has_value());
    EXPECT_TRUE(scene.source->binary.empty());
}

} // namespace
} // namespace vkbake::test
