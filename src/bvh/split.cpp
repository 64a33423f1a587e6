#include "bvh/split.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

namespace vkbake {
namespace {

constexpr std::size_t bin_count = 16;

struct Bin {
    Box box;
    std::size_t weight = 0;

    void add(const Bin& other) {
        box.add(other.box);
        weight += other.weight;
    }
    [[nodiscard]] double cost() const { return box.half_area() * static_cast<double>(weight); }
};

// Twice the box's centre: the factor changes no order.
glm::vec3 centre(const BuildItem& item) { return item.box.low + item.box.high; }

/// Maps centres to bins along one axis.
class Binning {
public:
    Binning(const Box& centres, int axis)
        : m_axis(axis), m_low(centres.low[axis]),
          m_scale(static_cast<float>(bin_count) / (centres.high[axis] - centres.low[axis])) {}

    // Not so where all centres are equal, or so close that the scale overflows.
    [[nodiscard]] bool usable() const { return m_scale <= std::numeric_limits<float>::max(); }
    [[nodiscard]] std::size_t operator()(const BuildItem& item) const {
        const float place = (centre(item)[m_axis] - m_low) * m_scale;
        return std::min(static_cast<std::size_t>(place), bin_count - 1);
    }

private:
    int m_axis;
    float m_low;
    float m_scale;
};

struct Cut {
    double cost = std::numeric_limits<double>::infinity();
    int axis = -1;
    std::size_t bin = 0; ///< the first bin of the second half
};

// Of equal costs the first one found stays, so the result is determined.
void improve(Cut& best, std::span<const BuildItem> items, const Binning& binning, int axis) {
    std::array<Bin, bin_count> bins;
    for (const BuildItem& item : items) {
        bins[binning(item)].add({item.box, item.weight});
    }
    std::array<double, bin_count> right_costs{};
    Bin right;
    for (std::size_t bin = bin_count - 1; bin > 0; --bin) {
        right.add(bins[bin]);
        right_costs[bin] = right.weight > 0 ? right.cost() : std::numeric_limits<double>::infinity();
    }
    Bin left;
    for (std::size_t bin = 1; bin < bin_count; ++bin) {
        left.add(bins[bin - 1]);
        const double cost = left.cost() + right_costs[bin];
        if (left.weight > 0 && cost < best.cost) {
            best = {cost, axis, bin};
        }
    }
}

std::size_t split_at_median(std::span<BuildItem> items, const Box& centres) {
    const glm::vec3 extent = centres.high - centres.low;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : (extent.y >= extent.z ? 1 : 2);
    const std::size_t half = items.size() / 2;
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                     [axis](const BuildItem& a, const BuildItem& b) {
                         return std::pair(centre(a)[axis], a.index) < std::pair(centre(b)[axis], b.index);
                     });
    return half;
}

} // namespace

std::size_t split(std::span<BuildItem> items, std::size_t depth_left) {
    Box centres;
    for (const BuildItem& item : items) {
        centres.add(centre(item));
    }
    // ⌈log₂ size⌉ levels of medians are needed; with one to spare an uneven cut still leaves enough.
    const auto needed = static_cast<std::size_t>(std::bit_width(items.size() - 1));
    if (needed >= depth_left) {
        return split_at_median(items, centres);
    }
    Cut best;
    for (int axis = 0; axis < 3; ++axis) {
        const Binning binning(centres, axis);
        if (binning.usable()) {
            improve(best, items, binning, axis);
        }
    }
    if (best.axis < 0) {
        return split_at_median(items, centres);
    }
    const Binning binning(centres, best.axis);
    const auto middle =
        std::partition(items.begin(), items.end(), [&](const BuildItem& item) { return binning(item) < best.bin; });
    return static_cast<std::size_t>(middle - items.begin());
}

} // namespace vkbake
