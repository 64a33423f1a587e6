#include "bench/summary/results.hpp"

#include <algorithm>
#include <fstream>

#include "base/json.hpp"
#include "vkbake/error.hpp"

namespace vkbake::bench {
namespace {

void read_passes(const Json& json, Result& result) {
    for (const Json& pass : json.at("passes")) {
        const auto who = pass.at("who").get<std::string>();
        const bool making = pass.at("pass") == "making included";
        for (const auto& [threads, figures] : pass.at("threads").items()) {
            result.passes[who][making][std::stoi(threads)] = {figures.at("rays_per_second").get<double>(),
                                                              figures.at("ours_to_it").get<double>()};
        }
        if (making) {
            result.thread_gain[who] = pass.at("gain_of_threads").get<double>();
        }
    }
    const auto& by_threads = result.passes.at("ours").at(true);
    result.few = by_threads.begin()->first;
    result.many = by_threads.rbegin()->first;
}

const Json& build_of(const Json& json, const std::string& who, int threads) {
    const Json& builds = json.at("builds");
    const auto found = std::find_if(builds.begin(), builds.end(), [&](const Json& build) {
        return build.at("who") == who && build.at("threads") == threads;
    });
    if (found == builds.end()) {
        throw Error(ErrorKind::bad_input, "no build of " + who);
    }
    return *found;
}

void read_builds(const Json& json, Result& result) {
    const Json& ours = build_of(json, "ours", result.many);
    const Json& robust = build_of(json, "embree robust, high", result.many);
    const Json& fast = build_of(json, "embree fast, high", result.many);
    const auto quotient = [](const Json& a, const Json& b, const char* key) {
        return a.at(key).get<double>() / b.at(key).get<double>();
    };
    result.build_to_robust = quotient(ours, robust, "median_seconds");
    result.build_to_fast = quotient(ours, fast, "median_seconds");
    result.peak_to_embree = quotient(ours, robust, "peak_bytes");
    result.bytes_a_triangle = ours.at("bytes").get<double>() / static_cast<double>(result.triangles);
}

} // namespace

Result read_result(const std::filesystem::path& file) {
    try {
        std::ifstream stream(file);
        const Json json = Json::parse(stream);
        Result result;
        result.scene = json.at("scene").get<std::string>();
        result.commit = json.at("machine").at("commit").get<std::string>();
        result.processor = json.at("machine").at("processor").get<std::string>();
        result.clock = json.at("settings").at("clock").get<std::string>();
        result.size = json.at("settings").at("size").get<int>();
        result.triangles = json.at("triangles").get<std::size_t>();
        result.occluded_share = json.at("occluded_share").get<double>();
        result.ours_wrong = json.at("double_precision").at("ours_wrong").get<std::size_t>();
        result.differences = json.at("differences").at("ours_and_embree_robust").get<std::size_t>();
        read_passes(json, result);
        read_builds(json, result);
        return result;
    } catch (const std::exception& error) {
        throw Error(ErrorKind::bad_input, file.string() + ": not a result of vkbake_bench_rays (" + error.what() +
                                              "); write it again with --json");
    }
}

} // namespace vkbake::bench
