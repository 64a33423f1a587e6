// The accelerators of the thesis's §2.3.3 and ours: how long each takes to build, what it holds, how many rays a second
// it answers on one thread; and that all answer alike. Writes the tables in Markdown.
#include <chrono>
#include <cstdio>
#include <fstream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "bench/accelerators/candidates.hpp"
#include "bench/common/affordable.hpp"
#include "bench/common/machine.hpp"
#include "bench/common/measure.hpp"
#include "bench/common/program.hpp"
#include "vkbake/error.hpp"

namespace {

using namespace vkbake;
using namespace vkbake::bench;

constexpr double pass_seconds = 0.2;
constexpr std::string_view ground_suffix = "+ground";

struct Options {
    std::vector<std::string> scenes;
    Settings settings{.size = 256};
    std::size_t max_rays = 300'000;
    int repeats = 3;
    PassClock clock = PassClock::wall;
    std::string markdown;
};

struct Figures {
    double build_seconds = 0.0;
    double bytes_a_triangle = 0.0;
    double rays_per_second = 0.0;
    std::size_t rays = 0;
    std::size_t differences = 0; ///< from our hierarchy's blocks, on the same rays
};

struct Column {
    std::string scene;
    std::size_t triangles = 0;
    std::vector<Figures> rows;
};

std::unique_ptr<Candidate> build(const CandidateKind& kind, const Surface& surface, int repeats, double& seconds) {
    std::vector<double> tries;
    std::unique_ptr<Candidate> candidate;
    for (int k = 0; k < repeats; ++k) {
        candidate.reset();
        const auto start = std::chrono::steady_clock::now();
        candidate = kind.build(surface);
        tries.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    seconds = median(tries);
    return candidate;
}

Column compare(const std::string& file, const Options& options) {
    const bool ground = file.ends_with(ground_suffix);
    const std::string path = ground ? file.substr(0, file.size() - ground_suffix.size()) : file;
    const PreparedScene scene = prepare_scene(path, options.settings, ground);
    const RaySource source(scene);
    const RaySet rays = choose_rays(source, options.max_rays);
    Column column{.scene = scene.name, .triangles = scene.surface.triangle_count()};

    const std::vector<CandidateKind> kinds = all_candidates();
    std::vector<std::unique_ptr<Candidate>> built;
    std::vector<std::unique_ptr<RaySet>> sets;
    std::vector<std::unique_ptr<Contender>> contenders;
    std::vector<Entry> entries;
    for (const CandidateKind& kind : kinds) {
        Figures figures;
        built.push_back(build(kind, scene.surface, options.repeats, figures.build_seconds));
        const Candidate& candidate = *built.back();
        figures.bytes_a_triangle = static_cast<double>(candidate.bytes()) / static_cast<double>(column.triangles);
        sets.push_back(std::make_unique<RaySet>(
            affordable(rays, pass_seconds, [&](const RaySet& some) { return candidate.contender(some); })));
        contenders.push_back(candidate.contender(*sets.back()));
        entries.push_back({kind.name, contenders.back().get(), Pass::ask, {}});
        column.rows.push_back(figures);
    }
    measure(entries, {1}, options.repeats, options.clock);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        column.rows[i].rays = sets[i]->ray_count;
        column.rows[i].rays_per_second = entries[i].rays_per_second(1);
        const std::unique_ptr<Contender> ours = built.back()->contender(*sets[i]);
        (void)seconds_of(*ours, Pass::ask, 1);
        column.rows[i].differences = count_differences(ours->answers(), contenders[i]->answers());
    }
    return column;
}

template<typename Value>
void append_table(std::string& text, const std::string& title, const std::vector<Column>& columns, const Value& value) {
    text += "\n" + title + "\n\n| |";
    for (const Column& column : columns) {
        text += fmt::format(" {} ({}) |", column.scene, column.triangles);
    }
    text += "\n|---|";
    for (std::size_t i = 0; i < columns.size(); ++i) {
        text += "---|";
    }
    const std::vector<CandidateKind> kinds = all_candidates();
    for (std::size_t row = 0; row < kinds.size(); ++row) {
        text += "\n| " + kinds[row].name + " |";
        for (const Column& column : columns) {
            text += fmt::format(" {:.3g} |", value(column.rows[row]));
        }
    }
    text += "\n";
}

std::string tables(const Options& options, const std::vector<Column>& columns, const Json& machine) {
    std::size_t differences = 0;
    for (const Column& column : columns) {
        for (const Figures& figures : column.rows) {
            differences += figures.differences;
        }
    }
    std::string text =
        fmt::format("One thread of {} (load before {:.2f}), commit {}; maps of {}², up to {} rays a scene (for the "
                    "slow ones as many "
                    "as take {} s), medians of {} interleaved rounds of {} time. All with the watertight test; {}.\n",
                    machine["processor"].get<std::string>(), machine["load_average_before"].get<double>(),
                    machine["commit"].get<std::string>(), options.settings.size, options.max_rays, pass_seconds,
                    options.repeats, options.clock == PassClock::wall ? "wall" : "processor",
                    differences == 0 ? "all answers are the same" : fmt::format("{} ANSWERS DIFFER", differences));
    append_table(text, "M rays/s:", columns, [](const Figures& f) { return f.rays_per_second / 1e6; });
    append_table(text, "Build, milliseconds:", columns, [](const Figures& f) { return 1e3 * f.build_seconds; });
    append_table(text, "Bytes a triangle:", columns, [](const Figures& f) { return f.bytes_a_triangle; });
    return text;
}

int run(int argument_count, char** arguments) {
    Options options;
    CLI::App app("Accelerators compared on the rays of a bake.", "vkbake_bench_accelerators");
    app.add_option("scenes", options.scenes, "glTF files; FILE+ground puts a ground under one")->required();
    app.add_option("--size", options.settings.size, "side of the light map");
    app.add_option("--max-rays", options.max_rays, "rays a scene");
    app.add_option("--repeats", options.repeats, "passes of each, interleaved")->check(CLI::Range(1, 1000));
    app.add_flag_callback(
        "--cpu-time", [&] { options.clock = PassClock::cpu; }, "count the processor's time instead of the wall's");
    app.add_option("--markdown", options.markdown, "file for the tables");
    try {
        app.parse(argument_count, arguments);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : static_cast<int>(ErrorKind::usage);
    }
    const Json machine = describe_machine();
    std::vector<Column> columns;
    for (const std::string& scene : options.scenes) {
        columns.push_back(compare(scene, options));
        fmt::print(stderr, "{}: done\n", columns.back().scene);
    }
    const std::string text = tables(options, columns, machine);
    fmt::print("{}", text);
    if (!options.markdown.empty()) {
        std::ofstream stream(options.markdown);
        stream << text;
        stream.close();
        if (!stream) {
            throw Error(ErrorKind::output, options.markdown + ": cannot be written; check that the folder is writable");
        }
    }
    return 0;
}

} // namespace

int main(int argument_count, char** arguments) {
    return run_program("vkbake_bench_accelerators", [&] { return run(argument_count, arguments); });
}
