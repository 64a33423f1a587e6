#include "trace/directions.hpp"

#include <bit>

#include "base/sampling_sobol.hpp"
#include "base/simd_targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/directions.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace vkbake::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#include "trace/simd_rows.inl"

#include "trace/simd_elementary.inl"

/// As reverse_bits() of base/sampling_sobol.hpp.
HWY_INLINE Words reverse_bits(Words word) {
#if HWY_TARGET == HWY_SCALAR
    return set_word(vkbake::reverse_bits(hn::GetLane(word)));
#else
    // Half a byte at a time by a table, then the bytes' order: a third of the work of five rounds of swaps.
    const hn::Repartition<std::uint8_t, WordLanes> bytes;
    alignas(16) constexpr std::array<std::uint8_t, 16> reversed{0, 8, 4, 12, 2, 10, 6, 14, 1, 9, 5, 13, 3, 11, 7, 15};
    alignas(16) constexpr std::array<std::uint8_t, 16> order{3, 2, 1, 0, 7, 6, 5, 4, 11, 10, 9, 8, 15, 14, 13, 12};
    const auto table = hn::LoadDup128(bytes, reversed.data());
    const auto low_half = hn::Set(bytes, 0x0F);
    const auto low = hn::And(hn::BitCast(bytes, word), low_half);
    const auto high = hn::And(hn::BitCast(bytes, hn::ShiftRight<4>(word)), low_half);
    const Words turned_low = hn::ShiftLeft<4>(hn::BitCast(WordLanes(), hn::TableLookupBytes(table, low)));
    const Words turned = hn::Or(turned_low, hn::BitCast(WordLanes(), hn::TableLookupBytes(table, high)));
    return hn::BitCast(WordLanes(),
                       hn::TableLookupBytes(hn::BitCast(bytes, turned), hn::LoadDup128(bytes, order.data())));
#endif
}

/// As nested_scramble_reversed() of base/sampling_sobol.hpp; the seed's product with its high half is the caller's.
HWY_INLINE Words nested_scramble_reversed(Words word, Words seed, Words factor) {
    word = hn::Xor(word, word * set_word(0x3D20ADEAU));
    word = (word + seed) * factor;
    word = hn::Xor(word, word * set_word(0x05526C56U));
    return hn::Xor(word, word * set_word(0x53A22864U));
}

enum class Coordinate { x, y };

/// One coordinate's shift and scramble of a part of the lanes.
class Scramble {
public:
    HWY_INLINE Scramble(const LaneScrambles& scrambles, std::size_t first, Coordinate coordinate)
        : m_seed(hn::Zero(WordLanes())), m_factor(m_seed), m_shift(m_seed) {
        const bool in_x = coordinate == Coordinate::x; // halves as ScrambledSobol has them
        alignas(64) std::array<std::uint32_t, RayBlock::lanes> seeds{};
        for (std::size_t lane = 0; lane < RayBlock::lanes; ++lane) {
            seeds[lane] = static_cast<std::uint32_t>(scrambles.key[lane] >> (in_x ? 32U : 0U));
        }
        m_seed = hn::Load(WordLanes(), &seeds[first]);
        m_shift = hn::Load(WordLanes(), in_x ? &scrambles.shift_x[first] : &scrambles.shift_y[first]);
        m_factor = hn::Or(hn::ShiftRight<16>(m_seed), set_word(1));
    }

    /// With its digits reversed still.
    HWY_INLINE Words operator()(Words word) const {
        return nested_scramble_reversed(hn::Xor(word, m_shift), m_seed, m_factor);
    }

private:
    Words m_seed, m_factor, m_shift;
};

