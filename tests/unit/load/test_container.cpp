// Files: GLB chunks, URIs, JSON, extensions; and what of them is kept.
#include <random>

#include "document_builder.hpp"
#include "load/uri.hpp"

namespace vkbake::test {
namespace {

std::string refusal_of(const std::string& bytes, const std::string& name = "scene.glb") {
    const TemporaryFolder folder;
    const auto file = folder.write(name, bytes);
    return refusal([&] { (void)load_scene(file); });
}

void expect_part(const std::string& message, const std::string& part) {
    EXPECT_NE(message.find(part), std::string::npos) << "message: " << message << "\nexpected in it: " << part;
}

const std::string smallest = R"({"asset":{"version":"2.0"}} )";

TEST(Glb, FaultsAreRefused) {
    EXPECT_EQ(refusal_of(glb_of(chunk("JSON", smallest))), "");
    const std::string bin = chunk(std::string_view("BIN\0", 4), "0123");
    expect_part(refusal_of(""), "not a GLB");
    expect_part(refusal_of("glTF"), "header is cut short");
    expect_part(refusal_of("glTF" + word(1) + word(20) + word(0) + word(0)), "version 1");
    expect_part(refusal_of(glb_of("")), "too short");
    expect_part(refusal_of(glb_of(chunk("JSON", smallest) + "abc")), "header is cut short");
    expect_part(refusal_of(glb_of(chunk("JSON", smallest) + bin + bin)), "second chunk (GLB chunk 2)");
    expect_part(refusal_of(glb_of(bin + chunk("JSON", smallest))), "first chunk is not of type JSON");
    expect_part(refusal_of(glb_of(chunk("JSON", smallest + ' '))), "multiple of 4");
    expect_part(refusal_of(glb_of(word(4000000000U) + "JSON" + smallest)), "longer than what is left");
    expect_part(refusal_of(glb_of(chunk("JSON", smallest)).substr(0, 30)), "but the file has 30");
    EXPECT_EQ(refusal_of(glb_of(chunk("JSON", smallest)) + "tail"), "");
}

TEST(Json, FaultsAreRefused) {
    const auto refused = [](const std::string& text) { return refusal_of(text, "scene.gltf"); };
    EXPECT_EQ(refused(smallest), "");
    expect_part(refused(""), "JSON cannot be read");
    expect_part(refused("[]"), "not an object");
    expect_part(refused("{\"asset\":{\"version\":\"2.0\"},}"), "JSON cannot be read");
    expect_part(refused("{\"asset\":{\"version\":\"2.0\"},\"x\":1e999}"), "JSON cannot be read");
    expect_part(refused("{\"asset\":{\"version\":\"2.0\"},\"x\":\"\xFF\"}"), "JSON cannot be read");
    expect_part(refused("{}"), "\"asset\" is missing");
    expect_part(refused(R"({"asset":{"version":"1.0"}})"), "version \"1.0\"");
    expect_part(refused(R"({"asset":{"version":"2.1","minVersion":"2.1"}})"), "2.1");
    EXPECT_EQ(refused(R"({"asset":{"version":"2.1"}})"), "");
    expect_part(refused(R"({"asset":{"version":"2.0"},"meshes":3})"), "\"meshes\" is not an array");
}

TEST(Json, DeepAndWideDocumentsAreRefused) {
    const std::size_t depth = 1'000'000;
    const std::string deep =
        R"({"asset":{"version":"2.0"},"extras":)" + std::string(depth, '[') + std::string(depth, ']') + '}';
    expect_part(refusal_of(deep, "scene.gltf"), "nested more than 64 deep");
    std::string wide = R"({"asset":{"version":"2.0"})";
    for (int i = 0; i < 100'000; ++i) {
        wide += ",\"" + std::to_string(i) + "\":0";
    }
    expect_part(refusal_of(wide + '}', "scene.gltf"), "more than 4096 keys");
    EXPECT_EQ(refusal_of(R"({"asset":{"version":"2.0"},"extras":"[[[[{{{{:::\\\"]]["})", "scene.gltf"), "");
}

TEST(Extensions, RequiredOnesMustBeSupported) {
    DocumentBuilder builder = triangle_document();
    builder.json["extensionsUsed"] = {"ACME_teapots"};
    const Scene scene = builder.load();
    EXPECT_TRUE(has_note(scene, "ACME_teapots"));
    builder.json["extensionsRequired"] = {"ACME_teapots"};
    expect_refused(builder, "requires the extension ACME_teapots");
}

TEST(Uris, DataUris) {
    const auto text = [](const char* uri) -> std::string {
        const auto data = gltf::decode_data_uri(uri);
        return data ? data->media_type + '|' +
                          std::string(reinterpret_cast<const char*>(data->bytes.data()), data->bytes.size())
                    : "none";
    };
    EXPECT_EQ(text("data:a/b;base64,TWFu"), "a/b|Man"); // RFC 4648 §9's alphabet at work
    EXPECT_EQ(text("data:a/b;base64,TWE="), "a/b|Ma");
    EXPECT_EQ(text("data:a/b;base64,TQ=="), "a/b|M");
    EXPECT_EQ(text("data:a/b;base64,TQ"), "a/b|M");
    EXPECT_EQ(text("data:;base64,"), "|");
    EXPECT_EQ(text("data:a/b;charset=x,a%20b"), "a/b|a b");
    for (const char* const bad :
         {"data:", "data:a/b;base64", "data:a/b;base64,T",
          "data:a/b;base64,TQ=", "data:a/b;base64,T`==", "data:a/b;;base64,TQ==", "data:,%2", "data:,%zz", "date:,x"}) {
        EXPECT_EQ(text(bad), "none") << bad;
    }
}

TEST(Uris, RelativePaths) {
    const auto path = [](const char* uri) { return gltf::relative_path(uri).value_or("none"); };
    EXPECT_EQ(path("a%20b/c.bin"), "a b/c.bin");
    EXPECT_EQ(path("../textures/c.bin"), "../textures/c.bin");
    EXPECT_EQ(path("./a:b"), "./a:b");
    EXPECT_EQ(path("%C3%BC.bin"), "\xC3\xBC.bin");
    for (const char* const bad : {"", "/etc/passwd", "//host/x", "http://host/x", "file:x", "C:\\x", "a\\b",
                                  "%2Fetc/passwd", "a%00b", "a%2", "x?y", "x#y", ":"}) {
        EXPECT_EQ(path(bad), "none") << bad;
    }
}

TEST(Buffers, ExternalFilesAndDataUris) {
    const TemporaryFolder folder;
    DocumentBuilder builder = triangle_document();
    folder.write("data/corners 1.bin", builder.binary + "more than is asked for");
    Json json = builder.json;
    json["buffers"] = Json::array({{{"byteLength", builder.binary.size()}, {"uri", "data/corners%201.bin"}}});
    const Scene external = load_scene(folder.write("scene.gltf", json.dump()));
    EXPECT_EQ(external.meshes[0].primitives[0].positions[1], glm::vec3(1, 0, 0));
    EXPECT_EQ(external.name, "scene");
    EXPECT_EQ(external.directory, folder.path().string());
    const Json source = Json::parse(external.source->json);
    ASSERT_EQ(source["buffers"].size(), 1U);
    EXPECT_FALSE(source["buffers"][0].contains("uri"));
    EXPECT_EQ(source["buffers"][0]["byteLength"], external.source->binary.size());

    // Nine floats: zeros but for a 1 (0x3F800000) in the x of corner 1 and in the y of corner 2.
    json["buffers"][0]["uri"] = "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
    const Scene embedded = load_scene(folder.write("embedded.gltf", json.dump()));
    EXPECT_EQ(embedded.meshes[0].primitives[0].positions[2], glm::vec3(0, 1, 0));

    json["buffers"][0]["uri"] = "data";
    EXPECT_NE(refusal([&] { (void)load_scene(folder.write("folder.gltf", json.dump())); }).find("not a regular file"),
              std::string::npos);
    json["buffers"][0]["uri"] = "data/corners%201.bin";
    json["buffers"][0]["byteLength"] = 4'000'000'000U; // must not be allocated
    EXPECT_NE(refusal([&] { (void)load_scene(folder.write("long.gltf", json.dump())); }).find("there are only"),
              std::string::npos);
    std::filesystem::resize_file(folder.path() / "data/corners 1.bin", 5ULL << 30U); // a hole that takes no disk
    json["buffers"][0]["byteLength"] = 5ULL << 30U;
    EXPECT_NE(refusal([&] { (void)load_scene(folder.write("longer.gltf", json.dump())); }).find("together are larger"),
              std::string::npos);
    EXPECT_NE(refusal([&] { (void)load_scene(folder.path() / "absent.glb"); }).find("not found"), std::string::npos);
    EXPECT_NE(refusal([&] { (void)load_scene(folder.path()); }).find("not a regular file"), std::string::npos);
}

TEST(Source, KeepsWhatABakeDoesNotNeed) {
    DocumentBuilder builder = triangle_document();
    builder.json["extras"] = {{"author", "somebody"}};
    builder.json["nodes"][0]["extras"] = {{"tag", 7}};
    builder.json["extensionsUsed"] = {"ACME_teapots"};
    builder.json["extensions"]["ACME_teapots"] = {{"count", 3}};
    const std::size_t times = builder.add(std::vector<float>{0, 1}, "SCALAR");
    const std::size_t moves = builder.add(std::vector<float>{0, 0, 0, 1, 1, 1}, "VEC3");
    builder.json["animations"] = Json::array(
        {{{"samplers", Json::array({{{"input", times}, {"output", moves}}})},
          {"channels", Json::array({{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}})}}});
    const Scene scene = builder.load();
    const Json source = Json::parse(scene.source->json);
    for (const char* const key :
         {"asset", "extras", "nodes", "extensionsUsed", "extensions", "animations", "accessors", "meshes", "scenes"}) {
        EXPECT_EQ(source[key], builder.json[key]) << key;
    }
    // And it loads again, to the same.
    DocumentBuilder again;
    again.json = source;
    again.binary.assign(reinterpret_cast<const char*>(scene.source->binary.data()), scene.source->binary.size());
    const Scene second = again.load();
    EXPECT_EQ(second.source->json, scene.source->json);
    EXPECT_EQ(second.source->binary, scene.source->binary);
}

/// Bytes flipped, or the end cut off: every outcome but a scene or a refusal is a fault (and a crash under the
/// sanitizers).
TEST(Mutations, EndInASceneOrARefusal) {
    DocumentBuilder builder = triangle_document();
    Json& primitive = builder.json["meshes"][0]["primitives"][0];
    primitive["indices"] = builder.add(std::vector<std::uint16_t>{0, 1, 2}, "SCALAR");
    primitive["attributes"]["NORMAL"] = builder.add(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    const std::size_t indices = builder.add_view(std::string("\x02\x00", 2));
    const std::size_t values = builder.add_view(raw(std::vector<float>{7, 8, 9}));
    builder.json["accessors"][0]["sparse"] = {{"count", 1},
                                              {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                                              {"values", {{"bufferView", values}}}};
    builder.json["images"] = Json::array({{{"uri", "data:image/png;base64,iVBORw0KGgo="}}});
    const std::string valid = builder.glb();
    std::mt19937 random(1); // NOLINT(cert-msc51-cpp): the same mutations every time
    std::size_t refused = 0;
    constexpr int rounds = 1500;
    for (int round = 0; round < rounds; ++round) {
        std::string bytes = valid;
        if (round % 5 == 0) {
            bytes.resize(random() % bytes.size());
        } else {
            for (int flips = 0; flips <= round % 4; ++flips) {
                bytes[random() % bytes.size()] = static_cast<char>(random());
            }
        }
        refused += refusal_of(bytes).empty() ? 0 : 1;
    }
    EXPECT_GT(refused, static_cast<std::size_t>(rounds / 3));
    EXPECT_LT(refused, static_cast<std::size_t>(rounds));
}

} // namespace
} // namespace vkbake::test
