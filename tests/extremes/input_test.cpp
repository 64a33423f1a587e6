// Files that ask for what no file should.
#include <gtest/gtest.h>

#include "host_bake.hpp"
#include "surface/resolution.hpp"
#include "unit/load/document_builder.hpp"

namespace vkbake::test {
namespace {

/// A triangle whose buffer is a file of its own.
Json with_buffer_at(const std::string& uri) {
    DocumentBuilder builder = triangle_document();
    builder.json["buffers"] = Json::array({Json{{"byteLength", builder.binary.size()}, {"uri", uri}}});
    return builder.json;
}

TEST(Input, FilesOutsideTheScenesFolderAreReadOnlyWhereAskedFor) {
    const TemporaryFolder folder;
    const std::string bytes = triangle_document().binary;
    folder.write("secret.bin", bytes);
    folder.write("scene/own.bin", bytes);
    folder.write("scene/parts/own.bin", bytes);
    const auto load = [&](const std::string& uri, bool outside) {
        return load_scene(folder.write("scene/scene.gltf", with_buffer_at(uri).dump()), {.outside_files = outside});
    };
    for (const char* const inside : {"own.bin", "./own.bin", "parts/own.bin", "parts/../own.bin"}) {
        EXPECT_EQ(load(inside, false).meshes.size(), 1U) << inside;
    }
    for (const char* const outside :
         {"../secret.bin", "%2e%2e/secret.bin", "parts/../../secret.bin", "./../secret.bin", "..%2fsecret.bin"}) {
        const std::string message = refusal([&] { (void)load(outside, false); });
        EXPECT_NE(message.find("outside the scene's folder"), std::string::npos) << outside << ": " << message;
        EXPECT_EQ(load(outside, true).meshes.size(), 1U) << outside;
    }
    for (const std::string& absolute : {(folder.path() / "secret.bin").string(), "file://" + folder.path().string(),
                                        std::string("//host/secret.bin"), std::string("%2Fetc/passwd")}) {
        EXPECT_FALSE(refusal([&] { (void)load(absolute, true); }).empty()) << absolute;
    }
}

TEST(Input, ImagesAndLightMapsKeepToTheFolderToo) {
    DocumentBuilder image = triangle_document();
    image.json["images"] = Json::array({Json{{"uri", "../picture.png"}}});
    expect_refused(image, "outside the scene's folder");
    for (const char* const file : {"../map.exr", "/etc/map.exr"}) {
        DocumentBuilder map = triangle_document();
        map.json["images"] = Json::array({Json{{"uri", "data:image/png;base64,iVBORw0KGgo="}}});
        map.json["textures"] = Json::array({Json{{"source", 0}}});
        map.json["materials"] = Json::array(
            {Json{{"extensions", {{"MOZ_lightmap", {{"index", 0}}}}}, {"extras", {{"vkbake", {{"lightMap", file}}}}}}});
        expect_refused(map, "outside the scene's folder");
    }
}

/// Whatever a node is called, a refusal is one short line and an object's name is a file's.
TEST(Input, NamesOfAnyKind) {
    // NOLINTNEXTLINE(bugprone-string-constructor): as long as that
    for (const std::string& name : {std::string(10'000'000, 'n'), std::string("two\nlines\x1b[31m"),
                                    std::string("../../etc/passwd"), std::string()}) {
        Scene scene = scene_of(floor_of(0.5F));
        scene.instances[0].name = name;
        const std::string object = make_surface(scene).objects.at(0).name;
        EXPECT_LE(object.size(), 80U);
        EXPECT_FALSE(object.empty());
        EXPECT_EQ(object.find_first_of("/\n\x1b"), std::string::npos);
        scene.meshes[0].name = name;
        scene.meshes[0].primitives[0].indices.back() = 99;
        const std::string message = refusal([&] { (void)make_surface(scene); });
        EXPECT_LE(message.size(), 1100U);
        EXPECT_NE(message.find("99"), std::string::npos);
        scene.meshes[0].primitives[0].indices.back() = 0;
        scene.instances[0].translation.x = std::numeric_limits<double>::quiet_NaN();
        EXPECT_LE(refusal([&] { (void)make_surface(scene); }).size(), 1100U);
    }
    // What is cut stays UTF-8.
    std::string many;
    for (int i = 0; i < 2000; ++i) {
        many += "\u00e4";
    }
    EXPECT_NO_THROW((void)Json(Error(ErrorKind::usage, "x" + many).what()).dump());
    EXPECT_NO_THROW((void)Json(Error(ErrorKind::usage, many).what()).dump());
    for (const std::string& name : {many, "x" + many}) {
        DocumentBuilder builder = triangle_document();
        builder.json["accessors"][0]["name"] = name;
        builder.json["accessors"][0]["count"] = 0;
        EXPECT_NO_THROW((void)Json(refusal([&] { (void)builder.load(); })).dump());
    }
}

TEST(Input, NumbersThatNoFileCouldHold) {
    struct Case {
        const char* name;
        std::function<void(Json&)> change;
    };
    const std::vector<Case> cases{
        {"2^31 indices",
         [](Json& json) {
             json["accessors"].push_back(
                 {{"bufferView", 0}, {"componentType", 5125}, {"count", 1U << 31U}, {"type", "SCALAR"}});
             json["meshes"][0]["primitives"][0]["indices"] = 1;
         }},
        {"2^53 vertices", [](Json& json) { json["accessors"][0]["count"] = 1ULL << 53U; }},
        {"offset of 2^64", [](Json& json) { json["bufferViews"][0]["byteOffset"] = 18446744073709551608ULL; }},
        {"offset of 2^63", [](Json& json) { json["accessors"][0]["byteOffset"] = 1ULL << 63U; }},
        {"offset of 2^52", [](Json& json) { json["accessors"][0]["byteOffset"] = 1ULL << 52U; }},
        {"stride", [](Json& json) { json["bufferViews"][0]["byteStride"] = 1ULL << 40U; }},
        {"a buffer of 1 TB",
         [](Json& json) {
             json["buffers"] = Json::array({Json{{"byteLength", 1ULL << 40U}}});
         }},
        {"negative count", [](Json& json) { json["accessors"][0]["count"] = -1; }},
        {"a node that is its own child", [](Json& json) { json["nodes"][0]["children"] = {0}; }},
        {"two parents",
         [](Json& json) {
             json["nodes"] = {{{"children", {2}}}, {{"children", {2}}}, {{"mesh", 0}}};
             json["scenes"][0]["nodes"] = {0, 1};
         }},
        {"a cycle of two",
         [](Json& json) {
             json["nodes"] = {{{"mesh", 0}}, {{"children", {2}}}, {{"children", {1}}}};
         }},
        {"a matrix of 1e999", [](Json& json) {
             json["nodes"][0]["scale"] = {1e308, 1e308, 1e308};
             json["nodes"].push_back({{"children", {0}}, {"scale", {1e308, 1.0, 1.0}}});
             json["scenes"][0]["nodes"] = {1};
         }}};
    for (const Case& tried : cases) {
        SCOPED_TRACE(tried.name);
        DocumentBuilder builder = triangle_document();
        tried.change(builder.json);
        EXPECT_FALSE(refusal([&] { (void)builder.load(); }).empty());
    }
}

TEST(Input, SingularTransformsLeaveNothingToBakeOrAPlane) {
    for (const glm::dmat3& flat : {glm::dmat3(0.0), glm::dmat3(1, 0, 0, 0, 0, 0, 0, 0, 0)}) {
        const Scene scene = scene_of(box_of(glm::vec3(-0.5F), glm::vec3(0.5F)), {}, flat);
        const Surface surface = make_surface(scene);
        const std::vector<std::string> notes = check_resolution(scene, surface);
        ASSERT_EQ(notes.size(), 1U);
        EXPECT_NE(notes[0].find("no triangle has area"), std::string::npos) << notes[0];
        EXPECT_NO_THROW((void)bake_on_host(scene, {}, small_settings(8)));
    }
    const Scene plane = scene_of(box_of(glm::vec3(-0.5F), glm::vec3(0.5F)), {}, glm::dmat3(1, 0, 0, 0, 0, 0, 0, 0, 1));
    EXPECT_TRUE(check_resolution(plane, make_surface(plane)).empty());
    EXPECT_EQ(bake_on_host(plane, {}, small_settings(16)).maps.at(0).statistics.occluded_rays, 0U);
}

} // namespace
} // namespace vkbake::test
