#include <cstdlib>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "glb_reader.hpp"
#include "small_scene.hpp"
#include "test_folder.hpp"
#include "vkbake/vkbake.hpp"
#include "write/hash.hpp"
#include "write/manifest.hpp"

namespace vkbake {
namespace {

using test::make_bake;
using test::make_scene;
using test::read_file;
using test::TestFolder;

std::map<std::string, std::vector<std::uint8_t>> contents(const std::filesystem::path& folder) {
    std::map<std::string, std::vector<std::uint8_t>> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) {
            files[std::filesystem::relative(entry.path(), folder).string()] = read_file(entry.path());
        }
    }
    return files;
}

ErrorKind kind_of(const std::function<void()>& work) {
    try {
        work();
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        return error.kind();
    }
    ADD_FAILURE() << "nothing was thrown";
    return ErrorKind::usage;
}

TEST(WriteBake, WritesWhatItSaysManifestLast) {
    const TestFolder folder;
    const auto files = write_bake(make_scene(), make_bake(), {folder / "out", LightMapFormat::exr, "vkbake bake room"});
    const std::vector<std::filesystem::path> expected{"lightmaps/page-0.exr", "lightmaps/page-1.exr", "room.glb",
                                                      "manifest.json"};
    EXPECT_EQ(files, expected);
    EXPECT_EQ(contents(folder / "out").size(), 4U);
    const Image image = read_image(folder / "out/lightmaps/page-0.exr");
    EXPECT_EQ(image.texels, make_bake().light_maps[0].image.texels);
    EXPECT_EQ(image.coverage, make_bake().light_maps[0].image.coverage);

    const Json manifest = read_manifest(folder / "out");
    EXPECT_EQ(manifest["command"], "vkbake bake room");
    EXPECT_EQ(manifest["sky"], "clear");
    EXPECT_EQ(manifest["settings"]["rays"], 256);
    EXPECT_EQ(manifest["settings"]["ao-distance"], nullptr);
    ASSERT_EQ(manifest["light_maps"].size(), 2U);
    EXPECT_EQ(manifest["light_maps"][0]["coverage"], 0.75); // 6 of 8
    EXPECT_EQ(manifest["light_maps"][0]["file"], "lightmaps/page-0.exr");
    EXPECT_EQ(manifest["timing"]["stages"][0]["seconds"], 1.5);
    EXPECT_EQ(manifest["timing"]["light_maps"][1]["seconds"], 0.125);
    EXPECT_EQ(manifest["notes"][0], "a note of the bake");
    ASSERT_EQ(manifest["files"].size(), 3U);
}

// The empty input's XXH3 with 128 bits, as xxHash's specification and `xxhsum -H2` give it.
TEST(Hash, IsXxh3InCanonicalOrder) { EXPECT_EQ(hash_of({}), "99aa06d3014798d86001c324468d497f"); }

TEST(WriteBake, OnlyTimingDiffersBetweenRuns) {
    const TestFolder folder;
    Bake bake = make_bake();
    write_bake(make_scene(), bake, {folder / "a", LightMapFormat::exr, {}});
    bake.stages[0].seconds = 99.0;
    bake.light_maps[0].statistics.seconds = 98.0;
    bake.settings.threads = 7;
    write_bake(make_scene(), bake, {folder / "b", LightMapFormat::exr, {}});
    auto a = contents(folder / "a");
    auto b = contents(folder / "b");
    Json manifest_a = Json::parse(a["manifest.json"]);
    Json manifest_b = Json::parse(b["manifest.json"]);
    EXPECT_NE(manifest_a["timing"], manifest_b["timing"]);
    manifest_a.erase("timing");
    manifest_b.erase("timing");
    EXPECT_EQ(manifest_a.dump(), manifest_b.dump());
    a.erase("manifest.json");
    b.erase("manifest.json");
    EXPECT_EQ(a, b);
}

