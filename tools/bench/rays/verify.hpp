// Answers against the double-precision reference.
#pragma once

#include <string>
#include <vector>

#include "bench/common/double_reference.hpp"
#include "bench/common/ray_set.hpp"

namespace vkbake::bench {

/// Rounding of one coordinate that is as large as anything in the bake frame seen from an origin in it: 2 · 2⁻²⁴.
inline constexpr double rounding_unit = 0x1p-23;
/// The triangle test may see an outline moved by some of these: 6 an axis for each of an edge's ends, and the plane's
/// distance likewise. Within this many a disagreement is no error.
inline constexpr double excusable_roundings = 16.0;

struct Disagreement {
    Ray ray;
    bool ours = false;
    bool embree = false;
    bool reference = false;
    Slack slack; ///< why the reference says so

    [[nodiscard]] bool excusable() const;
    [[nodiscard]] std::string note() const;
};

struct Verdict {
    std::size_t rays = 0;
    std::size_t brute_rays = 0;        ///< of these, asked of every triangle too
    std::size_t brute_differences = 0; ///< where the reference's tree and that did not agree: must be 0
    std::size_t ours_wrong = 0;
    std::size_t embree_wrong = 0;
    std::vector<Disagreement> disagreements; ///< where any of the three differ, at most 1000
};

/// Judges `count` of the set's rays, spread evenly, and beside them every ray on which the two disagree. `brute` of
/// these are asked of all triangles.
[[nodiscard]] Verdict verify(const RaySet& rays, const std::vector<BlockedRays>& ours,
                             const std::vector<BlockedRays>& embree, std::size_t count, std::size_t brute);

} // namespace vkbake::bench
