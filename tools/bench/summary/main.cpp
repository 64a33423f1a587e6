// One table of many results of vkbake_bench_rays, with geometric means; and the plot of a family of scenes.
//
//     vkbake_bench_summary RESULT.json… [--plot FILE.svg --family forest-]
#include <cmath>
#include <fstream>
#include <functional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "bench/common/program.hpp"
#include "bench/summary/results.hpp"
#include "bench/summary/scaling_plot.hpp"
#include "vkbake/error.hpp"

namespace {

using namespace vkbake;
using namespace vkbake::bench;

struct Column {
    std::string title;
    std::function<double(const Result&)> value;
    bool averaged = true; ///< has a geometric mean
};

std::vector<Column> columns(bool many_threads) {
    const auto threads = [many_threads](const Result& r) { return many_threads ? r.many : r.few; };
    const auto rate = [threads](const std::string& who) {
        return [=](const Result& r) { return r.passes.at(who).at(true).at(threads(r)).rays_per_second / 1e6; };
    };
    const auto ratio = [threads](const std::string& who, bool making) {
        return [=](const Result& r) { return r.ratio(who, making, threads(r)); };
    };
    std::vector<Column> all{{"ours, M rays/s", rate("ours")},
                            {"Embree robust", rate("embree robust")},
                            {"Embree fast", rate("embree fast")},
                            {"**to robust**", ratio("embree robust", true)},
                            {"to fast", ratio("embree fast", true)},
                            {"to robust, asking alone", ratio("embree robust", false)},
                            {"to fast, asking alone", ratio("embree fast", false)},
                            {"making / all", ratio("making rays alone", true)}};
    if (many_threads) {
        all.push_back({"gain of threads, ours", [](const Result& r) { return r.thread_gain.at("ours"); }});
        all.push_back({"Embree robust's", [](const Result& r) { return r.thread_gain.at("embree robust"); }});
    } else {
        all.push_back({"to thesis", ratio("thesis's clusters", false)});
        all.push_back({"thesis / Embree fast", [threads](const Result& r) {
                           return r.ratio("embree fast", false, threads(r)) /
                                  r.ratio("thesis's clusters", false, threads(r));
                       }});
    }
    return all;
}

std::vector<Column> build_columns() {
    return {{"build, to robust HIGH", [](const Result& r) { return r.build_to_robust; }},
            {"to fast HIGH", [](const Result& r) { return r.build_to_fast; }},
            {"bytes a triangle", [](const Result& r) { return r.bytes_a_triangle; }},
            {"peak, to Embree's", [](const Result& r) { return r.peak_to_embree; }},
            {"differ from Embree robust", [](const Result& r) { return static_cast<double>(r.differences); }, false},
            {"wrong by doubles", [](const Result& r) { return static_cast<double>(r.ours_wrong); }, false}};
}

void print_table(const std::string& title, const std::vector<Result>& results, const std::vector<Column>& shown) {
    fmt::print("\n{}\n\n| scene | triangles | map | occluded |", title);
    for (const Column& column : shown) {
        fmt::print(" {} |", column.title);
    }
    fmt::print("\n|---|---|---|---|");
    for (std::size_t i = 0; i < shown.size(); ++i) {
        fmt::print("---|");
    }
    fmt::print("\n");
    for (const Result& result : results) {
        fmt::print("| {} | {} | {}² | {:.0f} % |", result.scene, result.triangles, result.size,
                   100.0 * result.occluded_share);
        for (const Column& column : shown) {
            fmt::print(" {:.3g} |", column.value(result));
        }
        fmt::print("\n");
    }
    fmt::print("| geometric mean | | | |");
    for (const Column& column : shown) {
        double logarithms = 0.0;
        for (const Result& result : results) {
            logarithms += std::log(column.value(result));
        }
        fmt::print("{}", column.averaged
                             ? fmt::format(" {:.3g} |", std::exp(logarithms / static_cast<double>(results.size())))
                             : " |");
    }
    fmt::print("\n");
}

void write_plot(const std::string& file, const std::string& family, const std::vector<Result>& results) {
    std::vector<Result> members;
    for (const Result& result : results) {
        if (result.scene.starts_with(family) && result.size == results.front().size) {
            members.push_back(result);
        }
    }
    if (members.size() < 2) {
        throw Error(ErrorKind::usage, "plot: fewer than two results whose scene begins with " + family);
    }
    std::ofstream stream(file);
    stream << scaling_plot(members);
    stream.close();
    if (!stream) {
        throw Error(ErrorKind::output, file + ": cannot be written; check that the folder is writable");
    }
}

int run(int argument_count, char** arguments) {
    std::vector<std::string> files;
    std::string plot;
    std::string family = "forest-";
    CLI::App app("Results of vkbake_bench_rays in one table.", "vkbake_bench_summary");
    app.add_option("results", files, "files that --json has written")->required();
    app.add_option("--plot", plot, "SVG file: time a ray against triangles");
    app.add_option("--family", family, "how the names of the plot's scenes begin");
    try {
        app.parse(argument_count, arguments);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : static_cast<int>(ErrorKind::usage);
    }
    std::vector<Result> results;
    results.reserve(files.size());
    for (const std::string& file : files) {
        results.push_back(read_result(file));
    }
    fmt::print(
        "{}. Medians of {} time, commit {}; rates and ratios with rays made on the way where nothing else is said.\n",
        results.front().processor, results.front().clock, results.front().commit);
    print_table(fmt::format("{} thread{}:", results.front().few, results.front().few == 1 ? "" : "s"), results,
                columns(false));
    if (results.front().many != results.front().few) {
        print_table(fmt::format("{} threads:", results.front().many), results, columns(true));
    }
    print_table("Builds and answers:", results, build_columns());
    if (!plot.empty()) {
        write_plot(plot, family, results);
    }
    return 0;
}

} // namespace

int main(int argument_count, char** arguments) {
    return run_program("vkbake_bench_summary", [&] { return run(argument_count, arguments); });
}
