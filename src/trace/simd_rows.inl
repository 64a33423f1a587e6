// Rows of 16 lanes as vectors of the target's width. Included once for each target, inside its namespace.
//
// All arithmetic is plain: addition, multiplication, division and square root as IEEE 754 rounds them, nothing fused,
// nothing approximate. So each lane has the same bits on every target.

using Lanes = hn::CappedTag<float, RayBlock::lanes>;
using WordLanes = hn::RebindToUnsigned<Lanes>;
using WholeLanes = hn::RebindToSigned<Lanes>;
using Vector = hn::Vec<Lanes>;
using Words = hn::Vec<WordLanes>;
using Wholes = hn::Vec<WholeLanes>;
using Mask = hn::Mask<Lanes>;

struct Vector3 {
    Vector x, y, z;
};

HWY_INLINE Vector set(float value) { return hn::Set(Lanes(), value); }
HWY_INLINE Words set_word(std::uint32_t value) { return hn::Set(WordLanes(), value); }
HWY_INLINE Vector load(const RayBlock::LaneRow& row, std::size_t first) { return hn::Load(Lanes(), &row[first]); }
HWY_INLINE Vector3 load(const std::array<RayBlock::LaneRow, 3>& rows, std::size_t first) {
    return {load(rows[0], first), load(rows[1], first), load(rows[2], first)};
}
HWY_INLINE void store(const Vector3& value, std::array<RayBlock::LaneRow, 3>& rows, std::size_t first) {
    const Lanes lanes;
    hn::Store(value.x, lanes, &rows[0][first]);
    hn::Store(value.y, lanes, &rows[1][first]);
    hn::Store(value.z, lanes, &rows[2][first]);
}
HWY_INLINE Vector dot(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// A mask as bits, moved to the place of its part of a row.
HWY_INLINE unsigned bits_at(std::size_t first, Mask mask) {
    std::array<std::uint8_t, 8> bytes{};
    const std::size_t count = hn::StoreMaskBits(Lanes(), mask, bytes.data());
    return (static_cast<unsigned>(bytes[0]) | (count > 1 ? static_cast<unsigned>(bytes[1]) << 8U : 0U)) << first;
}

/// The part of a row's bits that begins at `first`, as a mask.
HWY_INLINE Mask mask_at(std::size_t first, unsigned bits) {
    const WordLanes words;
    const Words own = hn::Shl(set_word(1), hn::Iota(words, static_cast<std::uint32_t>(first)));
    return hn::RebindMask(Lanes(), hn::Ne(hn::And(set_word(bits), own), hn::Zero(words)));
}
