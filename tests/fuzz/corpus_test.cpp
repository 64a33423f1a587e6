// What the fuzzers found worth keeping, read again: each file ends in a value or in a refusal.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include <gtest/gtest.h>

#include "fuzz/readers.hpp"

namespace vkbake::fuzz {
namespace {

void expect_all_read(const char* folder, void (*read)(std::span<const std::uint8_t>)) {
    std::size_t files = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(VKBAKE_SOURCE_DIR) / "tests/fuzz/corpus" / folder)) {
        SCOPED_TRACE(entry.path());
        std::ifstream stream(entry.path(), std::ios::binary);
        const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(stream), {}};
        EXPECT_NO_THROW(read(bytes));
        ++files;
    }
    EXPECT_GT(files, 10U);
}

TEST(Corpus, Scenes) { expect_all_read("scene", read_scene); }
TEST(Corpus, Manifests) { expect_all_read("manifest", read_manifest); }
TEST(Corpus, Skies) { expect_all_read("sky", read_sky); }

} // namespace
} // namespace vkbake::fuzz
