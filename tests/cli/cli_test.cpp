#include "fixture.hpp"

#include <fstream>

#include "vkbake/vkbake.hpp"

namespace vkbake::test {
namespace {

TEST_F(Cli, HelpAndVersionAreNoErrors) {
    EXPECT_EQ(run_vkbake({"--help"}).status, 0);
    EXPECT_EQ(run_vkbake({"bake", "--help"}).status, 0);
    EXPECT_NE(run_vkbake({"bake", "--help"}).out.find("--ao-distance"), std::string::npos);
    const Outcome version_outcome = run_vkbake({"--version"});
    EXPECT_EQ(version_outcome.status, 0);
    EXPECT_EQ(version_outcome.out, "vkbake " + version() + "\n");
}

TEST_F(Cli, WrongUsageExitsWith2AndOneLine) {
    const std::string plane = scene("test/plane.glb");
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{},
                                               {"bake"},
                                               {"bake", plane, "--sise", "64"},
                                               {"bake", plane, "--size", "0"},
                                               {"bake", plane, "--size", "many"},
                                               {"bake", plane, "--mode", "beautiful"},
                                               {"bake", plane, "--ao-distance", "1"},
                                               {"bake", plane, "--ao-distance", "-1", "--mode", "ao"},
                                               {"bake", plane, "--triangle-test", "moller-trumbore"},
                                               {"unwrap", plane}}) {
        const Outcome outcome = run_vkbake(arguments, {.directory = m_folder.string()});
        EXPECT_EQ(outcome.status, 2) << outcome.error;
        EXPECT_TRUE(one_line(outcome.error)) << outcome.error;
    }
    EXPECT_TRUE(fs::is_empty(m_folder));
}

TEST_F(Cli, BadInputExitsWith3AndNamesTheFile) {
    std::ofstream(m_folder / "broken.glb") << "not a glTF file";
    for (const std::string file : {"missing.glb", "broken.glb"}) {
        const Outcome outcome = run_vkbake({"bake", file}, {.directory = m_folder.string()});
        EXPECT_EQ(outcome.status, 3);
        EXPECT_TRUE(one_line(outcome.error)) << outcome.error;
        EXPECT_NE(outcome.error.find(file), std::string::npos) << outcome.error;
    }
    const Outcome sky =
        run_vkbake({"bake", scene("test/plane.glb"), "--sky", "no.hdr"}, {.directory = m_folder.string()});
    EXPECT_EQ(sky.status, 3);
    EXPECT_NE(sky.error.find("no.hdr"), std::string::npos) << sky.error;
}

TEST_F(Cli, NoDeviceExitsWith4) {
    const Outcome none =
        run_vkbake({"bake", scene("test/plane.glb")},
                   {.directory = m_folder.string(),
                    .environment = {{"VK_ICD_FILENAMES", "/none.json"}, {"VK_DRIVER_FILES", "/none.json"}}});
    EXPECT_EQ(none.status, 4) << none.error;
    EXPECT_TRUE(one_line(none.error)) << none.error;
    EXPECT_EQ(
        run_vkbake({"bake", scene("test/plane.glb"), "--device", "no such"}, {.directory = m_folder.string()}).status,
        4);
}

TEST_F(Cli, OutputThatCannotBeWrittenExitsWith5) {
    std::ofstream(m_folder / "file") << "in the way";
    const Outcome outcome = quick_bake("file/below");
    EXPECT_EQ(outcome.status, 5) << outcome.error;
    EXPECT_TRUE(one_line(outcome.error)) << outcome.error;
}

