#include "trace/cell_visibility.hpp"

#include <algorithm>
#include <bit>

namespace vkbake {

namespace {

/// Of each pair of a row's bits whether one is set, in half as many.
std::uint32_t halved(std::uint32_t row) {
    std::uint32_t half = 0;
    for (unsigned column = 0; column < CellVisibility::side / 2; ++column) {
        half |= std::uint32_t{(row >> (2 * column) & 3U) != 0} << column;
    }
    return half;
}

/// Each bit of the lower half of a row twice.
std::uint32_t doubled(std::uint32_t row) {
    std::uint32_t twice = 0;
    for (unsigned column = 0; column < CellVisibility::side / 2; ++column) {
        twice |= (row >> column & 1U) * (3U << (2 * column));
    }
    return twice;
}

/// Of larger cells whether one of those within is set.
CellVisibility::Rows folded(const CellVisibility::Rows& rows, unsigned bits) {
    const unsigned fold = CellVisibility::bits - bits;
    CellVisibility::Rows result{};
    for (std::size_t row = 0; row < rows.size(); ++row) {
        result[row >> fold] |= rows[row];
    }
    for (std::size_t row = 0; row < std::size_t{1} << bits; ++row) {
        for (unsigned i = 0; i < fold; ++i) {
            result[row] = halved(result[row]);
        }
    }
    return result;
}

/// The cells that are set, and the four beside each.
CellVisibility::Rows widened(const CellVisibility::Rows& rows) {
    CellVisibility::Rows result{};
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const std::uint32_t above = row > 0 ? rows[row - 1] : 0U;
        const std::uint32_t below = row + 1 < rows.size() ? rows[row + 1] : 0U;
        result[row] = rows[row] | rows[row] << 1U | rows[row] >> 1U | above | below;
    }
    return result;
}

int count(const CellVisibility::Rows& rows) {
    int set = 0;
    for (const std::uint32_t row : rows) {
        set += std::popcount(row);
    }
    return set;
}

} // namespace

KnownCells::KnownCells(const CellVisibility& seen, std::uint32_t samples, std::uint32_t texels) {
    const auto of_whole_tile = static_cast<std::uint32_t>(std::uint64_t{samples} * texels / RayBlock::lanes);
    if (of_whole_tile < least_samples) {
        return;
    }
    m_bits = std::min((static_cast<unsigned>(std::bit_width(of_whole_tile)) - 1U) / 2U, CellVisibility::bits);
    const CellVisibility::Rows open = folded(seen.open(), m_bits);
    const CellVisibility::Rows blocked = folded(seen.blocked(), m_bits);
    const CellVisibility::Rows about_open = widened(open);
    const CellVisibility::Rows about_blocked = widened(blocked);
    for (std::size_t row = 0; row < open.size(); ++row) {
        m_open[row] = open[row] & ~about_blocked[row];
        m_blocked[row] = blocked[row] & ~about_open[row];
    }
}

double KnownCells::traced_share() const {
    const double known = (count(m_open) + count(m_blocked)) / static_cast<double>(1U << (2 * m_bits));
    return 1.0 - known + known / static_cast<double>(checked_strata);
}

void KnownCells::mark(CellVisibility& seen) const {
    const unsigned fold = CellVisibility::bits - m_bits;
    const auto spread = [&](std::uint32_t row) {
        for (unsigned i = 0; i < fold; ++i) {
            row = doubled(row);
        }
        return row;
    };
    for (std::size_t row = 0; row < std::size_t{1} << m_bits; ++row) {
        const std::uint32_t open = spread(m_open[row]);
        const std::uint32_t blocked = spread(m_blocked[row]);
        for (std::size_t within = row << fold; within < (row + 1) << fold; ++within) {
            seen.add(within, open, blocked);
        }
    }
}

} // namespace vkbake
