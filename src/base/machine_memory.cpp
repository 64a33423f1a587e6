#include "base/machine_memory.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace vkbake {
namespace {

/// The least limit that the files of that name hold in `group` and the groups above it, up to `root`. A file that is
/// not there or holds no number ("max") limits nothing.
std::uint64_t group_limit(const std::filesystem::path& root, const std::string& group, const char* file) {
    std::uint64_t least = UINT64_MAX;
    for (std::filesystem::path below = std::filesystem::path(group).relative_path();; below = below.parent_path()) {
        std::uint64_t limit = 0;
        if (std::ifstream(root / below / file) >> limit) {
            least = std::min(least, limit);
        }
        if (below.empty()) {
            return least;
        }
    }
}

} // namespace

std::uint64_t machine_memory() {
    std::uint64_t bytes =
        static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    std::ifstream groups("/proc/self/cgroup"); // lines of number:controllers:path
    for (std::string line; std::getline(groups, line);) {
        const std::size_t first = line.find(':');
        const std::size_t second = line.find(':', first + 1);
        if (first == std::string::npos || second == std::string::npos) {
            continue;
        }
        const std::string controllers = line.substr(first + 1, second - first - 1);
        const std::string group = line.substr(second + 1);
        if (controllers.empty()) {
            bytes = std::min(bytes, group_limit("/sys/fs/cgroup", group, "memory.max"));
        } else if (controllers == "memory") {
            bytes = std::min(bytes, group_limit("/sys/fs/cgroup/memory", group, "memory.limit_in_bytes"));
        }
    }
    return bytes;
}

} // namespace vkbake
