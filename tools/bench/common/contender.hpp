// Who answers rays: what is compared.
#pragma once

#include <bit>
#include <string>
#include <vector>

#include "bench/common/ray_set.hpp"
#include "bench/common/timing.hpp"

namespace vkbake::bench {

class Contender {
public:
    Contender() = default;
    virtual ~Contender() = default;
    Contender(const Contender&) = delete;
    Contender& operator=(const Contender&) = delete;

    [[nodiscard]] virtual std::string description() const = 0;
    [[nodiscard]] virtual const RaySet& rays() const = 0;
    /// Before a pass that asks, untimed: makes ready again what the last pass has changed.
    virtual void prepare() {}
    /// Work that asks the rays that were made beforehand.
    [[nodiscard]] virtual Work ask() = 0;
    /// Work that makes the rays on the way.
    [[nodiscard]] virtual Work make_and_ask() = 0;
    /// The answers of the last pass, one entry a block of the set.
    [[nodiscard]] virtual std::vector<BlockedRays> answers() = 0;
};

enum class Pass { ask, make_and_ask };

[[nodiscard]] inline PassSeconds seconds_of(Contender& contender, Pass pass, int threads) {
    const std::size_t tiles = contender.rays().tiles.size();
    if (pass == Pass::ask) {
        contender.prepare();
        return timed_pass(threads, tiles, [&] { return contender.ask(); });
    }
    return timed_pass(threads, tiles, [&] { return contender.make_and_ask(); });
}

/// Rays that two sets of answers to the same blocks disagree on.
[[nodiscard]] inline std::size_t count_differences(const std::vector<BlockedRays>& a,
                                                   const std::vector<BlockedRays>& b) {
    std::size_t count = 0;
    for (std::size_t block = 0; block < a.size(); ++block) {
        for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
            count +=
                static_cast<std::size_t>(std::popcount(static_cast<unsigned>(a[block][stratum] ^ b[block][stratum])));
        }
    }
    return count;
}

} // namespace vkbake::bench
