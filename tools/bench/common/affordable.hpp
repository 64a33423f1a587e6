// How many rays one can be asked.
#pragma once

#include <algorithm>
#include <memory>

#include "bench/common/contender.hpp"

namespace vkbake::bench {

/// Of the set, as many rays as are answered in about `seconds` on one thread, at least 200. `make(rays)` gives a
/// contender that answers a set.
template<typename Make>
[[nodiscard]] RaySet affordable(const RaySet& rays, double seconds, const Make& make) {
    constexpr std::size_t few = 200;
    const RaySet trial = thinned(rays, few);
    const std::unique_ptr<Contender> contender = make(trial);
    (void)seconds_of(*contender, Pass::ask, 1);
    const double a_ray = seconds_of(*contender, Pass::ask, 1).cpu / static_cast<double>(trial.ray_count);
    const double many = seconds / a_ray;
    return many >= static_cast<double>(rays.ray_count) ? rays
                                                       : thinned(rays, std::max(few, static_cast<std::size_t>(many)));
}

} // namespace vkbake::bench
