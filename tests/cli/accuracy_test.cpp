// What the user says of accuracy, and what he is told of it.
#include "fixture.hpp"

#include <fstream>
#include <iterator>

#include "vkbake/vkbake.hpp"

namespace vkbake::test {
namespace {

std::string text_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

TEST_F(Cli, GivesTheErrorThatIsAskedForAndWritesIt) {
    const Outcome outcome = run_vkbake({"bake", scene("test/corner.glb"), "-o", in_folder("out"), "--size", "32",
                                        "--target-error", "0.05", "--error-map"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_NE(outcome.out.find("rays a texel"), std::string::npos) << outcome.out;
    const Image errors = read_image(m_folder / "out/lightmaps/lightmap.error.exr");
    const Image rays = read_image(m_folder / "out/lightmaps/lightmap.rays.exr");
    ASSERT_EQ(errors.texels.size(), 32U * 32U);
    for (std::size_t i = 0; i < errors.texels.size(); ++i) {
        EXPECT_EQ(rays.texels[i].x >= 16.0F, rays.coverage[i] == 1.0F);
        EXPECT_EQ(errors.texels[i].x > 0.0F, rays.coverage[i] == 1.0F);
    }
    const std::string manifest = text_of(m_folder / "out/manifest.json");
    for (const char* key :
         {"\"target-error\": 0.05", "\"relative_rmse\"", "\"target_reached\": true", "lightmap.error.exr"}) {
        EXPECT_NE(manifest.find(key), std::string::npos) << key;
    }
}

TEST_F(Cli, DenoisesQuickBakesUnlessToldNotTo) {
    const std::vector<std::string> quick{
        "bake", scene("test/corner.glb"), "-o", in_folder("out"), "--size", "32", "--quality", "draft"};
    ASSERT_EQ(run_vkbake(quick).status, 0);
    const std::string denoised = text_of(m_folder / "out/manifest.json");
    EXPECT_NE(denoised.find("\"denoise\": \"on\""), std::string::npos);
    EXPECT_NE(denoised.find("\"noise_rmse\""), std::string::npos);
    EXPECT_EQ(denoised.find("\"denoised_texels\": 0"), std::string::npos);

    std::vector<std::string> plain = quick;
    plain.insert(plain.begin() + 2, {"--denoise", "off"}); // wherever it stands
    ASSERT_EQ(run_vkbake(plain).status, 0);
    const std::string manifest = text_of(m_folder / "out/manifest.json");
    EXPECT_NE(manifest.find("\"denoise\": \"off\""), std::string::npos);
    EXPECT_EQ(manifest.find("\"noise_rmse\""), std::string::npos);
    EXPECT_NE(manifest.find("\"denoised_texels\": 0"), std::string::npos);
}

TEST_F(Cli, RefusesWhatContradictsAnErrorEstimate) {
    for (const std::vector<std::string>& flags :
         std::vector<std::vector<std::string>>{{"--target-error", "0"},
                                               {"--target-error", "0.01", "--sampler", "thesis"},
                                               {"--error-map", "--rays", "15"},
                                               {"--denoise", "on", "--rays", "15"},
                                               {"--denoise", "on", "--sampler", "uniform"},
                                               {"--time", "5", "--bounces", "1"},
                                               {"--quality", "best"}}) {
        std::vector<std::string> arguments{"bake", scene("test/plane.glb")};
        arguments.insert(arguments.end(), flags.begin(), flags.end());
        const Outcome outcome = run_vkbake(arguments, {.directory = m_folder.string()});
        EXPECT_EQ(outcome.status, 2) << flags[0];
        EXPECT_TRUE(one_line(outcome.error)) << outcome.error;
    }
}

TEST_F(Cli, ShowsTheTrade) {
    const Outcome outcome =
        run_vkbake({"tradeoff", scene("test/plane.glb"), "-o", in_folder("trade"), "--size", "8", "--sky", "clear"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_NE(outcome.out.find("recommended: --"), std::string::npos) << outcome.out;
    const std::string page = text_of(m_folder / "trade/tradeoff.html");
    EXPECT_NE(page.find("<svg"), std::string::npos);
    EXPECT_NE(page.find("data:image/bmp;base64,"), std::string::npos);
    EXPECT_EQ(page.find("src='http"), std::string::npos); // it needs no network
    EXPECT_NE(text_of(m_folder / "trade/tradeoff.json").find("\"color_difference\": "), std::string::npos);
    // The plot's ground is white, the points of even bakes are blue, and letters, of no colour, are dark.
    const Image plot = read_image(m_folder / "trade/tradeoff.png");
    EXPECT_EQ(std::pair(plot.width, plot.height), std::pair(1440, 840));
    EXPECT_EQ(plot.texels[plot.index(2, 2)], glm::vec4(1.0F));
    const auto texels_like = [&](const auto& like) { return std::ranges::count_if(plot.texels, like); };
    EXPECT_GT(texels_like([](const glm::vec4& texel) { return texel.b > 4.0F * texel.r; }), 4 * 50);
    EXPECT_GT(texels_like([](const glm::vec4& texel) { return texel.b == texel.r && texel.b < 0.3F; }), 1000);
    const std::filesystem::directory_iterator files(m_folder / "trade");
    EXPECT_EQ(std::distance(begin(files), end(files)), 4); // what pictures were drawn from is gone
}

} // namespace
} // namespace vkbake::test