TEST(WriteBake, OtherFormatsClampAndSay) {
    const TestFolder folder;
    Bake bake = make_bake();
    bake.light_maps[0].image.texels[0].x = std::numeric_limits<float>::quiet_NaN();
    write_bake(make_scene(), bake, {folder / "png", LightMapFormat::png, {}});
    write_bake(make_scene(), bake, {folder / "hdr", LightMapFormat::hdr, {}});
    const Image png = read_image(folder / "png/lightmaps/page-0.png");
    EXPECT_EQ(png.texels[2].x, 1.0F);
    EXPECT_EQ(png.texels[3].x, 1.0F); // 1.5, clamped
    EXPECT_EQ(png.texels[0].x, 0.0F);
    EXPECT_EQ(png.texels[1].w, 0.0F);
    EXPECT_EQ(read_image(folder / "hdr/lightmaps/page-0.hdr").texels[3].x, 1.5F);
    const Json manifest = read_manifest(folder / "png");
    EXPECT_EQ(manifest["light_maps"][0]["values_out_of_range"], 6); // NaN and 1.5, 2 … 3.5
    EXPECT_NE(manifest["notes"].dump().find("clamped"), std::string::npos);
    EXPECT_EQ(read_manifest(folder / "hdr")["light_maps"][0]["values_out_of_range"], 1);
}

TEST(WriteBake, DirectionalMapsLieBesideTheLightMap) {
    const TestFolder folder;
    Bake bake = make_bake();
    LightMap& map = bake.light_maps[0];
    map.directional.assign(4, map.image);
    for (std::size_t i = 0; i < 4; ++i) {
        map.directional[i].coverage.clear();
        map.directional[i].texels[0].g = -1.0F - static_cast<float>(i);
    }
    const auto files = write_bake(make_scene(), bake, {folder.path(), LightMapFormat::exr, {}});
    EXPECT_EQ(files.size(), 8U);
    const std::vector<std::string> names{"lightmaps/page-0.sh0.exr", "lightmaps/page-0.sh1.exr",
                                         "lightmaps/page-0.sh2.exr", "lightmaps/page-0.sh3.exr"};
    for (std::size_t i = 0; i < 4; ++i) {
        const Image image = read_image(folder / names[i]);
        EXPECT_EQ(image.texels, map.directional[i].texels);
        EXPECT_EQ(image.coverage, map.image.coverage);
    }
    const Json manifest = read_manifest(folder.path());
    EXPECT_EQ(manifest["light_maps"][0]["directional_files"], Json(names));
    EXPECT_FALSE(manifest["light_maps"][1].contains("directional_files"));
    const Json document = test::parse_glb(read_file(folder / "room.glb")).json;
    std::size_t referring = 0;
    for (const Json& material : document["materials"]) {
        if (material.contains("extras") && material["extras"].contains("vkbake") &&
            material["extras"]["vkbake"].value("lightMap", "") == "lightmaps/page-0.exr") {
            EXPECT_EQ(material["extras"]["vkbake"]["directional"], Json(names));
            ++referring;
        }
    }
    EXPECT_GT(referring, 0U);
}

TEST(WriteBake, ProbesAreAFileOfTheirOwn) {
    const TestFolder folder;
    Bake bake = make_bake();
    bake.probes.push_back({.name = "hall", .position = {1.0, 2.5, -3.0}, .back_sides = 0.25});
    bake.probes.push_back({});
    bake.probes[0].coefficients[8] = {0.5F, -0.25F, 4.0F};
    bake.probe_grid = ProbeGrid{.counts = {1, 1, 1}, .first_probe = 1, .first = {7, 8, 9}, .step = {2, 2, 2}};
    const auto files = write_bake(make_scene(), bake, {folder.path(), LightMapFormat::exr, {}});
    EXPECT_EQ(files.at(files.size() - 2), "probes.json");
    (void)read_manifest(folder.path());
    const Json json = Json::parse(read_file(folder / "probes.json"));
    ASSERT_EQ(json["probes"].size(), 2U);
    EXPECT_EQ(json["probes"][0]["name"], "hall");
    EXPECT_EQ(json["probes"][0]["position"], Json::array({1.0, 2.5, -3.0}));
    EXPECT_EQ(json["probes"][0]["back_sides"], 0.25);
    ASSERT_EQ(json["probes"][0]["coefficients"].size(), 9U);
    EXPECT_EQ(json["probes"][0]["coefficients"][8], Json::array({0.5, -0.25, 4.0}));
    EXPECT_EQ(json["grid"]["first_probe"], 1);
    EXPECT_EQ(json["grid"]["first"], Json::array({7.0, 8.0, 9.0}));
}

