#include "trace/cell_visibility.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

#include <gtest/gtest.h>

#include "base/random.hpp"

namespace vkbake {
namespace {

using Answer = KnownCells::Answer;

constexpr std::size_t cells_a_side = CellVisibility::side;

/// What was seen, cell by cell; chance puts borders into it.
struct Seen {
    std::array<std::array<bool, cells_a_side>, cells_a_side> open{};
    std::array<std::array<bool, cells_a_side>, cells_a_side> blocked{};
    CellVisibility cells;

    explicit Seen(std::uint64_t seed) {
        for (std::size_t row = 0; row < cells_a_side; ++row) {
            for (std::size_t column = 0; column < cells_a_side; ++column) {
                const std::uint64_t random = mix64(seed ^ mix64(cells_a_side * row + column));
                const bool beyond = column + row / 2 > 20;
                const bool odd = random % 97 == 0;
                const bool nothing = random % 5 == 1; // no ray came here
                open[row][column] = !nothing && (beyond || odd);
                blocked[row][column] = !nothing && (!beyond || odd);
                cells.add(row, std::uint32_t{open[row][column]} << column,
                          std::uint32_t{blocked[row][column]} << column);
            }
        }
    }
};

/// By the definition: one of 2^k × 2^k cells and the four beside it.
Answer answer_of(const Seen& seen, std::size_t row, std::size_t column, unsigned k) {
    const std::size_t size = cells_a_side >> k;
    const std::size_t side = std::size_t{1} << k; // beyond it, below 0 too, there is no cell
    const auto any = [&](const auto& what, std::size_t r, std::size_t c) {
        bool found = false;
        for (std::size_t i = 0; r < side && c < side && i < size * size; ++i) {
            found = found || what[r * size + i / size][c * size + i % size];
        }
        return found;
    };
    const auto about = [&](const auto& what) {
        return any(what, row, column) || any(what, row - 1, column) || any(what, row + 1, column) ||
               any(what, row, column - 1) || any(what, row, column + 1);
    };
    if (any(seen.open, row, column) && !about(seen.blocked)) {
        return Answer::open;
    }
    return any(seen.blocked, row, column) && !about(seen.open) ? Answer::blocked : Answer::none;
}

TEST(KnownCells, AreThoseInAndBesideWhichAllRaysMetAlike) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        const Seen seen(seed);
        for (unsigned k = 3; k <= 5; ++k) {
            const auto samples = std::uint32_t{1} << (2 * k);
            const KnownCells known(seen.cells, samples, 16);
            const KnownCells later(seen.cells, 4 * samples - 1, 16); // no finer cell has one of each texel's
            double unknown = 0.0;
            for (std::size_t row = 0; row < std::size_t{1} << k; ++row) {
                for (std::size_t column = 0; column < std::size_t{1} << k; ++column) {
                    const Answer expected = answer_of(seen, row, column, k);
                    unknown += expected == Answer::none ? 1.0 : 0.0;
                    for (unsigned finer = k; finer <= 6; ++finer) {
                        const CosineStrata::Cell cell{static_cast<std::uint8_t>(((column + 1) << (finer - k)) - 1),
                                                      static_cast<std::uint8_t>(row << (finer - k)), 0, 0};
                        ASSERT_EQ(known.at(cell, finer), expected) << seed << " " << k;
                        ASSERT_EQ(later.at(cell, finer), expected) << seed << " " << k;
                    }
                }
            }
            const double share = unknown / samples;
            EXPECT_DOUBLE_EQ(known.traced_share(), share + (1.0 - share) / 16.0);
        }
    }
}

TEST(KnownCells, AreNoneOfFewerThan64Samples) {
    const KnownCells known(Seen(1).cells, 63, 16);
    EXPECT_EQ(known.traced_share(), 1.0);
    EXPECT_EQ(known.at({0, 0, 0, 0}, 3), Answer::none);
}

TEST(KnownCells, AreNoneOfAFewTexelsFewSamples) {
    const Seen seen(1);
    EXPECT_EQ(KnownCells(seen.cells, 1023, 1).traced_share(), 1.0);
    EXPECT_LT(KnownCells(seen.cells, 1024, 1).traced_share(), 1.0);
}

TEST(KnownCells, MarkedAreSeenAllOver) {
    Seen seen(3);
    const KnownCells known(seen.cells, 64, 16);
    known.mark(seen.cells);
    for (std::size_t row = 0; row < cells_a_side; ++row) {
        for (std::size_t column = 0; column < cells_a_side; ++column) {
            const Answer answer = answer_of(seen, row / 4, column / 4, 3);
            const auto bit = [&](const CellVisibility::Rows& rows) { return (rows[row] >> column & 1U) != 0; };
            EXPECT_EQ(bit(seen.cells.open()), seen.open[row][column] || answer == Answer::open);
            EXPECT_EQ(bit(seen.cells.blocked()), seen.blocked[row][column] || answer == Answer::blocked);
        }
    }
}

} // namespace
} // namespace vkbake
