// Real files: scenes from exporters, and files that Khronos broke on purpose.
#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <set>

#include "document_builder.hpp"

namespace vkbake::test {
namespace {

const std::filesystem::path data_folder = VKBAKE_SHARED_DATA_DIR;

std::string read_text(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::size_t triangle_count(const Scene& scene) {
    std::size_t count = 0;
    for (const Mesh& mesh : scene.meshes) {
        for (const Primitive& primitive : mesh.primitives) {
            count += primitive.indices.size() / 3;
        }
    }
    return count;
}

/// From the accessors' counts in the file's JSON chunk.
std::size_t triangle_count_of_json(const std::filesystem::path& file) {
    const std::string bytes = read_text(file);
    std::uint32_t length = 0;
    std::memcpy(&length, bytes.data() + 12, 4);
    const Json json = Json::parse(bytes.substr(20, length));
    std::size_t count = 0;
    for (const Json& mesh : json["meshes"]) {
        for (const Json& primitive : mesh["primitives"]) {
            EXPECT_EQ(primitive.value("mode", 4), 4);
            const Json& accessor =
                primitive.contains("indices") ? primitive["indices"] : primitive["attributes"]["POSITION"];
            count += json["accessors"][accessor.get<std::size_t>()]["count"].get<std::size_t>() / 3;
        }
    }
    return count;
}

TEST(SharedScenes, LoadWithTheTrianglesThatTheirAccessorsCount) {
    if (!std::filesystem::exists(data_folder / "scenes")) {
        GTEST_SKIP() << "no folder " << data_folder / "scenes";
    }
    const std::map<std::string, std::size_t> scenes = {
        {"suzanne", 15744}, {"bunny", 5696}, {"japanese-bridge-garden", 21883}, {"city-diorama", 102822}};
    for (const auto& [name, triangles] : scenes) {
        const auto file = data_folder / "scenes" / (name + ".glb");
        const Scene scene = load_scene(file);
        EXPECT_EQ(triangle_count(scene), triangles) << name;
        EXPECT_EQ(triangle_count_of_json(file), triangles) << name;
        EXPECT_FALSE(scene.instances.empty()) << name;
    }
}

TEST(SharedScenes, DecompressedPositionsFillTheBoxesThatTheirAccessorsState) {
    if (!std::filesystem::exists(data_folder / "scenes")) {
        GTEST_SKIP() << "no folder " << data_folder / "scenes";
    }
    for (const char* const name : {"japanese-bridge-garden.glb", "city-diorama.glb"}) {
        const Scene scene = load_scene(data_folder / "scenes" / name);
        const Json source = Json::parse(scene.source->json);
        EXPECT_FALSE(source.contains("extensionsRequired")) << name;
        const Json& primitives = source["meshes"][0]["primitives"];
        ASSERT_EQ(primitives.size(), scene.meshes[0].primitives.size());
        for (std::size_t i = 0; i < primitives.size(); ++i) {
            const Json& accessor = source["accessors"][primitives[i]["attributes"]["POSITION"].get<std::size_t>()];
            const auto& positions = scene.meshes[0].primitives[i].positions;
            for (glm::length_t axis = 0; axis < 3; ++axis) {
                const auto [low, high] =
                    std::minmax_element(positions.begin(), positions.end(),
                                        [&](const glm::vec3& a, const glm::vec3& b) { return a[axis] < b[axis]; });
                const auto c = static_cast<std::size_t>(axis);
                EXPECT_FLOAT_EQ((*low)[axis], accessor["min"][c].get<float>());
                EXPECT_FLOAT_EQ((*high)[axis], accessor["max"][c].get<float>());
            }
        }
    }
}

/// The validator calls them errors; a bake takes them, with a note. Each with its reason.
const std::map<std::string, std::string>& accepted_errors() {
    static const std::map<std::string, std::string> files = {
        {"accessor/empty_array.gltf", "an empty array says nothing; it is left out"},
        {"buffer/empty_array.gltf", "an empty array says nothing; it is left out"},
        {"buffer_view/empty_array.gltf", "an empty array says nothing; it is left out"},
        {"image/empty_array.gltf", "an empty array says nothing; it is left out"},
        {"image/invalid_data_uri_mime_type.gltf", "the format is known from the bytes"},
        {"image/invalid_image_data.gltf", "images are decoded only where a bake needs them"},
        {"image/png_eos.gltf", "images are decoded only where a bake needs them"},
    };
    return files;
}

/// The validator finds no error in them, but there is nothing to read; or what no reader knows.
const std::map<std::string, std::string>& refused_without_error() {
    static const std::map<std::string, std::string> files = {
        {"accessor/unknown_type.gltf",
         "a type that glTF does not have: a warning there, as an extension might bring it"},
        {"accessor/valid.gltf", "its sparse accessor is made of a buffer that has neither URI nor chunk"},
        {"buffer/non_relative_uri.gltf", "nothing is fetched from a network: a warning there"},
    };
    return files;
}

/// "/bufferViews/3/byteOffset" → "bufferView 3", as our messages say it; empty where the pointer is to no element.
std::string place_of(const std::string& pointer) {
    static const std::map<std::string, std::string> kinds = {{"accessors", "accessor"}, {"bufferViews", "bufferView"},
                                                             {"buffers", "buffer"},     {"images", "image"},
                                                             {"meshes", "mesh"},        {"nodes", "node"}};
    const std::size_t kind_end = pointer.find('/', 1);
    const auto kind = kinds.find(pointer.substr(std::min<std::size_t>(1, pointer.size()), kind_end - 1));
    if (kind_end == std::string::npos || kind == kinds.end()) {
        return {};
    }
    return kind->second + pointer.substr(kind_end, pointer.find('/', kind_end + 1) - kind_end).replace(0, 1, " ");
}

TEST(InvalidFiles, AreRefusedOrLoadAsTheirReportsSay) {
    const auto folder = data_folder / "invalid-gltf";
    if (!std::filesystem::exists(folder)) {
        GTEST_SKIP() << "no folder " << folder;
    }
    std::size_t refused = 0; // for errors
    std::set<std::string> accepted;
    std::set<std::string> refused_anyway;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const auto& file = entry.path();
        if (file.extension() != ".gltf" && file.extension() != ".glb") {
            continue;
        }
        const std::string name = std::filesystem::relative(file, folder).string();
        const Json report = Json::parse(read_text(file.string() + ".report.json"));
        std::string errors;
        std::set<std::string> places;
        for (const Json& message : report["issues"]["messages"]) {
            if (message["severity"] == 0) {
                errors += message["code"].get<std::string>() + ' ';
                places.insert(place_of(message.value("pointer", "")));
            }
        }
        std::vector<std::string> notes;
        const std::string refusal_line = refusal([&] { notes = load_scene(file).notes; });
        refused += refusal_line.empty() || errors.empty() ? 0 : 1;
        if (refusal_line.empty() && !errors.empty()) {
            accepted.insert(name);
            EXPECT_TRUE(accepted_errors().contains(name)) << name << " loads in spite of " << errors;
        }
        if (!refusal_line.empty() && errors.empty()) {
            refused_anyway.insert(name);
            EXPECT_TRUE(refused_without_error().contains(name)) << name << ": " << refusal_line;
        }
        if (!refusal_line.empty() && !errors.empty()) {
            const bool names_one = std::any_of(places.begin(), places.end(), [&](const std::string& place) {
                return refusal_line.find(place) != std::string::npos;
            });
            EXPECT_TRUE(names_one) << name << " [" << errors << "] " << refusal_line;
        }
        if (std::getenv("VKBAKE_TEST_VERBOSE") != nullptr) {
            std::cout << name << " [" << errors << "] " << (refusal_line.empty() ? "LOADS" : refusal_line) << '\n';
        }
    }
    EXPECT_EQ(refused, 58U);
    EXPECT_EQ(refused_anyway.size(), refused_without_error().size());
    for (const auto& [name, reason] : accepted_errors()) {
        EXPECT_TRUE(accepted.contains(name)) << name << " is listed as accepted, but is not: " << reason;
    }
}

} // namespace
} // namespace vkbake::test
