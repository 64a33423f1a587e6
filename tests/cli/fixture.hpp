// What the tests of the program share.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "amount.hpp"
#include "process.hpp"

namespace vkbake::test {

namespace fs = std::filesystem;

inline std::string scene(const std::string& name) { return std::string(VKBAKE_SOURCE_DIR) + "/scenes/" + name; }

/// A folder of its own for each test, empty, removed at the end.
class Cli : public testing::Test {
protected:
    void SetUp() override {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        m_folder = fs::temp_directory_path() / ("vkbake-" + std::string(info->name()) + "-" + std::to_string(getpid()));
        fs::remove_all(m_folder);
        fs::create_directories(m_folder);
    }
    void TearDown() override { fs::remove_all(m_folder); }

    [[nodiscard]] std::string in_folder(const std::string& name) const { return (m_folder / name).string(); }

    /// A quick bake of a small scene into `output`, with further flags.
    [[nodiscard]] Outcome quick_bake(const std::string& output, std::vector<std::string> flags = {}) const {
        std::vector<std::string> arguments{"bake",   scene("test/corner.glb"), "-o",     in_folder(output),
                                           "--size", amount("64", "32"),       "--rays", "32"};
        arguments.insert(arguments.end(), flags.begin(), flags.end());
        return run_vkbake(arguments, {.directory = m_folder.string()});
    }

    fs::path m_folder;
};

inline bool one_line(const std::string& text) {
    return !text.empty() && std::count(text.begin(), text.end(), '\n') == 1 && text.back() == '\n';
}

} // namespace vkbake::test
