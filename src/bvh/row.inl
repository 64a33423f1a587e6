// Sixteen floats at once, whatever the width of the vectors: what the kernels are written in. No include guard: it is
// included once for each instruction set, inside HWY_NAMESPACE, where `hn` stands for Highway's.

using Lanes = hn::CappedTag<float, 16>;
using Vector = hn::Vec<Lanes>;
constexpr std::size_t row_size = 16;
constexpr std::size_t part_size = hn::MaxLanes(Lanes());
constexpr std::size_t part_count = row_size / part_size;

/// Lanes side by side in some vectors.
template<std::size_t Parts>
struct Wide {
    Vector part[Parts]; // NOLINT(modernize-avoid-c-arrays): std::array's operators have no target attribute
};

/// The same of lane masks.
template<std::size_t Parts>
struct WideMask {
    hn::Mask<Lanes> part[Parts]; // NOLINT(modernize-avoid-c-arrays): as above

    /// Bit l: lane l.
    [[nodiscard]] HWY_INLINE unsigned bits() const {
        unsigned all = 0;
        for (std::size_t p = 0; p < Parts; ++p) {
            // NOLINTNEXTLINE(modernize-avoid-c-arrays,cppcoreguidelines-pro-type-member-init): as above; written below
            alignas(8) std::uint8_t bytes[8];
            hn::StoreMaskBits(Lanes(), part[p], bytes);
            // Two at once, which stay in a register, where a vector has as many: each by itself takes three more steps.
            std::conditional_t<(part_size > 8), std::uint16_t, std::uint8_t> bits = 0;
            std::memcpy(&bits, bytes, sizeof bits);
            all |= static_cast<unsigned>(bits) << (p * part_size);
        }
        return all;
    }
};

using Row = Wide<part_count>; ///< 16 lanes
using RowMask = WideMask<part_count>;

template<std::size_t Parts, class Function>
HWY_INLINE Wide<Parts> each_part(Function function) {
    Wide<Parts> row;
    for (std::size_t p = 0; p < Parts; ++p) {
        row.part[p] = function(p);
    }
    return row;
}

template<std::size_t Parts, class Function>
HWY_INLINE WideMask<Parts> each_mask(Function function) {
    WideMask<Parts> mask;
    for (std::size_t p = 0; p < Parts; ++p) {
        mask.part[p] = function(p);
    }
    return mask;
}

/// From 16 floats that are aligned to 64 bytes.
HWY_INLINE Row load(const float* row) {
    return each_part<part_count>([=](std::size_t p) HWY_ATTR { return hn::Load(Lanes(), row + p * part_size); });
}
HWY_INLINE Row load(const std::array<float, row_size>& row) { return load(row.data()); }
HWY_INLINE Wide<1> load_part(const std::array<float, row_size>& row, std::size_t part) {
    return {{hn::Load(Lanes(), row.data() + part * part_size)}};
}
HWY_INLINE void store(const Row& row, std::array<float, row_size>& to) {
    for (std::size_t p = 0; p < part_count; ++p) {
        hn::Store(row.part[p], Lanes(), to.data() + p * part_size);
    }
}
template<std::size_t Parts = part_count>
HWY_INLINE Wide<Parts> fill(float value) {
    return each_part<Parts>([=](std::size_t /*p*/) HWY_ATTR { return hn::Set(Lanes(), value); });
}

template<std::size_t Parts>
HWY_INLINE Wide<Parts> operator+(const Wide<Parts>& a, const Wide<Parts>& b) {
    return each_part<Parts>([&](std::size_t p) HWY_ATTR { return a.part[p] + b.part[p]; });
}
template<std::size_t Parts>
HWY_INLINE Wide<Parts> operator-(const Wide<Parts>& a, const Wide<Parts>& b) {
    return each_part<Parts>([&](std::size_t p) HWY_ATTR { return a.part[p] - b.part[p]; });
}
template<std::size_t Parts>
HWY_INLINE Wide<Parts> operator*(const Wide<Parts>& a, const Wide<Parts>& b) {
    return each_part<Parts>([&](std::size_t p) HWY_ATTR { return a.part[p] * b.part[p]; });
}
template<std::size_t Parts>
HWY_INLINE Wide<Parts> operator/(const Wide<Parts>& a, const Wide<Parts>& b) {
    return each_part<Parts>([&](std::size_t p) HWY_ATTR { return a.part[p] / b.part[p]; });
}
template<std::size_t Parts>
HWY_INLINE Wide<Parts> min(const Wide<Parts>& a, const Wide<Parts>& b) {
    return each_part<Parts>([&](std::size_t p) HWY_ATTR { return hn::Min(a.part[p], b.part[p]); });
}
template<std::size_t Parts>
HWY_INLINE Wide<Parts> max(const Wide<Parts>& a, const Wide<Parts>& b) {
    return each_part<Parts>([&](std::size_t p) HWY_ATTR { return hn::Max(a.part[p], b.part[p]); });
}
template<std::size_t Parts>
HWY_INLINE Wide<Parts> abs(const Wide<Parts>& a) {
    return each_part<Parts>([&](std::size_t p) HWY_ATTR { return hn::Abs(a.part[p]); });
}
/// The magnitudes of one with the signs of the other.
template<std::size_t Parts>
HWY_INLINE Wide<Parts> copy_sign(const Wide<Parts>& magnitude, const Wide<Parts>& sign) {
    return each_part<Parts>([&](std::size_t p) HWY_ATTR { return hn::CopySign(magnitude.part[p], sign.part[p]); });
}

