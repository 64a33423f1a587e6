#include "bench/common/machine.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <string>

#include "bench/common/timing.hpp"

namespace vkbake::bench {
namespace {

std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("model name")) {
            return line.substr(line.find(':') + 2);
        }
    }
    return "unknown";
}

double load_average() {
    std::array<double, 1> average{};
    return getloadavg(average.data(), 1) == 1 ? average[0] : -1.0;
}

struct ClosePipe {
    void operator()(std::FILE* pipe) const { pclose(pipe); }
};

// A result without its commit cannot be compared with another; one of a changed checkout says so.
std::string commit() {
    const std::unique_ptr<std::FILE, ClosePipe> pipe(popen("git describe --always --dirty 2>/dev/null", "r"));
    std::array<char, 128> text{};
    if (!pipe || std::fgets(text.data(), static_cast<int>(text.size()), pipe.get()) == nullptr) {
        return "unknown";
    }
    std::string name = text.data();
    while (name.ends_with('\n')) {
        name.pop_back();
    }
    return name;
}

} // namespace

Json describe_machine() {
    return {{"processor", processor()},
            {"threads", all_threads()},
            {"load_average_before", load_average()},
            {"commit", commit()},
            {"compiler", __VERSION__}};
}

} // namespace vkbake::bench
