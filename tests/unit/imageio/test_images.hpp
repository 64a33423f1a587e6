// What the tests of this folder share.
#pragma once

#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "vkbake/error.hpp"
#include "vkbake/image.hpp"

namespace vkbake::test {

/// A folder of its own for the running test, removed at the end.
class TemporaryFolder {
public:
    TemporaryFolder() {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        m_path = std::filesystem::temp_directory_path() / ("vkbake-" + std::string(info->test_suite_name()) + "-" +
                                                           info->name() + "-" + std::to_string(getpid()));
        std::filesystem::create_directories(m_path);
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(m_path, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return m_path / name; }
    [[nodiscard]] const std::filesystem::path& path() const { return m_path; }

private:
    std::filesystem::path m_path;
};

inline Image filled(int width, int height, const glm::vec4& texel) {
    Image image{width, height, {}, {}};
    image.texels.assign(image.index(0, height), texel);
    return image;
}

/// Calls `work`, which must throw an Error of that kind; returns its message.
template<typename Work>
std::string message_of(ErrorKind kind, const Work& work) {
    try {
        work();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), kind) << error.what();
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        return error.what();
    }
    ADD_FAILURE() << "nothing was thrown";
    return {};
}

} // namespace vkbake::test