/// Turned where the other one's sign bit is set.
template<std::size_t Parts>
HWY_INLINE Wide<Parts> turned_by_sign(const Wide<Parts>& a, const Wide<Parts>& sign) {
    return each_part<Parts>([&](std::size_t p)
                                HWY_ATTR { return hn::Xor(a.part[p], hn::And(sign.part[p], hn::SignBit(Lanes()))); });
}

/// a · b − c, rounded once where the machine can, else twice: for boxes and beams, whose pads cover either, and where
/// the product is exact.
template<std::size_t Parts>
HWY_INLINE Wide<Parts> multiply_subtract(const Wide<Parts>& a, const Wide<Parts>& b, const Wide<Parts>& c) {
    return each_part<Parts>([&](std::size_t p) HWY_ATTR { return hn::MulSub(a.part[p], b.part[p], c.part[p]); });
}
/// a · b + c, likewise.
template<std::size_t Parts>
HWY_INLINE Wide<Parts> multiply_add(const Wide<Parts>& a, const Wide<Parts>& b, const Wide<Parts>& c) {
    return each_part<Parts>([&](std::size_t p) HWY_ATTR { return hn::MulAdd(a.part[p], b.part[p], c.part[p]); });
}
/// c − a · b, likewise.
template<std::size_t Parts>
HWY_INLINE Wide<Parts> negated_multiply_add(const Wide<Parts>& a, const Wide<Parts>& b, const Wide<Parts>& c) {
    return each_part<Parts>([&](std::size_t p) HWY_ATTR { return hn::NegMulAdd(a.part[p], b.part[p], c.part[p]); });
}

template<std::size_t Parts>
HWY_INLINE WideMask<Parts> operator<(const Wide<Parts>& a, const Wide<Parts>& b) {
    return each_mask<Parts>([&](std::size_t p) HWY_ATTR { return hn::Lt(a.part[p], b.part[p]); });
}
template<std::size_t Parts>
HWY_INLINE WideMask<Parts> operator<=(const Wide<Parts>& a, const Wide<Parts>& b) {
    return each_mask<Parts>([&](std::size_t p) HWY_ATTR { return hn::Le(a.part[p], b.part[p]); });
}
template<std::size_t Parts>
HWY_INLINE WideMask<Parts> operator==(const Wide<Parts>& a, const Wide<Parts>& b) {
    return each_mask<Parts>([&](std::size_t p) HWY_ATTR { return hn::Eq(a.part[p], b.part[p]); });
}
template<std::size_t Parts>
HWY_INLINE WideMask<Parts> operator&(const WideMask<Parts>& a, const WideMask<Parts>& b) {
    return each_mask<Parts>([&](std::size_t p) HWY_ATTR { return hn::And(a.part[p], b.part[p]); });
}
template<std::size_t Parts>
HWY_INLINE WideMask<Parts> operator|(const WideMask<Parts>& a, const WideMask<Parts>& b) {
    return each_mask<Parts>([&](std::size_t p) HWY_ATTR { return hn::Or(a.part[p], b.part[p]); });
}
/// The lanes of a that are not of b.
template<std::size_t Parts>
HWY_INLINE WideMask<Parts> and_not(const WideMask<Parts>& a, const WideMask<Parts>& b) {
    return each_mask<Parts>([&](std::size_t p) HWY_ATTR { return hn::AndNot(b.part[p], a.part[p]); });
}
template<std::size_t Parts>
HWY_INLINE Wide<Parts> select(const WideMask<Parts>& mask, const Wide<Parts>& yes, const Wide<Parts>& no) {
    return each_part<Parts>([&](std::size_t p)
                                HWY_ATTR { return hn::IfThenElse(mask.part[p], yes.part[p], no.part[p]); });
}
HWY_INLINE RowMask mask_from_bits(unsigned bits) {
    return each_mask<part_count>([=](std::size_t p) HWY_ATTR {
        const unsigned part = bits >> (p * part_size);
        alignas(8) const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(part), // NOLINT(modernize-avoid-c-arrays)
                                                  static_cast<std::uint8_t>(part >> 8U)};
        return hn::LoadMaskBits(Lanes(), bytes);
    });
}