TEST(WriteBake, BentNormalsAreHalvedInAPngAndNotWrittenAsHdr) {
    const TestFolder folder;
    Bake bake = make_bake();
    bake.settings.mode = Mode::bent_normal;
    bake.light_maps[0].image.texels[2] = {-0.6F, 0.0F, 0.8F, 1.0F};
    write_bake(make_scene(), bake, {folder / "exr", LightMapFormat::exr, {}});
    EXPECT_EQ(read_image(folder / "exr/lightmaps/page-0.exr").texels[2], glm::vec4(-0.6F, 0.0F, 0.8F, 1.0F));
    write_bake(make_scene(), bake, {folder / "png", LightMapFormat::png, {}});
    const glm::vec4 halved = read_image(folder / "png/lightmaps/page-0.png").texels[2];
    EXPECT_NEAR(halved.x, 0.2F, 1e-5F);
    EXPECT_NEAR(halved.y, 0.5F, 1e-5F);
    EXPECT_NEAR(halved.z, 0.9F, 1e-5F);
    EXPECT_EQ(kind_of([&] {
                  write_bake(make_scene(), bake, {folder / "hdr", LightMapFormat::hdr, {}});
              }),
              ErrorKind::usage);
    const Json document = test::parse_glb(read_file(folder / "exr/room.glb")).json;
    EXPECT_NE(document.dump().find("\"mode\":\"bent-normal\""), std::string::npos);
    EXPECT_NE(document.dump().find("occlusionTexture"), std::string::npos);
}

TEST(WriteBake, ScenesMadeByHandGiveImagesAndManifest) {
    const TestFolder folder;
    Scene scene = make_scene();
    scene.source.reset();
    EXPECT_EQ(write_bake(scene, make_bake(), {folder.path(), LightMapFormat::exr, {}}).size(), 3U);
}

TEST(WriteBake, AFailedRunChangesNothing) {
    const TestFolder folder;
    write_bake(make_scene(), make_bake(), {folder.path(), LightMapFormat::exr, "first"});
    const auto before = contents(folder.path());
    Scene broken = make_scene();
    broken.source->json = "{}"; // fails after the light maps have been staged
    EXPECT_EQ(kind_of([&] {
                  write_bake(broken, make_bake(), {folder.path(), LightMapFormat::exr, "second"});
              }),
              ErrorKind::bad_input);
    EXPECT_EQ(contents(folder.path()), before);
}

/// Wherever it is told to stop: nothing of it is left, and what stood there stands. When it has been asked for the last
/// time it is done.
TEST(WriteBake, AnInterruptedOneChangesNothing) {
    const TestFolder folder;
    write_bake(make_scene(), make_bake(), {folder.path(), LightMapFormat::exr, "first"});
    const auto before = contents(folder.path());
    for (const LightMapFormat format : {LightMapFormat::exr, LightMapFormat::hdr, LightMapFormat::png}) {
        const auto write = [&](int last, int& asked) {
            double share = 0.0;
            write_bake(make_scene(), make_bake(), {folder.path(), format, "second"}, [&](const ProgressReport& report) {
                EXPECT_EQ(report.stage, "write");
                EXPECT_TRUE(report.share >= share && report.share <= 1.0);
                share = report.share;
                return ++asked < last;
            });
        };
        for (int last = 1;; ++last) {
            int asked = 0;
            try {
                write(last, asked);
                EXPECT_GE(asked, 8); // two maps and their pictures, encoded and stored
                EXPECT_NE(contents(folder.path()), before);
                std::filesystem::remove_all(folder.path());
                write_bake(make_scene(), make_bake(), {folder.path(), LightMapFormat::exr, "first"});
                break;
            } catch (const Error& error) {
                EXPECT_EQ(error.kind(), ErrorKind::interrupted);
                EXPECT_EQ(asked, last);
                EXPECT_EQ(contents(folder.path()), before);
            }
        }
    }
}

