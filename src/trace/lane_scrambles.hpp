// What tells the points of one lane's texel from those of the others.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/random.hpp"
#include "base/sampling_sobol.hpp"
#include "bvh/ray_block.hpp"

namespace vkbake {

/// Each lane's SobolScramble, component by component.
struct LaneScrambles {
    std::array<std::uint64_t, RayBlock::lanes> key{};
    alignas(64) std::array<std::uint32_t, RayBlock::lanes> shift_x{};
    alignas(64) std::array<std::uint32_t, RayBlock::lanes> shift_y{};

    void set(std::size_t lane, const SobolScramble& scramble) {
        key[lane] = scramble.key;
        shift_x[lane] = scramble.shift.x;
        shift_y[lane] = scramble.shift.y;
    }

    /// For another purpose, which `salt` names: independent of these, and among neighbouring texels alike.
    [[nodiscard]] LaneScrambles salted(std::uint64_t salt) const {
        LaneScrambles others = *this;
        for (std::uint64_t& some : others.key) {
            some = mix64(some ^ salt);
        }
        return others;
    }

    /// A number of the lane's own, independent of every other lane's and of its points.
    [[nodiscard]] std::uint64_t random(std::size_t lane) const {
        return mix64(mix64(key[lane]) ^ ((std::uint64_t{shift_x[lane]} << 32U) | shift_y[lane]));
    }
};

} // namespace vkbake
