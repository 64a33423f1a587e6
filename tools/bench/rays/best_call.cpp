#include "bench/rays/best_call.hpp"

#include <algorithm>
#include <limits>

namespace vkbake::bench {
namespace {

/// The least of a few tries may be luck. So the first in that order run again, by turns, and the median decides.
constexpr std::size_t finalists = 6;
constexpr int final_rounds = 7;

} // namespace

std::vector<TriedCall> try_calls(const std::vector<const EmbreeScene*>& scenes, const RaySet& rays, Pass pass,
                                 int tries) {
    std::vector<TriedCall> tried;
    for (const EmbreeScene* scene : scenes) {
        for (const EmbreeCall& call : all_calls()) {
            tried.push_back({scene, call, std::numeric_limits<double>::infinity()});
        }
    }
    for (int k = 0; k < tries; ++k) {
        for (TriedCall& entry : tried) {
            const auto contender = make_embree_contender(*entry.scene, entry.call, rays, pass);
            entry.seconds = std::min(entry.seconds, seconds_of(*contender, pass, 1).cpu);
        }
    }
    const auto faster = [](const TriedCall& a, const TriedCall& b) { return a.seconds < b.seconds; };
    std::sort(tried.begin(), tried.end(), faster);
    const auto finalists_end = tried.begin() + static_cast<std::ptrdiff_t>(std::min(finalists, tried.size()));
    std::vector<std::vector<double>> seconds(finalists);
    for (int k = 0; k < final_rounds; ++k) {
        for (auto entry = tried.begin(); entry != finalists_end; ++entry) {
            const auto contender = make_embree_contender(*entry->scene, entry->call, rays, pass);
            seconds[static_cast<std::size_t>(entry - tried.begin())].push_back(seconds_of(*contender, pass, 1).cpu);
        }
    }
    for (auto entry = tried.begin(); entry != finalists_end; ++entry) {
        entry->seconds = median(seconds[static_cast<std::size_t>(entry - tried.begin())]);
    }
    std::sort(tried.begin(), finalists_end, faster);
    return tried;
}

} // namespace vkbake::bench
