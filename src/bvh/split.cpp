#include "bvh/split.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

#include "bvh/float4.hpp"

namespace vkbake {
namespace {

constexpr std::size_t most_bins = 16;
constexpr float infinity = std::numeric_limits<float>::infinity();

/// Few items need no more bins than they fill.
std::size_t bins_for(std::size_t items) { return std::min(most_bins, 4 + items / 8); }

/// A box whose fourth lanes mean nothing.
struct Box4 {
    Float4 low = fill4(infinity);
    Float4 high = fill4(-infinity);

    void add(const Box4& other) {
        low = min4(low, other.low);
        high = max4(high, other.high);
    }
    [[nodiscard]] Box box() const { return {xyz_of(low), xyz_of(high)}; }
};

// What follows a corner in the item is read along with it; an index is no number to reckon with, so it goes.
Box4 box_of(const BuildItem& item) {
    const Int4 first_three{-1, -1, -1, 0};
    return {load4(&item.low.x), Float4(Int4(load4(&item.high.x)) & first_three)};
}

// Twice the box's centre: the factor changes no order.
Float4 centre(const BuildItem& item) {
    const Box4 box = box_of(item);
    return box.low + box.high;
}
float centre(const BuildItem& item, int axis) { return item.low[axis] + item.high[axis]; }

Box4 box_of_centres(std::span<const BuildItem> items) {
    Box4 even;
    Box4 odd; // two chains of minima, so that one need not wait for the other
    for (std::size_t i = 0; i + 1 < items.size(); i += 2) {
        const Float4 a = centre(items[i]);
        const Float4 b = centre(items[i + 1]);
        even.add({a, a});
        odd.add({b, b});
    }
    const Float4 last = centre(items.back());
    even.add({last, last});
    even.add(odd);
    return even;
}

Box box_around(std::span<const BuildItem> items) {
    Box4 all;
    for (const BuildItem& item : items) {
        all.add(box_of(item));
    }
    return all.box();
}

/// Maps centres to bins, along the three axes at once.
struct Binning {
    Float4 low;
    Float4 scale = fill4(0.0F); ///< 0 where all centres are equal, or so close, or so far, that it has no finite value
    Float4 penalty = fill4(infinity); ///< infinite there, otherwise 0
    std::size_t count;

    Binning(const Box4& centres, std::size_t bin_count) : low(centres.low), count(bin_count) {
        for (int axis = 0; axis < 3; ++axis) {
            const float extent = centres.high[axis] - centres.low[axis];
            const float bins_a_unit = static_cast<float>(count) / extent;
            if (extent > 0.0F && extent < infinity && bins_a_unit < infinity) {
                scale[axis] = bins_a_unit;
                penalty[axis] = 0.0F;
            }
        }
    }

    [[nodiscard]] Int4 operator()(Float4 centres) const {
        const Float4 place = (centres - low) * scale;
        return to_int(min4(max4(place, fill4(0.0F)), fill4(static_cast<float>(count - 1))));
    }
};

/// By axis.
struct Bin {
    std::array<Box4, 3> boxes;
    Int4 weights{0, 0, 0, 0};

    void add(const Bin& other) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            boxes[axis].add(other.boxes[axis]);
        }
        weights += other.weights;
    }

    /// Half the areas times the weights; `unit` keeps the areas of any scene within floats.
    [[nodiscard]] Float4 costs(Float4 unit) const {
        const auto extent = [&](const Box4& box) { return max4((box.high - box.low) * unit, fill4(0.0F)); };
        const Float4 a = extent(boxes[0]);
        const Float4 b = extent(boxes[1]);
        const Float4 c = extent(boxes[2]);
        const Float4 ab_xy = __builtin_shufflevector(a, b, 0, 4, 1, 5);
        const Float4 ab_z = __builtin_shufflevector(a, b, 2, 6, 3, 7);
        const Float4 x = __builtin_shufflevector(ab_xy, c, 0, 1, 4, 4);
        const Float4 y = __builtin_shufflevector(ab_xy, c, 2, 3, 5, 5);
        const Float4 z = __builtin_shufflevector(ab_z, c, 0, 1, 6, 6);
        return (x * (y + z) + y * z) * to_float(weights);
    }
};

using Bins = std::array<Bin, most_bins>;

