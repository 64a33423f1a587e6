#include "trace/cosine_strata.hpp"

#include <numeric>
#include <utility>

#include "base/sampling_sobol.hpp"

namespace vkbake {

namespace {

unsigned bits_for(std::uint32_t rays) {
    unsigned bits = 0;
    while (bits < CosineStrata::most_bits && (rays >> (2 * (bits + 1))) != 0) {
        ++bits;
    }
    return bits;
}

/// The cell at a place along Hilbert's curve: from the finest digit of the place to the coarsest, the square so far is
/// turned as its quarter demands, and put there.
CosineStrata::Cell hilbert_cell(std::uint32_t place, unsigned bits) {
    std::uint32_t column = 0;
    std::uint32_t row = 0;
    for (unsigned level = 0; level < bits; ++level) {
        const std::uint32_t quarter = (place >> (2 * level)) & 3U;
        const std::uint32_t size = 1U << level;
        const bool right = quarter >= 2;
        const bool upper = quarter == 1 || quarter == 2;
        if (!upper) {
            if (right) {
                column = size - 1 - column;
                row = size - 1 - row;
            }
            std::swap(column, row);
        }
        column += right ? size : 0;
        row += upper ? size : 0;
    }
    const auto reversed = [&](std::uint32_t number) {
        return static_cast<std::uint8_t>((std::uint64_t{reverse_bits(number)} << bits) >> 32U);
    };
    return {static_cast<std::uint8_t>(column), static_cast<std::uint8_t>(row), reversed(column), reversed(row)};
}

} // namespace

CosineStrata::CosineStrata(std::uint32_t rays, std::uint32_t first)
    : m_rays(rays), m_first(first), m_bits(bits_for(rays)),
      m_count(((std::uint64_t{rays} + (1ULL << (2 * m_bits)) - 1) >> (2 * m_bits)) << (2 * m_bits)) {
    const std::uint32_t cells = 1U << m_bits;
    const std::uint32_t low = cells - 1;
    for (std::uint32_t place = 0; place < cells * cells; ++place) {
        m_cells.push_back(hilbert_cell(place, m_bits));
    }
    // A row's part holds the index bits k … 2k − 1 that give it its bits: S restricted to these, inverted by trying
    // all.
    for (std::uint32_t bits = 0; bits < cells; ++bits) {
        const std::uint32_t index = bits << m_bits;
        const std::uint32_t image = sobol_dimension_1_reversed(index);
        m_row_parts[image & low] = {index, image};
    }
    // What the column's bits themselves add to S's low bits is taken back by a row's part.
    for (std::uint32_t bits = 0; bits < cells; ++bits) {
        const std::uint32_t index = bits ^ m_row_parts[sobol_dimension_1_reversed(bits) & low].index;
        m_column_parts[bits] = {index, sobol_dimension_1_reversed(index)};
    }
}

BlockStrata CosineStrata::block(std::size_t number) const {
    BlockStrata strata{.count = RayBlock::strata};
    std::iota(strata.of.begin(), strata.of.end(), first_stratum() + std::uint64_t{number} * RayBlock::strata);
    return strata;
}

CosineStrata::Part CosineStrata::round_part(std::uint32_t round) const {
    const std::uint32_t first = round << (2 * m_bits);
    const std::uint32_t low = (1U << m_bits) - 1;
    const std::uint32_t index = first ^ m_row_parts[sobol_dimension_1_reversed(first) & low].index;
    return {index, sobol_dimension_1_reversed(index)};
}

} // namespace vkbake