void invert_scrambles(const CosineStrata& strata, const TileLanes& lanes, StratumTables& tables) {
    const WordLanes words;
    alignas(64) std::array<std::uint32_t, RayBlock::lanes> columns{};
    alignas(64) std::array<std::uint32_t, RayBlock::lanes> rows{};
    const std::uint32_t cells = 1U << strata.bits();
    for (std::size_t first = 0; first < RayBlock::lanes; first += hn::Lanes(words)) {
        const Scramble in_x(lanes.scrambles, first, Coordinate::x);
        const Scramble in_y(lanes.scrambles, first, Coordinate::y);
        for (std::uint32_t low = 0; low < cells; ++low) {
            hn::Store(hn::And(in_x(set_word(low)), set_word(cells - 1)), words, columns.data());
            hn::Store(hn::And(in_y(set_word(low)), set_word(cells - 1)), words, rows.data());
            const CosineStrata::Part column = strata.column_part(low);
            const CosineStrata::Part row = strata.row_part(low);
            for (std::size_t i = 0; i < hn::Lanes(words); ++i) {
                tables.columns[columns[i]].index[first + i] = column.index;
                tables.columns[columns[i]].image[first + i] = column.image;
                tables.rows[rows[i]].index[first + i] = row.index;
                tables.rows[rows[i]].image[first + i] = row.image;
            }
        }
    }
}

/// The first 24 digits x of a coordinate as the number (2x + 1) / 2²⁴ − 1: exact, and never 0, ±1.
HWY_INLINE Vector centred(Words digits) {
    const WholeLanes wholes;
    const Words doubled = hn::Or(hn::ShiftRight<7>(digits), set_word(1));
    return hn::ConvertTo(Lanes(), hn::BitCast(wholes, doubled) - hn::Set(wholes, 1 << 24)) * set(0x1p-24F);
}

/// From a point of [−1, 1]² to a direction about +Z.
HWY_INLINE Vector3 cosine_hemisphere(Vector x, Vector y) {
    const Mask wide = hn::Gt(hn::Abs(x), hn::Abs(y));
    const Vector radius = hn::IfThenElse(wide, x, y);
    const Vector ratio = hn::IfThenElse(wide, y, x) / radius;
    const SineCosineOf turn = sine_cosine(ratio * set(0x1.921fb6p-1F));
    const Vector along = radius * turn.cosine;
    const Vector across = radius * turn.sine;
    // One of the two factors is exact, so near the horizon the height keeps all its digits.
    const Vector height = hn::Sqrt((set(1.0F) - radius) * (set(1.0F) + radius));
    return {hn::IfThenElse(wide, along, across), hn::IfThenElse(wide, across, along), height};
}

/// The same point of the disk on the hemisphere of which each part has its share.
HWY_INLINE Vector3 even_hemisphere(const Vector3& cosine_weighted) {
    const Vector height = cosine_weighted.z * cosine_weighted.z;
    const Vector widening = hn::Sqrt(set(1.0F) + height);
    return {cosine_weighted.x * widening, cosine_weighted.y * widening, height};
}

/// The frames of a part of the lanes.
class Frames {
public:
    HWY_INLINE Frames(const TileLanes& lanes, std::size_t first)
        : m_tangent(load(lanes.tangent, first)), m_bitangent(load(lanes.bitangent, first)),
          m_normal(load(lanes.normal, first)), m_geometric_normal(load(lanes.geometric_normal, first)) {}

    HWY_INLINE Vector3 to_world(const Vector3& local) const {
        return {m_tangent.x * local.x + m_bitangent.x * local.y + m_normal.x * local.z,
                m_tangent.y * local.x + m_bitangent.y * local.y + m_normal.y * local.z,
                m_tangent.z * local.x + m_bitangent.z * local.y + m_normal.z * local.z};
    }

    HWY_INLINE Mask above(const Vector3& direction) const {
        return hn::Gt(dot(direction, m_geometric_normal), hn::Zero(Lanes()));
    }

private:
    Vector3 m_tangent, m_bitangent, m_normal, m_geometric_normal;
};

/// Where to find what makes up the indices of one stratum.
struct Place {
    const StratumTables::Rows* column = nullptr;
    const StratumTables::Rows* row = nullptr;
    CosineStrata::Part round;
};

