// The accelerators of the comparison.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/common/contender.hpp"
#include "vkbake/surface.hpp"

namespace vkbake::bench {

/// One that was built.
class Candidate {
public:
    Candidate() = default;
    virtual ~Candidate() = default;
    Candidate(const Candidate&) = delete;
    Candidate& operator=(const Candidate&) = delete;

    [[nodiscard]] virtual std::size_t bytes() const = 0;
    [[nodiscard]] virtual std::unique_ptr<Contender> contender(const RaySet& rays) const = 0;
};

struct CandidateKind {
    std::string name;
    std::function<std::unique_ptr<Candidate>(const Surface&)> build; ///< on one thread
};

/// Brute force, flat clusters at K = 4, 8, 16 and 32, a uniform grid, an octree, our hierarchy asked by single rays and
/// by blocks: all with the watertight test.
[[nodiscard]] std::vector<CandidateKind> all_candidates();

} // namespace vkbake::bench
