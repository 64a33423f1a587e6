// One scene's contest: who takes part, and what came out.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/common/measure.hpp"
#include "bench/rays/builds.hpp"
#include "bench/rays/options.hpp"
#include "bench/rays/verify.hpp"

namespace vkbake::bench {

/// An entry when all is done, without its contender.
struct EntryFigures {
    std::string who;         ///< "ours", "embree robust", …
    std::string description; ///< which way of it
    Pass pass = Pass::ask;
    std::size_t rays = 0;
    std::map<int, std::vector<double>> seconds;
    std::map<int, double> rays_per_second; ///< by number of threads
    std::map<int, double> ours_to_it;      ///< our blocks' rate to this one's, in the same round
    double gain = 1.0;                     ///< most threads to fewest
};

/// One of Embree's ways in the trial that chose the best: fewer rays, one thread, processor time.
struct WayFigures {
    std::string description;
    Pass pass = Pass::ask;
    double rays_per_second = 0.0;
};

struct Differences {
    std::size_t blocks_and_single_rays = 0; ///< of ours: must be 0
    std::size_t both_passes = 0;            ///< of ours: must be 0
    std::size_t ours_and_embree_robust = 0;
    std::size_t embree_fast_and_robust = 0;
};

struct Outcome {
    std::string scene;
    std::size_t triangles = 0;
    std::size_t pages = 0;
    std::size_t texels = 0; ///< covered
    std::size_t tiles = 0;
    std::size_t rays = 0;         ///< timed
    double lanes_used = 0.0;      ///< of the blocks' places for rays, those that hold one
    double occluded = 0.0;        ///< share of the timed rays
    std::int64_t allocations = 0; ///< by our kernel in a pass, beside what its threads start with: must be 0
    std::vector<EntryFigures> entries;
    std::vector<WayFigures> embree_ways; ///< all that were tried, the best of a kind of pass first
    Differences differences;
    Verdict verdict;
    std::vector<BuildFigures> builds;
};

[[nodiscard]] Outcome run_contest(const Options& options);

} // namespace vkbake::bench
