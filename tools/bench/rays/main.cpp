// The benchmark of occlusion rays: loads a scene as a bake does, makes its tiles and rays, and has them answered by
// Embree in its best ways, by our kernels and by the thesis's clusters. See --help.
#include <fstream>

#include <fmt/format.h>

#include "bench/common/machine.hpp"
#include "bench/common/program.hpp"
#include "bench/rays/report.hpp"
#include "vkbake/error.hpp"

namespace {

using namespace vkbake;
using namespace vkbake::bench;

void write(const std::filesystem::path& file, const Json& json) {
    if (file.has_parent_path()) {
        std::filesystem::create_directories(file.parent_path());
    }
    std::ofstream stream(file);
    stream << json.dump(1, '\t') << '\n';
    stream.close();
    if (!stream) {
        throw Error(ErrorKind::output, file.string() + ": cannot be written; check that the folder is writable");
    }
}

int run(int argument_count, char** arguments) {
    const std::optional<Options> options = parse_options(argument_count, arguments);
    if (!options) {
        return 0;
    }
    const Json machine = describe_machine(); // before there is any load of our own
    const Outcome outcome = run_contest(*options);
    print_outcome(*options, outcome, machine);
    if (!options->json.empty()) {
        write(options->json, to_json(*options, outcome, machine));
    }
    return 0;
}

} // namespace

int main(int argument_count, char** arguments) {
    return run_program("vkbake_bench_rays", [&] { return run(argument_count, arguments); });
}