/// What a killed bake of the same files has left goes with the next one; what is another's, or of a process that still
/// lives, stays.
TEST(WriteBake, WhatAKilledOneLeftGoesWithTheNext) {
    const TestFolder folder;
    std::filesystem::create_directories(folder / "lightmaps");
    const pid_t gone = fork();
    if (gone == 0) {
        _exit(0);
    }
    ASSERT_EQ(waitpid(gone, nullptr, 0), gone);
    const std::string dead = "." + std::to_string(gone) + ".0.partial";
    const std::vector<std::string> leftovers{"manifest.json" + dead, "room.glb" + dead, "lightmaps/page-0.exr" + dead,
                                             "lightmaps/page-1.exr." + std::to_string(gone) + ".12.partial",
                                             "lightmaps/page-1.exr." + std::to_string(getpid()) + ".0.partial"};
    const std::vector<std::string> others{"notes.txt" + dead,
                                          "lightmaps/page-2.exr" + dead,
                                          "manifest.json." + std::to_string(getppid()) + ".0.partial",
                                          "manifest.json.partial",
                                          "manifest.json.0.0.partial",
                                          "manifest.json.-1.0.partial",
                                          "manifest.json." + std::to_string(gone) + ".partial",
                                          "manifest.json." + std::to_string(gone) + ".0.partial.txt"};
    for (const auto& files : {leftovers, others}) {
        for (const std::string& file : files) {
            std::ofstream(folder / file) << "half";
        }
    }
    write_bake(make_scene(), make_bake(), {folder.path(), LightMapFormat::exr, {}});
    const auto after = contents(folder.path());
    EXPECT_EQ(after.size(), 4U + others.size());
    for (const std::string& file : others) {
        EXPECT_TRUE(after.contains(file)) << file;
    }
}

TEST(WriteBake, AFolderThatCannotBeMade) {
    const TestFolder folder;
    std::ofstream(folder / "file") << "in the way";
    EXPECT_EQ(kind_of([&] {
                  write_bake(make_scene(), make_bake(), {folder / "file" / "out", LightMapFormat::exr, {}});
              }),
              ErrorKind::output);
    EXPECT_EQ(contents(folder.path()).size(), 1U);
}

TEST(WriteBake, TheSourceIsNotOverwrittenUnlessBaked) {
    const TestFolder folder;
    Scene scene = make_scene();
    scene.directory = folder.path().string();
    std::ofstream(folder / "room.glb") << "the source";
    EXPECT_EQ(kind_of([&] {
                  write_bake(scene, make_bake(), {folder.path(), LightMapFormat::exr, {}});
              }),
              ErrorKind::output);
    EXPECT_EQ(contents(folder.path()).size(), 1U);
    Json json = Json::parse(scene.source->json);
    json["asset"]["generator"] = "vkbake 0.0.1";
    scene.source->json = json.dump();
    EXPECT_EQ(write_bake(scene, make_bake(), {folder.path(), LightMapFormat::exr, {}}).size(), 4U);
}

TEST(WriteBake, ABakeThatDoesNotFitItselfIsRefused) {
    const TestFolder folder;
    Bake bake = make_bake();
    bake.atlas.page[0] = 9;
    EXPECT_EQ(kind_of([&] {
                  write_bake(make_scene(), bake, {folder.path(), LightMapFormat::exr, {}});
              }),
              ErrorKind::usage);
    bake = make_bake();
    bake.surface.vertices[0] = 0; // not a triangle of the scene
    EXPECT_EQ(kind_of([&] {
                  write_bake(make_scene(), bake, {folder.path(), LightMapFormat::exr, {}});
              }),
              ErrorKind::usage);
    EXPECT_TRUE(contents(folder.path()).empty());
}