void fill(Bins& bins, std::span<const BuildItem> items, const Binning& binning) {
    std::fill_n(bins.begin(), binning.count, Bin{});
    for (const BuildItem& item : items) {
        const Box4 box = box_of(item);
        const Int4 place = binning(box.low + box.high);
        const auto weight = static_cast<std::int32_t>(item.weight);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Bin& bin = bins[static_cast<std::size_t>(place[axis])];
            bin.boxes[axis].add(box);
            bin.weights[axis] += weight;
        }
    }
}

struct Cut {
    float cost = infinity;
    int axis = -1;
    std::size_t bin = 0; ///< the first bin of the second half
};

// Of equal costs the first one found stays, so the result is determined.
Cut best_cut(const Bins& bins, const Binning& binning) {
    Box4 all;
    for (std::size_t bin = 0; bin < binning.count; ++bin) {
        all.add(bins[bin].boxes[0]);
    }
    const glm::vec3 extent = xyz_of(all.high - all.low);
    const float unit = 1.0F / std::max({extent.x, extent.y, extent.z});
    if (!(unit > std::numeric_limits<float>::min() && unit < infinity)) {
        return {};
    }
    std::array<Float4, most_bins> right_costs; // NOLINT(cppcoreguidelines-pro-type-member-init): as many as are used
    Bin right;
    for (std::size_t bin = binning.count - 1; bin > 0; --bin) {
        right.add(bins[bin]);
        right_costs[bin] = right.costs(fill4(unit)) + binning.penalty;
    }
    Float4 least = fill4(infinity);
    Int4 place{0, 0, 0, 0};
    Bin left;
    for (std::size_t bin = 1; bin < binning.count; ++bin) {
        left.add(bins[bin - 1]);
        const Float4 cost = left.costs(fill4(unit)) + right_costs[bin];
        const auto number = static_cast<std::int32_t>(bin);
        const Int4 better = cost < least;
        least = better ? cost : least;
        place = better ? Int4{number, number, number, number} : place;
    }
    Cut best;
    for (int axis = 0; axis < 3; ++axis) {
        if (least[axis] < best.cost) {
            best = {least[axis], axis, static_cast<std::size_t>(place[axis])};
        }
    }
    return best;
}

// Without a branch on which half an item belongs to: that cannot be foretold.
std::size_t partition(std::span<BuildItem> items, const Binning& binning, const Cut& cut) {
    const float low = binning.low[cut.axis];
    const float scale = binning.scale[cut.axis];
    const auto end = static_cast<float>(cut.bin);
    std::size_t first = 0;
    for (BuildItem& item : items) {
        const BuildItem copy = item;
        item = items[first];
        items[first] = copy;
        first += static_cast<std::size_t>((centre(copy, cut.axis) - low) * scale < end);
    }
    return first;
}

Halves split_at_median(std::span<BuildItem> items, const Box4& centres) {
    const glm::vec3 extent = xyz_of(centres.high - centres.low);
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : (extent.y >= extent.z ? 1 : 2);
    const std::size_t half = items.size() / 2;
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                     [axis](const BuildItem& a, const BuildItem& b) {
                         return std::pair(centre(a, axis), a.index) < std::pair(centre(b, axis), b.index);
                     });
    return {half, box_around(items.first(half)), box_around(items.subspan(half))};
}

} // namespace

Halves split(std::span<BuildItem> items, std::size_t depth_left) {
    const Box4 centres = box_of_centres(items);
    // ⌈log₂ size⌉ levels of medians are needed; with one to spare an uneven cut still leaves enough.
    const auto needed = static_cast<std::size_t>(std::bit_width(items.size() - 1));
    if (needed >= depth_left) {
        return split_at_median(items, centres);
    }
    const Binning binning(centres, bins_for(items.size()));
    Bins bins; // NOLINT(cppcoreguidelines-pro-type-member-init): fill() starts with those that are used
    fill(bins, items, binning);
    const Cut cut = best_cut(bins, binning);
    if (cut.axis < 0) {
        return split_at_median(items, centres);
    }
    const auto axis = static_cast<std::size_t>(cut.axis);
    Box4 first;
    Box4 second;
    for (std::size_t bin = 0; bin < binning.count; ++bin) {
        (bin < cut.bin ? first : second).add(bins[bin].boxes[axis]);
    }
    return {partition(items, binning, cut), first.box(), second.box()};
}

} // namespace vkbake
