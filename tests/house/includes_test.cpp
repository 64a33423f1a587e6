// Who may include what, held over the tree as it is.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;

struct Include {
    std::string file; ///< relative to the project
    std::string name;
    bool quoted = false;
};

std::vector<fs::path> files_below(const std::string& folder) {
    std::vector<fs::path> files;
    const fs::path root = fs::path(VKBAKE_SOURCE_DIR);
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
        const std::string extension = entry.path().extension().string();
        if (entry.is_regular_file() && (extension == ".cpp" || extension == ".hpp" || extension == ".h")) {
            files.push_back(fs::relative(entry.path(), root));
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<Include> includes_below(const std::string& folder) {
    static const std::regex directive(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
    std::vector<Include> includes;
    for (const fs::path& file : files_below(folder)) {
        std::ifstream stream(fs::path(VKBAKE_SOURCE_DIR) / file);
        std::string line;
        std::smatch match;
        while (std::getline(stream, line)) {
            if (std::regex_search(line, match, directive)) {
                includes.push_back({file.generic_string(), match[2], match[1] == "\""});
            }
        }
    }
    return includes;
}

/// The folder of src that a file lies in; "pipeline" for the files that join the stages.
std::string folder_of(const std::string& file) {
    const std::size_t begin = std::string("src/").size();
    const std::size_t end = file.find('/', begin);
    return end == std::string::npos ? "pipeline" : file.substr(begin, end - begin);
}

const std::set<std::string> stages{"load",  "surface", "atlas", "geometry_image", "material",
                                   "trace", "finish",  "write", "preview"};

/// Beside base, its own folder and the public types.
const std::map<std::string, std::set<std::string>> allowed{
    {"base", {}},
    {"bvh", {}},
    {"codec", {}},
    {"imageio", {"codec"}},
    {"gpu", {}},
    {"load", {"imageio"}},
    {"surface", {}},
    {"atlas", {}},
    {"trace", {"bvh"}},
    {"geometry_image", {"gpu"}},
    {"finish", {"gpu"}},
    {"preview", {"gpu"}},
    {"write", {"imageio"}},
    {"cli", {}},
    {"material", {}},
};

TEST(House, NoFolderIncludesWhatItMayNot) {
    const auto includes = includes_below("src");
    ASSERT_GT(includes.size(), 100U);
    for (const Include& include : includes) {
        const std::string folder = folder_of(include.file);
        const std::size_t slash = include.name.find('/');
        if (!include.quoted || slash == std::string::npos || folder == "pipeline") {
            continue;
        }
        const std::string target = include.name.substr(0, slash);
        if (target == "vkbake" || target == folder) {
            continue;
        }
        ASSERT_TRUE(allowed.contains(folder)) << "src/" << folder << " is not in this test's table";
        EXPECT_TRUE((target == "base" && folder != "cli") || allowed.at(folder).contains(target))
            << include.file << " includes \"" << include.name << '"';
    }
}

TEST(House, NoStageIncludesAnotherStage) {
    for (const Include& include : includes_below("src")) {
        const std::string folder = folder_of(include.file);
        const std::string target = include.name.substr(0, include.name.find('/'));
        EXPECT_FALSE(stages.contains(folder) && target != folder && stages.contains(target))
            << include.file << " includes \"" << include.name << '"';
    }
}

TEST(House, EveryThirdPartyHeaderHasOneHome) {
    /// What a header's name begins with, and the only places below src and include that may name it.
    const std::vector<std::pair<std::string, std::set<std::string>>> homes{
        {"vulkan/", {"src/gpu/", "include/vkbake/vulkan_interop.hpp"}},
        {"OpenImageIO/", {"src/codec/"}},
        {"OpenEXR/", {"src/imageio/"}},
        {"png.h", {"src/imageio/"}},
        {"tiny_gltf", {"src/load/"}},
        {"draco/", {"src/load/"}},
        {"meshoptimizer", {"src/load/"}},
        {"tbb/", {"src/base/parallel."}},
        {"oneapi/", {"src/base/parallel."}},
        {"nlohmann/", {"src/base/json.hpp"}},
        {"hwy/", {"src/base/simd", "src/bvh/", "src/trace/"}},
        {"Eigen/", {"src/atlas/"}},
        {"xxhash", {"src/write/"}},
        {"CLI/", {"src/cli/"}},
        {"fmt/", {"src/cli/"}},
        {"spdlog/", {"src/cli/"}},
        {"embree", {}},
        {"gtest/", {}},
    };
    for (const std::string tree : {"src", "include"}) {
        for (const Include& include : includes_below(tree)) {
            for (const auto& [prefix, places] : homes) {
                if (include.name.starts_with(prefix)) {
                    EXPECT_TRUE(std::any_of(places.begin(), places.end(),
                                            [&](const std::string& place) { return include.file.starts_with(place); }))
                        << include.file << " includes <" << include.name << '>';
                }
            }
        }
    }
}

TEST(House, ThePublicHeadersNameNothingInside) {
    for (const Include& include : includes_below("include")) {
        EXPECT_TRUE(!include.quoted || include.name.starts_with("vkbake/"))
            << include.file << " includes \"" << include.name << '"';
    }
}

TEST(House, FilesAreShort) {
    for (const std::string tree : {"src", "include"}) {
        for (const fs::path& file : files_below(tree)) {
            std::ifstream stream(fs::path(VKBAKE_SOURCE_DIR) / file);
            std::string line;
            int lines = 0;
            while (std::getline(stream, line)) {
                ++lines;
            }
            EXPECT_LE(lines, 400) << file.generic_string() << " has " << lines << " lines";
        }
    }
}

} // namespace
