// Sets of lanes as tables.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace vkbake {

/// For each set of eight lanes (bit l: lane l) its lanes in order, then zeros.
using LanesInFront = std::array<std::array<std::uint8_t, 8>, 256>;
[[nodiscard]] constexpr LanesInFront list_lanes() {
    LanesInFront lists{};
    for (std::size_t set = 0; set < lists.size(); ++set) {
        std::size_t count = 0;
        for (std::size_t lane = 0; lane < 8; ++lane) {
            if ((set >> lane & 1U) != 0) {
                lists[set][count++] = static_cast<std::uint8_t>(lane);
            }
        }
    }
    return lists;
}
alignas(64) inline constexpr LanesInFront lanes_in_front = list_lanes();

} // namespace vkbake
