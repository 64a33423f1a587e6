// Which of Embree's ways is best on some rays.
#pragma once

#include <memory>
#include <vector>

#include "bench/rays/embree_contender.hpp"

namespace vkbake::bench {

struct TriedCall {
    const EmbreeScene* scene = nullptr;
    EmbreeCall call;
    double seconds =
        0.0; ///< of the processor's time; of the finalists the median, of the others the least of the tries
};

/// Tries every call on every scene, on one thread, `tries` times over; those that did best run off against each other.
/// The fastest comes first.
[[nodiscard]] std::vector<TriedCall> try_calls(const std::vector<const EmbreeScene*>& scenes, const RaySet& rays,
                                               Pass pass, int tries);

} // namespace vkbake::bench
