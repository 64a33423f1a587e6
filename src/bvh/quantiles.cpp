#include "bvh/quantiles.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/parallel.hpp"
#include "bvh/float4.hpp"

namespace vkbake {
namespace {

constexpr std::size_t keys_a_range = 8192;
constexpr std::size_t sample_size = 16384;

using ByAxis = std::array<std::vector<float>, 3>;

ByAxis sample(const ListedTriangles& triangles) {
    ByAxis values;
    const std::size_t step = triangles.end_number() * 3 / sample_size + 1;
    for (std::size_t number = 0; number < triangles.end_number(); number += step) {
        triangles.each_by_number(number, number + 1, [&](const Triangle& triangle, std::uint32_t /*rank*/) {
            for (const glm::vec3& corner : triangle.corners) {
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    values[axis].push_back(corner[static_cast<int>(axis)]);
                }
            }
        });
    }
    return values;
}

/// Where a cut of each axis is looked for.
struct Window {
    Float4 low;
    Float4 high;
};

// Four standard deviations of a random sample to either side.
std::vector<Window> windows(ByAxis values, std::size_t splits) {
    const std::size_t count = values[0].size();
    const auto margin = static_cast<std::size_t>(2.0 * std::sqrt(static_cast<double>(count))) + 1;
    std::vector<Window> windows(splits - 1, Window{fill4(0.0F), fill4(0.0F)});
    for (std::size_t axis = 0; axis < 3 && count > 0; ++axis) {
        std::sort(values[axis].begin(), values[axis].end());
        for (std::size_t cut = 1; cut < splits; ++cut) {
            const std::size_t place = cut * count / splits;
            windows[cut - 1].low[axis] = values[axis][place - std::min(place, margin)];
            windows[cut - 1].high[axis] = values[axis][std::min(place + margin, count - 1)];
        }
    }
    return windows;
}

/// How many coordinates lie where; the axes are the lanes.
struct Counts {
    Int4 below{0, 0, 0, 0};      ///< the window
    Int4 up_to_low{0, 0, 0, 0};  ///< below it or at its low end
    Int4 up_to_high{0, 0, 0, 0}; ///< not above it
};

/// The same of one axis.
struct Search {
    std::size_t below = 0;
    std::size_t up_to_low = 0;
    std::size_t up_to_high = 0;
    std::vector<float> inside; ///< between the ends: so equal coordinates, however many, are only counted

    void add(const Search& other) {
        below += other.below;
        up_to_low += other.up_to_low;
        up_to_high += other.up_to_high;
        inside.insert(inside.end(), other.inside.begin(), other.inside.end());
    }
};

using Searches = std::vector<std::array<Search, 3>>; // by cut and axis

bool any(Int4 v) { return (v[0] | v[1] | v[2]) != 0; }

void search(const ListedTriangles& triangles, std::size_t begin, std::size_t end, const std::vector<Window>& windows,
            Searches& searches) {
    std::vector<Counts> counts(windows.size());
    triangles.each_by_number(begin, end, [&](const Triangle& triangle, std::uint32_t /*rank*/) {
        for (const glm::vec3& corner : triangle.corners) {
            const Float4 place = xyz0(corner);
            for (std::size_t cut = 0; cut < windows.size(); ++cut) {
                const Int4 up_to_low = place <= windows[cut].low;
                counts[cut].below -= place < windows[cut].low; // true is −1
                counts[cut].up_to_low -= up_to_low;
                counts[cut].up_to_high -= place <= windows[cut].high;
                const Int4 inside = ~up_to_low & (place < windows[cut].high);
                if (any(inside)) {
                    for (int axis = 0; axis < 3; ++axis) {
                        if (inside[axis] != 0) {
                            searches[cut][static_cast<std::size_t>(axis)].inside.push_back(place[axis]);
                        }
                    }
                }
            }
        }
    });
    for (std::size_t cut = 0; cut < windows.size(); ++cut) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Search& search = searches[cut][axis];
            search.below += static_cast<std::size_t>(counts[cut].below[axis]);
            search.up_to_low += static_cast<std::size_t>(counts[cut].up_to_low[axis]);
            search.up_to_high += static_cast<std::size_t>(counts[cut].up_to_high[axis]);
        }
    }
}

// Where the sample has led astray.
float look_at_all(const ListedTriangles& triangles, int axis, std::size_t place) {
    std::vector<float> values;
    values.reserve(3 * triangles.size());
    triangles.each_by_number(0, triangles.end_number(), [&](const Triangle& triangle, std::uint32_t /*rank*/) {
        for (const glm::vec3& corner : triangle.corners) {
            values.push_back(corner[axis]);
        }
    });
    const auto found = values.begin() + static_cast<std::ptrdiff_t>(place);
    std::nth_element(values.begin(), found, values.end());
    return *found;
}

} // namespace

std::array<std::vector<float>, 3> quantiles(const ListedTriangles& triangles, std::size_t splits, int threads) {
    ByAxis cuts;
    if (triangles.size() == 0) {
        return cuts;
    }
    const std::vector<Window> where = windows(sample(triangles), splits);
    std::vector<Searches> by_worker(worker_count(threads), Searches(where.size()));
    parallel_ranges_by_worker(triangles.end_number(), keys_a_range, threads,
                              [&](std::size_t begin, std::size_t end, std::size_t worker) {
                                  search(triangles, begin, end, where, by_worker[worker]);
                              });
    for (std::size_t cut = 0; cut < where.size(); ++cut) {
        const std::size_t place = (cut + 1) * 3 * triangles.size() / splits;
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            Search found;
            for (const Searches& searches : by_worker) {
                found.add(searches[cut][a]);
            }
            if (place < found.below || place >= found.up_to_high) {
                cuts[a].push_back(look_at_all(triangles, axis, place));
            } else if (place < found.up_to_low) {
                cuts[a].push_back(where[cut].low[axis]);
            } else if (place < found.up_to_low + found.inside.size()) {
                const auto inside = found.inside.begin() + static_cast<std::ptrdiff_t>(place - found.up_to_low);
                std::nth_element(found.inside.begin(), inside, found.inside.end());
                cuts[a].push_back(*inside);
            } else {
                cuts[a].push_back(where[cut].high[axis]);
            }
        }
    }
    return cuts;
}

} // namespace vkbake
