#include "trace/allocation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vkbake {

namespace {

/// All doublings in which a sample takes away `price` or more.
Allocation allocate_at(std::span<const TileNeed> needs, double ratio, double price) {
    Allocation result;
    result.doublings.assign(needs.size(), 0);
    for (std::size_t tile = 0; tile < needs.size(); ++tile) {
        TileNeed need = needs[tile];
        while (need.rays < most_rays && gain_a_sample(need, ratio) >= price && need.variance > 0.0) {
            result.work += need.cost * static_cast<double>(need.texels) * static_cast<double>(need.rays);
            need.variance *= ratio;
            need.rays *= 2;
            ++result.doublings[tile];
        }
        result.variance += need.variance;
    }
    return result;
}

/// The highest price at which the allocation is enough, or the lowest at which it is not too much.
template<typename Enough>
Allocation allocate(std::span<const TileNeed> needs, double ratio, bool at_most, const Enough& enough) {
    double high = 0.0;
    for (const TileNeed& need : needs) {
        high = std::max(high, gain_a_sample(need, ratio));
    }
    high *= 2.0;               // nothing is bought at this price
    double low = high * 1e-30; // and all that most_rays allows at this
    if (high == 0.0 || enough(allocate_at(needs, ratio, high))) {
        return allocate_at(needs, ratio, std::max(high, 1e-300));
    }
    constexpr int steps = 28; // in logarithms: high and low are then within 10⁻⁶ of each other
    for (int step = 0; step < steps; ++step) {
        const double middle = std::sqrt(low) * std::sqrt(high);
        (enough(allocate_at(needs, ratio, middle)) ? low : high) = middle;
    }
    return allocate_at(needs, ratio, at_most ? high : low);
}

} // namespace

double gain_a_sample(const TileNeed& need, double ratio) {
    return need.variance * (1.0 - ratio) /
           (need.cost * static_cast<double>(need.texels) * static_cast<double>(need.rays));
}

Allocation allocate_for_variance(std::span<const TileNeed> needs, double ratio, double variance) {
    return allocate(needs, ratio, false, [&](const Allocation& allocation) { return allocation.variance <= variance; });
}

Allocation allocate_for_work(std::span<const TileNeed> needs, double ratio, double work) {
    return allocate(needs, ratio, true, [&](const Allocation& allocation) { return allocation.work > work; });
}

} // namespace vkbake