/// Writes the numbers in the lanes of the mask, each with `added`, one after the other from `to` on, where room for 16
/// must be. Returns how many.
HWY_INLINE std::size_t compress(const std::array<std::uint32_t, row_size>& numbers, const RowMask& mask,
                                std::uint32_t* to, std::uint32_t added = 0) {
    const hn::RebindToUnsigned<Lanes> unsigned_lanes;
    const auto part = [&](std::size_t p) HWY_ATTR {
        return hn::Load(unsigned_lanes, numbers.data() + p * part_size) + hn::Set(unsigned_lanes, added);
    };
    const unsigned bits = mask.bits();
    if constexpr (part_count == 1) {
        hn::StoreU(hn::Compress(part(0), hn::RebindMask(unsigned_lanes, mask.part[0])), unsigned_lanes, to);
    } else {
        // Not by CompressStore: Highway 1.0.3 with GCC 12 copies its table of a kilobyte to the stack at every call.
        for (std::size_t p = 0, count = 0; p < part_count; ++p) {
            const unsigned lanes = bits >> (p * part_size) & ((1U << part_size) - 1);
            const auto places = hn::PromoteTo(
                unsigned_lanes, hn::Load(hn::Rebind<std::uint8_t, Lanes>(), lanes_in_front[lanes].data()));
            hn::StoreU(hn::TableLookupLanes(part(p), hn::IndicesFromVec(unsigned_lanes, places)), unsigned_lanes,
                       to + count);
            count += static_cast<std::size_t>(std::popcount(lanes));
        }
    }
    return static_cast<std::size_t>(std::popcount(bits));
}

/// Each lane's own number.
alignas(64) constexpr std::array<std::uint32_t, row_size> lane_numbers{0, 1, 2,  3,  4,  5,  6,  7,
                                                                       8, 9, 10, 11, 12, 13, 14, 15};

/// The lanes whose number is not this one.
HWY_INLINE RowMask unlike(const std::array<std::uint32_t, row_size>& numbers, std::uint32_t number) {
    const hn::RebindToUnsigned<Lanes> unsigned_lanes;
    return each_mask<part_count>([&](std::size_t p) HWY_ATTR {
        return hn::RebindMask(Lanes(), hn::Load(unsigned_lanes, numbers.data() + p * part_size) !=
                                           hn::Set(unsigned_lanes, number));
    });
}

/// The lanes whose number differs from this one in the bits of the mask.
HWY_INLINE RowMask differ(const std::array<std::uint32_t, row_size>& numbers, std::uint32_t number,
                          std::uint32_t mask) {
    const hn::RebindToUnsigned<Lanes> unsigned_lanes;
    return each_mask<part_count>([&](std::size_t p) HWY_ATTR {
        const auto row = hn::Load(unsigned_lanes, numbers.data() + p * part_size);
        return hn::RebindMask(Lanes(),
                              hn::And(row, hn::Set(unsigned_lanes, mask)) != hn::Set(unsigned_lanes, number & mask));
    });
}

/// The lanes whose number has its highest bit set.
HWY_INLINE RowMask with_top_bit(const std::array<std::uint32_t, row_size>& numbers) {
    const hn::RebindToSigned<Lanes> signed_lanes;
    return each_mask<part_count>([&](std::size_t p) HWY_ATTR {
        const auto row = hn::Load(hn::RebindToUnsigned<Lanes>(), numbers.data() + p * part_size);
        return hn::RebindMask(Lanes(), hn::MaskFromVec(hn::BroadcastSignBit(hn::BitCast(signed_lanes, row))));
    });
}

/// For each lane of a part a lane of a row.
using Places = hn::Vec<hn::RebindToUnsigned<Lanes>>;