TEST_F(Cli, BakesInspectsAndRenders) {
    const Outcome baked = quick_bake("out");
    ASSERT_EQ(baked.status, 0) << baked.error;
    for (const std::string file : {"corner.glb", "manifest.json", "lightmaps/lightmap.exr"}) {
        EXPECT_TRUE(fs::exists(m_folder / "out" / file)) << file;
        EXPECT_NE(baked.out.find(file), std::string::npos) << baked.out;
    }
    const Outcome inspected = run_vkbake({"inspect", in_folder("out/corner.glb")});
    EXPECT_EQ(inspected.status, 0) << inspected.error;
    EXPECT_NE(inspected.out.find("lightmaps/lightmap.exr"), std::string::npos) << inspected.out;
    const Outcome rendered =
        run_vkbake({"render", in_folder("out"), "-o", in_folder("a.png"), "--width", "160", "--height", "90"});
    EXPECT_EQ(rendered.status, 0) << rendered.error;
    const Image picture = read_image(m_folder / "a.png");
    EXPECT_EQ(picture.width, 160);
    EXPECT_EQ(picture.height, 90);
    // What was not baked cannot be drawn.
    EXPECT_EQ(run_vkbake({"render", scene("test/corner.glb"), "-o", in_folder("b.png")}).status, 3);
    EXPECT_FALSE(fs::exists(m_folder / "b.png"));
}

TEST_F(Cli, TheSameBytesWhateverTheThreadsAndAccelerator) {
    ASSERT_EQ(quick_bake("a", {"--threads", "1"}).status, 0);
    ASSERT_EQ(quick_bake("b", {"--threads", "2", "--accelerator", "clusters"}).status, 0);
    ASSERT_EQ(quick_bake("c", {"--accelerator", "brute"}).status, 0);
    for (const std::string file : {"lightmaps/lightmap.exr", "corner.glb"}) {
        const std::string bytes = contents(m_folder / "a" / file);
        EXPECT_FALSE(bytes.empty());
        EXPECT_EQ(bytes, contents(m_folder / "b" / file)) << file;
        EXPECT_EQ(bytes, contents(m_folder / "c" / file)) << file;
    }
    ASSERT_EQ(quick_bake("d", {"--seed", "1"}).status, 0);
    EXPECT_NE(contents(m_folder / "a/lightmaps/lightmap.exr"), contents(m_folder / "d/lightmaps/lightmap.exr"));
}

TEST_F(Cli, ComparesAndJudges) {
    ASSERT_EQ(quick_bake("a").status, 0);
    ASSERT_EQ(quick_bake("b", {"--seed", "7"}).status, 0);
    ASSERT_EQ(quick_bake("quarter", {"--size", "16"}).status, 0);
    const std::string a = in_folder("a/lightmaps/lightmap.exr");
    const std::string b = in_folder("b/lightmaps/lightmap.exr");
    EXPECT_EQ(run_vkbake({"compare", a, a, "--max-error", "0"}).status, 0);
    const Outcome loose = run_vkbake({"compare", a, b, "--max-error", "0.5", "--difference", in_folder("d.png")});
    EXPECT_EQ(loose.status, 0) << loose.out << loose.error;
    EXPECT_TRUE(fs::exists(m_folder / "d.png"));
    EXPECT_EQ(run_vkbake({"compare", a, b, "--max-error", "1e-6"}).status, 1);
    EXPECT_EQ(run_vkbake({"compare", a, in_folder("quarter/lightmaps/lightmap.exr")}).status, 3);
    const Outcome json = run_vkbake({"compare", a, b, "--json"});
    EXPECT_EQ(json.out.front(), '{');
    EXPECT_NE(json.out.find("\"relative_root_mean_square\""), std::string::npos);
    EXPECT_NE(json.out.find("\"relative_luminance_rmse\""), std::string::npos);
}

TEST_F(Cli, QuietSaysNothingAndJsonOnlyJson) {
    const Outcome quiet = quick_bake("a", {"--quiet"});
    EXPECT_EQ(quiet.status, 0);
    EXPECT_EQ(quiet.out + quiet.error, "");
    const Outcome json = quick_bake("b", {"--json", "--quiet"});
    ASSERT_FALSE(json.out.empty());
    EXPECT_EQ(json.out.front(), '{');
    EXPECT_EQ(json.out.substr(json.out.size() - 2), "}\n");
}

TEST_F(Cli, ListsDevices) {
    const Outcome outcome = run_vkbake({"devices"});
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_NE(outcome.out.find("will do"), std::string::npos) << outcome.out;
    EXPECT_NE(run_vkbake({"devices", "--json"}).out.find("\"usable\": true"), std::string::npos);
}

} // namespace
} // namespace vkbake::test