/// Of a block's strata; beforehand, for a call within the loop over them would empty the vector registers.
HWY_INLINE std::array<Place, RayBlock::strata> places_of(const CosineStrata& strata, const StratumTables& tables,
                                                         const BlockStrata& numbers) {
    std::array<Place, RayBlock::strata> places{};
    for (std::size_t i = 0; i < RayBlock::strata; ++i) {
        const CosineStrata::Cell cell = strata.cell(numbers.of[i]);
        places[i] = {&tables.columns[cell.reversed_column], &tables.rows[cell.reversed_row],
                     strata.round_part(strata.round(numbers.of[i]))};
    }
    return places;
}

using StratumBits = std::array<unsigned, RayBlock::strata>;

/// The samples' points in the square, as x and y of the block's directions, of a part of the lanes; adds to `asked`.
HWY_INLINE void place_points(const CosineStrata& strata, const std::array<Place, RayBlock::strata>& places,
                             const TileLanes& lanes, std::size_t first, RayBlock& block, SampleIndices* indices,
                             StratumBits& asked) {
    const WordLanes words;
    const Words first_index = set_word(strata.first());
    const Words index_count = set_word(strata.rays() - strata.first());
    const Scramble in_x(lanes.scrambles, first, Coordinate::x);
    const Scramble in_y(lanes.scrambles, first, Coordinate::y);
    for (std::size_t i = 0; i < RayBlock::strata; ++i) {
        const StratumTables::Rows& column = *places[i].column;
        const StratumTables::Rows& row = *places[i].row;
        const CosineStrata::Part& round = places[i].round;
        const auto joined = [&](const auto& in_column, const auto& in_row, std::uint32_t in_round) HWY_ATTR {
            return hn::Xor(hn::Xor(hn::Load(words, &in_column[first]), hn::Load(words, &in_row[first])),
                           set_word(in_round));
        };
        const Words index = joined(column.index, row.index, round.index);
        const Words image = joined(column.image, row.image, round.image);
        const Words x = reverse_bits(in_x(index));
        const Words y = reverse_bits(in_y(image));
        store({centred(x), centred(y), set(0.0F)}, block.direction[i], first);
        asked[i] |= bits_at(first, hn::RebindMask(Lanes(), hn::Lt(index - first_index, index_count)));
        if (indices != nullptr) {
            hn::Store(index, words, &indices->of[i][first]);
            hn::Store(hn::ShiftRight<27>(x), words, &indices->column[i][first]);
            hn::Store(hn::ShiftRight<27>(y), words, &indices->row[i][first]);
        }
    }
}

void square_points(const CosineStrata& strata, const StratumTables& tables, const TileLanes& lanes, std::size_t number,
                   RayBlock& block, SampleIndices* indices) {
    const auto places = places_of(strata, tables, strata.block(number));
    StratumBits asked{};
    for (std::size_t first = 0; first < RayBlock::lanes; first += hn::Lanes(WordLanes())) {
        place_points(strata, places, lanes, first, block, indices, asked);
    }
    for (std::size_t i = 0; i < RayBlock::strata; ++i) {
        block.active[i] = static_cast<RayBlock::LaneBits>(asked[i] & lanes.covered);
    }
}

std::uint32_t cosine_directions(const CosineStrata& strata, const StratumTables& tables, const TileLanes& lanes,
                                const BlockStrata& numbers, RayBlock& block, SampleIndices* indices) {
    const auto places = places_of(strata, tables, numbers);
    StratumBits asked{};
    StratumBits active{};
    for (std::size_t first = 0; first < RayBlock::lanes; first += hn::Lanes(WordLanes())) {
        const Frames frames(lanes, first);
        // Point, direction about +Z, direction in the world: three short loops, for in one long one each ray's chain of
        // operations, 150 cycles, would hide behind too few others.
        place_points(strata, places, lanes, first, block, indices, asked);
        for (auto& rows : block.direction) {
            const Vector3 point = load(rows, first);
            store(cosine_hemisphere(point.x, point.y), rows, first);
        }
        for (std::size_t i = 0; i < RayBlock::strata; ++i) {
            const Vector3 direction = frames.to_world(load(block.direction[i], first));
            store(direction, block.direction[i], first);
            active[i] |= bits_at(first, frames.above(direction));
        }
    }
    int count = 0;
    for (std::size_t i = 0; i < RayBlock::strata; ++i) {
        asked[i] &= i < numbers.count ? lanes.covered : 0U;
        count += std::popcount(asked[i]);
        block.active[i] = static_cast<RayBlock::LaneBits>(asked[i] & active[i]);
    }
    return static_cast<std::uint32_t>(count);
}