/// The places that four bits each hold: those that begin at bit `Shift`, of one part.
template<int Shift>
HWY_INLINE Places unpack_places(const std::array<std::uint16_t, row_size>& packed, std::size_t part) {
    const hn::RebindToUnsigned<Lanes> unsigned_lanes;
    const hn::Rebind<std::uint16_t, Lanes> short_lanes;
    const auto row = hn::PromoteTo(unsigned_lanes, hn::Load(short_lanes, packed.data() + part * part_size));
    return hn::And(hn::ShiftRight<Shift>(row), hn::Set(unsigned_lanes, 15U));
}

HWY_INLINE Wide<1> pick(const Row& row, const Places& places) {
#if HWY_TARGET == HWY_SCALAR
    alignas(64) std::array<float, row_size> from{};
    store(row, from);
    return {{hn::Set(Lanes(), from[hn::GetLane(places)])}};
#else
    // From each of the row's vectors that lane which would be the one if it were there.
    const hn::RebindToUnsigned<Lanes> unsigned_lanes;
    const hn::RebindToSigned<Lanes> signed_lanes;
    const auto within =
        hn::IndicesFromVec(Lanes(), hn::And(places, hn::Set(unsigned_lanes, std::uint32_t{part_size - 1})));
    Vector picked = hn::TableLookupLanes(row.part[0], within);
    for (std::size_t p = 1; p < part_count; ++p) {
        const auto before = hn::Set(signed_lanes, static_cast<std::int32_t>(p * part_size) - 1);
        const auto there = hn::RebindMask(Lanes(), before < hn::BitCast(signed_lanes, places));
        picked = hn::IfThenElse(there, hn::TableLookupLanes(row.part[p], within), picked);
    }
    return {{picked}};
#endif
}

/// 16 times the same number.
HWY_INLINE void fill_numbers(std::uint32_t number, std::uint32_t* to) {
    const hn::RebindToUnsigned<Lanes> unsigned_lanes;
    for (std::size_t p = 0; p < part_count; ++p) {
        hn::StoreU(hn::Set(unsigned_lanes, number), unsigned_lanes, to + p * part_size);
    }
}

HWY_INLINE float greatest_lane(const Row& row) {
    Vector all = row.part[0];
    for (std::size_t p = 1; p < part_count; ++p) {
        all = hn::Max(all, row.part[p]);
    }
    return hn::GetLane(hn::MaxOfLanes(Lanes(), all));
}
HWY_INLINE float least_lane(const Row& row) {
    Vector all = row.part[0];
    for (std::size_t p = 1; p < part_count; ++p) {
        all = hn::Min(all, row.part[p]);
    }
    return hn::GetLane(hn::MinOfLanes(Lanes(), all));
}

/// 16 rows to one: lane i is the least of row i.
template<class Combine>
HWY_INLINE Row reduce_rows(const std::array<std::array<float, row_size>, row_size>& rows, Combine combine) {
    Vector level[row_size]; // NOLINT(modernize-avoid-c-arrays): as above
    for (std::size_t i = 0; i < row_size; ++i) {
        level[i] = hn::Load(Lanes(), rows[i].data());
        for (std::size_t p = 1; p < part_count; ++p) {
            level[i] = combine(level[i], hn::Load(Lanes(), rows[i].data() + p * part_size));
        }
    }
#if HWY_TARGET != HWY_SCALAR // where a row's first step was the last one
    // Each step halves what is left of a row and lays two rows side by side, in order.
    for (std::size_t count = row_size; count > part_count; count /= 2) {
        for (std::size_t i = 0; i < count / 2; ++i) {
            const Vector& low = level[2 * i];
            const Vector& high = level[2 * i + 1];
            level[i] = combine(hn::ConcatEven(Lanes(), high, low), hn::ConcatOdd(Lanes(), high, low));
        }
    }
#endif
    return each_part<part_count>([&](std::size_t p) HWY_ATTR { return level[p]; });
}
HWY_INLINE Row least_of_rows(const std::array<std::array<float, row_size>, row_size>& rows) {
    return reduce_rows(rows, [](Vector a, Vector b) HWY_ATTR { return hn::Min(a, b); });
}
HWY_INLINE Row greatest_of_rows(const std::array<std::array<float, row_size>, row_size>& rows) {
    return reduce_rows(rows, [](Vector a, Vector b) HWY_ATTR { return hn::Max(a, b); });
}
