// The value that few of many exceed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace vkbake {

/// A hundredth of `values` is at least this; 0 of none. Orders the values anew.
template<typename Value>
[[nodiscard]] double percentile_99(std::vector<Value>& values) {
    if (values.empty()) {
        return 0.0;
    }
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 99 / 100);
    std::nth_element(values.begin(), place, values.end());
    return static_cast<double>(*place);
}

/// Of a map's covered texels alone; `values` and `coverage` have one value a texel.
[[nodiscard]] inline double covered_percentile_99(std::span<const float> values, std::span<const float> coverage) {
    std::vector<float> covered;
    for (std::size_t texel = 0; texel < values.size(); ++texel) {
        if (coverage[texel] > 0.0F) {
            covered.push_back(values[texel]);
        }
    }
    return percentile_99(covered);
}

} // namespace vkbake