std::uint32_t lifted_points(bool even, const TileLanes& lanes, RayBlock& block) {
    StratumBits above{};
    for (std::size_t first = 0; first < RayBlock::lanes; first += hn::Lanes(Lanes())) {
        const Frames frames(lanes, first);
        for (std::size_t i = 0; i < RayBlock::strata; ++i) {
            const Vector3 point = load(block.direction[i], first);
            const Vector3 local = cosine_hemisphere(point.x, point.y);
            const Vector3 direction = frames.to_world(even ? even_hemisphere(local) : local);
            store(direction, block.direction[i], first);
            above[i] |= bits_at(first, frames.above(direction));
        }
    }
    int count = 0;
    for (std::size_t i = 0; i < RayBlock::strata; ++i) {
        count += std::popcount(block.active[i]);
        block.active[i] = static_cast<RayBlock::LaneBits>(block.active[i] & above[i]);
    }
    return static_cast<std::uint32_t>(count);
}

std::uint32_t thesis_directions(const ThesisDirections& directions, const TileLanes& lanes, std::size_t number,
                                RayBlock& block) {
    std::array<unsigned, RayBlock::strata> active{};
    for (std::size_t first = 0; first < RayBlock::lanes; first += hn::Lanes(Lanes())) {
        const Frames frames(lanes, first);
        for (std::size_t i = 0; i < RayBlock::strata; ++i) {
            const glm::vec3& local = directions.sample(number, i).direction;
            const Vector3 direction = frames.to_world({set(local.x), set(local.y), set(local.z)});
            store(direction, block.direction[i], first);
            active[i] |= bits_at(first, frames.above(direction));
        }
    }
    for (std::size_t i = 0; i < RayBlock::strata; ++i) {
        block.active[i] = static_cast<RayBlock::LaneBits>(active[i] & lanes.covered);
    }
    return static_cast<std::uint32_t>(std::popcount(lanes.covered)) * static_cast<std::uint32_t>(RayBlock::strata);
}

} // namespace vkbake::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vkbake {

HWY_EXPORT(invert_scrambles);
HWY_EXPORT(cosine_directions);
HWY_EXPORT(square_points);
HWY_EXPORT(lifted_points);
HWY_EXPORT(thesis_directions);

void invert_scrambles(const CosineStrata& strata, const TileLanes& lanes, StratumTables& tables) {
    HWY_DYNAMIC_DISPATCH(invert_scrambles)(strata, lanes, tables);
}

std::uint32_t set_directions(const CosineStrata& strata, const StratumTables& tables, const TileLanes& lanes,
                             const BlockStrata& numbers, RayBlock& block, SampleIndices* indices) {
    return HWY_DYNAMIC_DISPATCH(cosine_directions)(strata, tables, lanes, numbers, block, indices);
}

void set_points(const CosineStrata& strata, const StratumTables& tables, const TileLanes& lanes, std::size_t number,
                RayBlock& block, SampleIndices* indices) {
    HWY_DYNAMIC_DISPATCH(square_points)(strata, tables, lanes, number, block, indices);
}

std::uint32_t lift_points(bool even, const TileLanes& lanes, RayBlock& block) {
    return HWY_DYNAMIC_DISPATCH(lifted_points)(even, lanes, block);
}

std::uint32_t set_directions(const ThesisDirections& directions, const TileLanes& lanes, std::size_t number,
                             RayBlock& block) {
    return HWY_DYNAMIC_DISPATCH(thesis_directions)(directions, lanes, number, block);
}

} // namespace vkbake
#endif
