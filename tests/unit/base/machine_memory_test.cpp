#include "base/machine_memory.hpp"

#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace vkbake {
namespace {

TEST(MachineMemory, IsNoMoreThanTheKernelCounts) {
    std::ifstream counts("/proc/meminfo");
    std::string word;
    std::uint64_t kibibytes = 0;
    counts >> word >> kibibytes;
    ASSERT_EQ(word, "MemTotal:");
    EXPECT_GT(machine_memory(), 16ULL << 20U); // what runs this test
    EXPECT_LE(machine_memory(), kibibytes << 10U);
}

} // namespace
} // namespace vkbake
