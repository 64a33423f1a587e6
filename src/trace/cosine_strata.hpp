// In which order a texel's cosine-weighted samples are taken, and which sample lies where.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "bvh/ray_block.hpp"

namespace vkbake {

/// The strata of one block of rays.
struct BlockStrata {
    std::array<std::uint64_t, RayBlock::strata> of{}; ///< each the number of one
    std::size_t count = 0;                            ///< the first so many have rays

    /// Returns whether there is no more room.
    bool add(std::uint64_t stratum) {
        of[count++] = stratum;
        return count == of.size();
    }
    /// Has the places that are left hold what the last one holds, so that they widen no beam; count ≥ 1.
    void fill() { std::fill(of.begin() + static_cast<std::ptrdiff_t>(count), of.end(), of[count - 1]); }
};

/// The samples of one texel are the first `rays` points of its scrambled Sobol sequence (base/sampling_sobol.hpp). Each
/// aligned block of 4^k of them, a *round*, holds one point in each cell of the square cut into 2^k × 2^k; so a round
/// can be gone through cell by cell, in an order that all texels share, though the points are each texel's own.
///
/// A *stratum* is a cell of a round. Strata are numbered round after round, and within a round along Hilbert's curve,
/// whose every aligned 16 cells are a square of 4 × 4: the strata of one block of rays.
///
/// Which sample a cell holds is found by going the sequence's way backwards. With its digits reversed, a coordinate's
/// low k bits are the cell's number, and they depend on the low k bits alone of what was scrambled: in x of the index
/// itself, in y of S(index), S being Sobol's dimension 1, a linear map over bits. So invert the scramble of k bits (a
/// table a texel): let `a` be what x's scramble took to the column, `w` what y's took to the row. The index sought is
/// r · 4^k + b · 2^k + a with w = the low bits of S(index) = S(r · 4^k) ^ S(b · 2^k) ^ S(a). All of it is linear, so
/// the index is one exclusive or of three words, one that goes with the column, one with the row, one with the round;
/// and S(index) is the same of their S.
class CosineStrata {
public:
    static constexpr unsigned most_bits = 6;
    static constexpr std::size_t most_cells = std::size_t{1} << most_bits; ///< along an axis

    struct Cell {
        std::uint8_t column = 0;
        std::uint8_t row = 0;
        std::uint8_t reversed_column = 0; ///< its k binary digits from the last to the first
        std::uint8_t reversed_row = 0;
    };

    /// A part of an index, and what Sobol's dimension 1 (reversed) makes of it.
    struct Part {
        std::uint32_t index = 0;
        std::uint32_t image = 0;
    };

    /// `rays`: samples a texel, ≥ 1. k is the largest with 4^k ≤ rays, and 6 at most: 4096 cells. `first`: those below
    /// it are left out, for texels that have them already; 0, or 16 or more and < rays.
    explicit CosineStrata(std::uint32_t rays, std::uint32_t first = 0);

    [[nodiscard]] std::uint32_t rays() const { return m_rays; }
    [[nodiscard]] std::uint32_t first() const { return m_first; }
    [[nodiscard]] unsigned bits() const { return m_bits; } ///< k
    /// Rounds times cells; where a round is not full, some strata hold a sample whose index is not below rays(), or is
    /// below first().
    [[nodiscard]] std::uint64_t count() const { return m_count; }
    /// Those of full rounds.
    [[nodiscard]] std::uint64_t full_count() const { return m_rays >> (2 * m_bits) << (2 * m_bits); }
    /// Of the first block: rounds that lie wholly below first() have none.
    [[nodiscard]] std::uint64_t first_stratum() const { return std::uint64_t{m_first} >> (2 * m_bits) << (2 * m_bits); }
    [[nodiscard]] std::size_t block_count() const {
        return static_cast<std::size_t>((m_count - first_stratum() + RayBlock::strata - 1) / RayBlock::strata);
    }
    /// The strata from f + 16 · number on, f = first_stratum().
    [[nodiscard]] BlockStrata block(std::size_t number) const;
    [[nodiscard]] Cell cell(std::uint64_t stratum) const {
        return m_cells[static_cast<std::size_t>(stratum) & (m_cells.size() - 1)];
    }
    [[nodiscard]] std::uint32_t round(std::uint64_t stratum) const {
        return static_cast<std::uint32_t>(stratum >> (2 * m_bits));
    }

    /// Of the column whose inverted scramble is `bits`, and of the row; both below 2^k.
    [[nodiscard]] Part column_part(std::uint32_t bits) const { return m_column_parts[bits]; }
    [[nodiscard]] Part row_part(std::uint32_t bits) const { return m_row_parts[bits]; }
    [[nodiscard]] Part round_part(std::uint32_t round) const;

private:
    std::uint32_t m_rays;
    std::uint32_t m_first;
    unsigned m_bits;
    std::uint64_t m_count;
    std::vector<Cell> m_cells; ///< 4^k along the curve
    std::array<Part, most_cells> m_column_parts{};
    std::array<Part, most_cells> m_row_parts{};
};

} // namespace vkbake
