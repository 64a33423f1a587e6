// What README and the pages beside it show is what is compiled and checked in.
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace {

std::string contents(const std::string& file) {
    std::ifstream stream(std::filesystem::path(VKBAKE_SOURCE_DIR) / file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// The lines between those that hold `begin` and `end`, without `indent` leading blanks.
std::string between(const std::string& text, const std::string& begin, const std::string& end, std::size_t indent) {
    std::istringstream stream(text);
    std::string line;
    std::string result;
    bool inside = false;
    while (std::getline(stream, line)) {
        if (inside && line.find(end) != std::string::npos) {
            return result;
        }
        if (inside) {
            result += line.substr(std::min(indent, line.size())) + "\n";
        }
        inside = inside || line.find(begin) != std::string::npos;
    }
    return "";
}

TEST(Readme, TheSampleIsTheOneThatTheConsumerTestRuns) {
    const std::string sample = between(contents("README.md"), "```cpp", "```", 0);
    EXPECT_FALSE(sample.empty());
    EXPECT_EQ(sample, between(contents("tests/consumer/readme.cpp"), "// README begin", "// README end", 4));
}

TEST(Readme, EveryPathItNamesExists) {
    const std::string readme = contents("README.md");
    const std::regex path("[`(]((?:src|docs|tools|tests|scenes)/[A-Za-z0-9_./-]+)");
    int found = 0;
    for (std::sregex_iterator match(readme.begin(), readme.end(), path), end; match != end; ++match, ++found) {
        EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(VKBAKE_SOURCE_DIR) / (*match)[1].str()))
            << (*match)[1];
    }
    EXPECT_GT(found, 5);
}

/// Names of several words without a blank are those of tests, but for people's and formats'; "…" stands for the rest of
/// one.
TEST(Numerics, EveryTestItNamesExists) {
    std::string tests;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(VKBAKE_SOURCE_DIR "/tests")) {
        if (entry.path().extension() == ".cpp") {
            tests += contents(std::filesystem::relative(entry.path(), VKBAKE_SOURCE_DIR).string());
        }
    }
    const std::string page = contents("docs/numerics.md");
    const std::regex name("\\b(?:A[A-Z]|[A-Z])[a-z]+(?:[A-Z][a-z]+)+");
    int found = 0;
    for (std::sregex_iterator match(page.begin(), page.end(), name), end; match != end; ++match, ++found) {
        const std::string text = match->str();
        EXPECT_TRUE(tests.find(", " + text) != std::string::npos || tests.find('(' + text + ',') != std::string::npos)
            << text;
    }
    EXPECT_GT(found, 15);
}

} // namespace
