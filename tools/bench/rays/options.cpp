#include "bench/rays/options.hpp"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "bench/common/timing.hpp"
#include "vkbake/error.hpp"

namespace vkbake::bench {

std::optional<Options> parse_options(int argument_count, char** arguments) {
    Options options;
    CLI::App app("The occlusion rays of a bake: M rays/s of Embree, of our kernels and of the thesis's clusters.",
                 "vkbake_bench_rays");
    app.add_option("scene", options.scene, "a glTF file")->required();
    app.add_flag("--ground", options.ground, "put a ground of three times its extent under the scene");
    app.add_option("--size", options.settings.size, "side of the light map");
    app.add_option("--rays", options.settings.rays, "rays a texel");
    app.add_option("--ao-distance", options.settings.ao_distance, "metres beyond which nothing occludes");
    app.add_option("--max-rays", options.max_rays, "rays that are timed, of tiles spread evenly over the map");
    app.add_option("--threads", options.threads, "numbers of threads, separated by commas; 0: all")->delimiter(',');
    app.add_option("--repeats", options.repeats, "passes of each contender, interleaved")->check(CLI::Range(1, 1000));
    app.add_flag_callback(
        "--cpu-time", [&] { options.clock = PassClock::cpu; },
        "count the processor's time instead of the wall's: for machines that others use meanwhile");
    app.add_option("--build-budget", options.build_budget, "seconds of builds for each number of threads");
    app.add_option("--verify", options.verify, "rays that are judged in double precision");
    app.add_option("--verify-brute", options.verify_brute, "rays of these that are asked of every triangle");
    app.add_option("--json", options.json, "file for the results");
    try {
        app.parse(argument_count, arguments);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) {
            app.exit(error);
            return std::nullopt;
        }
        throw Error(ErrorKind::usage, std::string(error.what()) + "; see --help");
    }
    if (options.settings.ao_distance) {
        options.settings.mode = Mode::ao;
    }
    std::replace(options.threads.begin(), options.threads.end(), 0, all_threads());
    std::sort(options.threads.begin(), options.threads.end());
    options.threads.erase(std::unique(options.threads.begin(), options.threads.end()), options.threads.end());
    return options;
}

} // namespace vkbake::bench
