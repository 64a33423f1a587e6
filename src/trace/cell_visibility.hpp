// What a tile's rays have met, cell by cell of the hemisphere, and what that tells of rays to come.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "trace/cosine_strata.hpp"

namespace vkbake {

/// For each cell of the square cut into 32 × 32, which each texel sees about its own normal, whether any of a tile's
/// rays there met nothing, and whether any met something.
class CellVisibility {
public:
    static constexpr unsigned bits = 5; ///< finer cells would take more memory than they spare time
    static constexpr unsigned side = 1U << bits;

    using Rows = std::array<std::uint32_t, side>; ///< of each row a bit a column

    /// Of a row, the cells in which a ray met nothing, and something.
    void add(std::size_t row, std::uint32_t open, std::uint32_t blocked) {
        m_open[row] |= open;
        m_blocked[row] |= blocked;
    }

    [[nodiscard]] const Rows& open() const { return m_open; }
    [[nodiscard]] const Rows& blocked() const { return m_blocked; }

private:
    Rows m_open{};
    Rows m_blocked{};
};

/// Cells in which a tile's samples to come are taken to meet what those before met: where all of these agree, in the
/// cell and in the four beside it, so that the edge of what occludes runs elsewhere.
///
/// That is wrong where something is so small that no ray there has met it. So before a tile's samples are spared some
/// rays are traced in known cells all the same (TileTracer): where one of them contradicts, nothing is spared.
class KnownCells {
public:
    enum class Answer : std::uint8_t { none, open, blocked };

    static constexpr std::uint32_t least_samples = 64;  ///< of each of sixteen texels; fewer tell nothing
    static constexpr std::uint64_t checked_strata = 16; ///< of every so many one is traced though it may be known

    /// From what the first `samples` of each of a tile's texels met, in cells that have one or more of each of sixteen
    /// texels: those of a tile of fewer are larger, so that as many rays tell.
    KnownCells(const CellVisibility& seen, std::uint32_t samples, std::uint32_t texels);

    /// Of one of 2^k × 2^k cells; k as a CosineStrata of more samples has it.
    [[nodiscard]] Answer at(CosineStrata::Cell cell, unsigned k) const {
        const std::size_t row = cell.row >> (k - m_bits);
        const unsigned column = unsigned{cell.column} >> (k - m_bits);
        if ((m_open[row] >> column & 1U) != 0) {
            return Answer::open;
        }
        return (m_blocked[row] >> column & 1U) != 0 ? Answer::blocked : Answer::none;
    }

    /// Of samples to come, those that take a ray if nothing contradicts.
    [[nodiscard]] double traced_share() const;

    /// Counts every place in a known cell as seen, for its next samples will not be.
    void mark(CellVisibility& seen) const;

private:
    unsigned m_bits = 0; ///< the square is cut into 2^m_bits × 2^m_bits
    CellVisibility::Rows m_open{};
    CellVisibility::Rows m_blocked{};
};

} // namespace vkbake
