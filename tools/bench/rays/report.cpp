#include "bench/rays/report.hpp"

#include <fmt/format.h>

namespace vkbake::bench {
namespace {

const char* name_of(PassClock clock) { return clock == PassClock::wall ? "wall" : "processor"; }

const char* name_of(Pass pass) { return pass == Pass::ask ? "rays made beforehand" : "making included"; }

void print_passes(const Outcome& outcome, Pass pass) {
    const EntryFigures& first = outcome.entries.front();
    fmt::print("\n| {} |", name_of(pass));
    for (const auto& [threads, rate] : first.rays_per_second) {
        fmt::print(" M rays/s, {} thread{} | ours to it |", threads, threads == 1 ? "" : "s");
    }
    fmt::print(" gain | rays | way |\n|---|");
    for (std::size_t i = 0; i < first.rays_per_second.size(); ++i) {
        fmt::print("---|---|");
    }
    fmt::print("---|---|---|\n");
    for (const EntryFigures& entry : outcome.entries) {
        if (entry.pass != pass) {
            continue;
        }
        fmt::print("| {} |", entry.who);
        for (const auto& [threads, rate] : entry.rays_per_second) {
            fmt::print(" {:.4g} | {:.3g} |", rate / 1e6, entry.ours_to_it.at(threads));
        }
        fmt::print(" {:.2f} | {} | {} |\n", entry.gain, entry.rays, entry.description);
    }
}

void print_builds(const Outcome& outcome) {
    fmt::print(
        "\n| build | threads | ms (median) | bytes a triangle | peak bytes a triangle |\n|---|---|---|---|---|\n");
    const auto triangles = static_cast<double>(outcome.triangles);
    for (const BuildFigures& build : outcome.builds) {
        fmt::print("| {} | {} | {:.1f} | {:.1f} | {:.1f} |\n", build.who, build.threads, 1e3 * median(build.seconds),
                   static_cast<double>(build.bytes) / triangles, static_cast<double>(build.peak_bytes) / triangles);
    }
}

void print_answers(const Outcome& outcome) {
    const Differences& d = outcome.differences;
    const Verdict& v = outcome.verdict;
    fmt::print("\nours, blocks and single rays differ: {}; both passes differ: {}; allocations while tracing: {}\n",
               d.blocks_and_single_rays, d.both_passes, outcome.allocations);
    fmt::print("of {} rays differ: ours and Embree robust {}, Embree fast and robust {}\n", outcome.rays,
               d.ours_and_embree_robust, d.embree_fast_and_robust);
    fmt::print("double precision on {} rays: ours wrong {}, Embree robust wrong {} ({} rays by every triangle: {} "
               "differ)\n",
               v.rays, v.ours_wrong, v.embree_wrong, v.brute_rays, v.brute_differences);
    for (const Disagreement& disagreement : v.disagreements) {
        fmt::print("  {}\n", disagreement.note());
    }
}

Json to_json(const EntryFigures& entry) {
    Json json{{"who", entry.who},
              {"way", entry.description},
              {"pass", name_of(entry.pass)},
              {"rays", entry.rays},
              {"gain_of_threads", entry.gain}};
    for (const auto& [threads, seconds] : entry.seconds) {
        json["threads"][std::to_string(threads)] = {{"rays_per_second", entry.rays_per_second.at(threads)},
                                                    {"ours_to_it", entry.ours_to_it.at(threads)},
                                                    {"seconds", seconds}};
    }
    return json;
}

Json to_json(const BuildFigures& build) {
    return {{"who", build.who},         {"threads", build.threads}, {"median_seconds", median(build.seconds)},
            {"seconds", build.seconds}, {"bytes", build.bytes},     {"peak_bytes", build.peak_bytes}};
}

Json to_json(const Verdict& verdict) {
    Json json{{"rays", verdict.rays},
              {"rays_by_every_triangle", verdict.brute_rays},
              {"differences_by_every_triangle", verdict.brute_differences},
              {"ours_wrong", verdict.ours_wrong},
              {"embree_robust_wrong", verdict.embree_wrong},
              {"notes", Json::array()}};
    for (const Disagreement& disagreement : verdict.disagreements) {
        json["notes"].push_back(disagreement.note());
    }
    return json;
}

} // namespace

void print_outcome(const Options& options, const Outcome& outcome, const Json& machine) {
    fmt::print("{}: {} triangles, {} page{} of {}², {} texels in {} tiles, {} rays a texel\n", outcome.scene,
               outcome.triangles, outcome.pages, outcome.pages == 1 ? "" : "s", options.settings.size, outcome.texels,
               outcome.tiles, options.settings.rays);
    fmt::print("timed: {} rays, {:.1f} % occluded, {:.1f} % of the lanes used; {} rounds, medians of {} time\n",
               outcome.rays, 100.0 * outcome.occluded, 100.0 * outcome.lanes_used, options.repeats,
               name_of(options.clock));
    fmt::print("machine: {}, {} threads, load before {:.2f}, commit {}\n", machine["processor"].get<std::string>(),
               machine["threads"].get<int>(), machine["load_average_before"].get<double>(),
               machine["commit"].get<std::string>());
    print_passes(outcome, Pass::ask);
    print_passes(outcome, Pass::make_and_ask);
    print_builds(outcome);
    print_answers(outcome);
}

Json to_json(const Options& options, const Outcome& outcome, const Json& machine) {
    Json json{{"scene", outcome.scene},
              {"machine", machine},
              {"settings",
               {{"size", options.settings.size},
                {"rays_a_texel", options.settings.rays},
                {"ground", options.ground},
                {"max_rays", options.max_rays},
                {"repeats", options.repeats},
                {"clock", name_of(options.clock)}}},
              {"triangles", outcome.triangles},
              {"pages", outcome.pages},
              {"texels", outcome.texels},
              {"tiles", outcome.tiles},
              {"rays", outcome.rays},
              {"occluded_share", outcome.occluded},
              {"lanes_used", outcome.lanes_used},
              {"allocations_while_tracing", outcome.allocations}};
    if (options.settings.ao_distance) {
        json["settings"]["ao_distance"] = *options.settings.ao_distance;
    }
    for (const EntryFigures& entry : outcome.entries) {
        json["passes"].push_back(to_json(entry));
    }
    for (const WayFigures& way : outcome.embree_ways) {
        json["embree_ways"].push_back(
            {{"way", way.description}, {"pass", name_of(way.pass)}, {"rays_per_second", way.rays_per_second}});
    }
    for (const BuildFigures& build : outcome.builds) {
        json["builds"].push_back(to_json(build));
    }
    json["differences"] = {{"ours_blocks_and_single_rays", outcome.differences.blocks_and_single_rays},
                           {"ours_both_passes", outcome.differences.both_passes},
                           {"ours_and_embree_robust", outcome.differences.ours_and_embree_robust},
                           {"embree_fast_and_robust", outcome.differences.embree_fast_and_robust}};
    json["double_precision"] = to_json(outcome.verdict);
    return json;
}

} // namespace vkbake::bench