TEST(Manifest, RefusesFilesThatAreNotTheOnesWritten) {
    const TestFolder folder;
    write_bake(make_scene(), make_bake(), {folder.path(), LightMapFormat::exr, {}});
    (void)read_manifest(folder.path());
    const auto rewrite = [&](const char* file, const std::vector<std::uint8_t>& bytes) {
        std::ofstream(folder / file, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    };
    std::vector<std::uint8_t> bytes = read_file(folder / "lightmaps/page-1.exr");
    bytes.back() ^= 1U;
    rewrite("lightmaps/page-1.exr", bytes);
    EXPECT_EQ(kind_of([&] { (void)read_manifest(folder.path()); }), ErrorKind::bad_input);
    bytes.back() ^= 1U;
    rewrite("lightmaps/page-1.exr", bytes);
    (void)read_manifest(folder.path());
    std::filesystem::remove(folder / "room.glb");
    EXPECT_EQ(kind_of([&] { (void)read_manifest(folder.path()); }), ErrorKind::bad_input);
    for (const char* text :
         {"{", "[]", R"({"manifest":99})", R"({"manifest":1,"files":[{"file":"../x","xxh3-128":""}]})"}) {
        std::ofstream(folder / "manifest.json") << text;
        EXPECT_EQ(kind_of([&] { (void)read_manifest(folder.path()); }), ErrorKind::bad_input) << text;
    }
}

/// However right its hash is.
TEST(Manifest, RefusesFilesOutsideItsFolder) {
    const TestFolder folder;
    std::filesystem::create_directories(folder / "bake/maps");
    std::ofstream(folder / "empty") << "";
    for (const std::string& file : {std::string("../empty"), std::string("maps/../../empty"), std::string("./../empty"),
                                    (folder / "empty").string()}) {
        const Json manifest{{"manifest", 1}, {"files", {{{"file", file}, {"xxh3-128", hash_of({})}}}}};
        std::ofstream(folder / "bake/manifest.json") << manifest;
        try {
            (void)read_manifest(folder / "bake");
            ADD_FAILURE() << file << " was read";
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find("lies outside"), std::string::npos) << error.what();
        }
    }
}

// The official validator over both modes, a mesh without any UVs and one baked twice.
TEST(WriteBake, TheOfficialValidatorFindsNoError) {
    const TestFolder folder;
    Bake bake = make_bake();
    write_bake(make_scene(), bake, {folder / "irradiance", LightMapFormat::exr, {}});
    bake.settings.mode = Mode::ao;
    write_bake(make_scene(), bake, {folder / "ao", LightMapFormat::exr, {}});

    Scene bare = make_scene();
    Json json = Json::parse(bare.source->json);
    Json& primitive = json["meshes"][0]["primitives"][1];
    primitive["attributes"] = {{"POSITION", primitive["attributes"]["POSITION"]}};
    primitive.erase("material");
    bare.source->json = json.dump();
    bare.meshes[0].primitives[0].tex_coords = {};
    write_bake(bare, make_bake(), {folder / "bare", LightMapFormat::exr, {}});

    const std::string command = std::string(VKBAKE_SOURCE_DIR) + "/tests/validator/validate.sh " + VKBAKE_VALIDATOR_DIR;
    const int status =
        std::system((command + " " + (folder / "irradiance/room.glb").string() + " " + // NOLINT(cert-env33-c)
                     (folder / "ao/room.glb").string() + " " + (folder / "bare/room.glb").string())
                        .c_str());
    if (WIFEXITED(status) && WEXITSTATUS(status) == 77) {
        GTEST_SKIP() << "the validator is not available here";
    }
    EXPECT_EQ(status, 0);
}

} // namespace
} // namespace vkbake
