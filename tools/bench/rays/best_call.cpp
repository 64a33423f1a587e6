#include "bench/rays/best_call.hpp"

#include <algorithm>
#include <limits>

namespace vkbake::bench {

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
    std::sort(tried.begin(), tried.end(), [](const TriedCall& a, const TriedCall& b) { return a.seconds < b.seconds; });
    return tried;
}

} // namespace vkbake::bench
