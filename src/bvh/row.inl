// Sixteen floats at once, whatever the width of the vectors: what the kernels are written in. No include guard: it is
// included once for each instruction set, inside HWY_NAMESPACE, where `hn` stands for Highway's.

using Lanes = hn::CappedTag<float, 16>;
using Vector = hn::Vec<Lanes>;
constexpr std::size_t row_size = 16;
constexpr std::size_t part_size = hn::MaxLanes(Lanes());
constexpr std::size_t part_count = row_size / part_size;

/// Lane masks, a mask a part.
struct RowMask {
    hn::Mask<Lanes>
        part[part_count]; // NOLINT(modernize-avoid-c-arrays): std::array's operators have no target attribute

    /// Bit l: lane l.
    [[nodiscard]] HWY_INLINE unsigned bits() const {
        unsigned all = 0;
        for (std::size_t p = 0; p < part_count; ++p) {
            // NOLINTNEXTLINE(modernize-avoid-c-arrays,cppcoreguidelines-pro-type-member-init): as above; written below
            alignas(8) std::uint8_t bytes[8];
            hn::StoreMaskBits(Lanes(), part[p], bytes);
            all |= static_cast<unsigned>(bytes[0]) << (p * part_size);
            if constexpr (part_size > 8) {
                all |= static_cast<unsigned>(bytes[1]) << 8U;
            }
        }
        return all;
    }
};

struct Row {
    Vector part[part_count]; // NOLINT(modernize-avoid-c-arrays): as above
};

template<class Function>
HWY_INLINE Row each_part(Function function) {
    Row row;
    for (std::size_t p = 0; p < part_count; ++p) {
        row.part[p] = function(p);
    }
    return row;
}

template<class Function>
HWY_INLINE RowMask each_mask(Function function) {
    RowMask mask;
    for (std::size_t p = 0; p < part_count; ++p) {
        mask.part[p] = function(p);
    }
    return mask;
}

/// From 16 floats that are aligned to 64 bytes.
HWY_INLINE Row load(const float* row) {
    return each_part([=](std::size_t p) HWY_ATTR { return hn::Load(Lanes(), row + p * part_size); });
}
HWY_INLINE Row load(const std::array<float, row_size>& row) { return load(row.data()); }
HWY_INLINE void store(const Row& row, std::array<float, row_size>& to) {
    for (std::size_t p = 0; p < part_count; ++p) {
        hn::Store(row.part[p], Lanes(), to.data() + p * part_size);
    }
}
HWY_INLINE Row fill(float value) {
    return each_part([=](std::size_t /*p*/) HWY_ATTR { return hn::Set(Lanes(), value); });
}

HWY_INLINE Row operator+(const Row& a, const Row& b) {
    return each_part([&](std::size_t p) HWY_ATTR { return a.part[p] + b.part[p]; });
}
HWY_INLINE Row operator-(const Row& a, const Row& b) {
    return each_part([&](std::size_t p) HWY_ATTR { return a.part[p] - b.part[p]; });
}
HWY_INLINE Row operator*(const Row& a, const Row& b) {
    return each_part([&](std::size_t p) HWY_ATTR { return a.part[p] * b.part[p]; });
}
HWY_INLINE Row operator/(const Row& a, const Row& b) {
    return each_part([&](std::size_t p) HWY_ATTR { return a.part[p] / b.part[p]; });
}
HWY_INLINE Row min(const Row& a, const Row& b) {
    return each_part([&](std::size_t p) HWY_ATTR { return hn::Min(a.part[p], b.part[p]); });
}
HWY_INLINE Row max(const Row& a, const Row& b) {
    return each_part([&](std::size_t p) HWY_ATTR { return hn::Max(a.part[p], b.part[p]); });
}
HWY_INLINE Row abs(const Row& a) {
    return each_part([&](std::size_t p) HWY_ATTR { return hn::Abs(a.part[p]); });
}
/// The magnitudes of one with the signs of the other.
HWY_INLINE Row copy_sign(const Row& magnitude, const Row& sign) {
    return each_part([&](std::size_t p) HWY_ATTR { return hn::CopySign(magnitude.part[p], sign.part[p]); });
}

/// Turned where the other one's sign bit is set.
HWY_INLINE Row turned_by_sign(const Row& a, const Row& sign) {
    return each_part([&](std::size_t p)
                         HWY_ATTR { return hn::Xor(a.part[p], hn::And(sign.part[p], hn::SignBit(Lanes()))); });
}

/// a · b − c, rounded once where the machine can, else twice: for boxes and beams, whose pads cover either, and where
/// the product is exact.
HWY_INLINE Row multiply_subtract(const Row& a, const Row& b, const Row& c) {
    return each_part([&](std::size_t p) HWY_ATTR { return hn::MulSub(a.part[p], b.part[p], c.part[p]); });
}
/// a · b + c, likewise.
HWY_INLINE Row multiply_add(const Row& a, const Row& b, const Row& c) {
    return each_part([&](std::size_t p) HWY_ATTR { return hn::MulAdd(a.part[p], b.part[p], c.part[p]); });
}
/// c − a · b, likewise.
HWY_INLINE Row negated_multiply_add(const Row& a, const Row& b, const Row& c) {
    return each_part([&](std::size_t p) HWY_ATTR { return hn::NegMulAdd(a.part[p], b.part[p], c.part[p]); });
}

HWY_INLINE RowMask operator<(const Row& a, const Row& b) {
    return each_mask([&](std::size_t p) HWY_ATTR { return hn::Lt(a.part[p], b.part[p]); });
}
HWY_INLINE RowMask operator<=(const Row& a, const Row& b) {
    return each_mask([&](std::size_t p) HWY_ATTR { return hn::Le(a.part[p], b.part[p]); });
}
HWY_INLINE RowMask operator==(const Row& a, const Row& b) {
    return each_mask([&](std::size_t p) HWY_ATTR { return hn::Eq(a.part[p], b.part[p]); });
}
HWY_INLINE RowMask operator&(const RowMask& a, const RowMask& b) {
    return each_mask([&](std::size_t p) HWY_ATTR { return hn::And(a.part[p], b.part[p]); });
}
HWY_INLINE RowMask operator|(const RowMask& a, const RowMask& b) {
    return each_mask([&](std::size_t p) HWY_ATTR { return hn::Or(a.part[p], b.part[p]); });
}
HWY_INLINE Row select(const RowMask& mask, const Row& yes, const Row& no) {
    return each_part([&](std::size_t p) HWY_ATTR { return hn::IfThenElse(mask.part[p], yes.part[p], no.part[p]); });
}
HWY_INLINE RowMask mask_from_bits(unsigned bits) {
    return each_mask([=](std::size_t p) HWY_ATTR {
        const unsigned part = bits >> (p * part_size);
        alignas(8) const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(part), // NOLINT(modernize-avoid-c-arrays)
                                                  static_cast<std::uint8_t>(part >> 8U)};
        return hn::LoadMaskBits(Lanes(), bytes);
    });
}

/// Writes the numbers in the lanes of `bits`, each with `added`, one after the other from `to` on, where room for 16
/// must be. Returns how many.
HWY_INLINE std::size_t compress(const std::array<std::uint32_t, row_size>& numbers, unsigned bits, std::uint32_t* to,
                                std::uint32_t added = 0) {
    const hn::RebindToUnsigned<Lanes> unsigned_lanes;
    const auto part = [&](std::size_t p) HWY_ATTR {
        return hn::Load(unsigned_lanes, numbers.data() + p * part_size) + hn::Set(unsigned_lanes, added);
    };
    if constexpr (part_count == 1) {
        const auto mask = hn::RebindMask(unsigned_lanes, mask_from_bits(bits).part[0]);
        hn::CompressStore(part(0), mask, unsigned_lanes, to);
    } else {
        // Not by CompressStore: Highway 1.0.3 with GCC 12 copies its table of a kilobyte to the stack at every call.
        for (std::size_t p = 0, count = 0; p < part_count; ++p) {
            const unsigned lanes = bits >> (p * part_size) & ((1U << part_size) - 1);
            const auto places = hn::PromoteTo(unsigned_lanes, hn::Load(hn::Rebind<std::uint8_t, Lanes>(),
                                                                       lanes_in_front[lanes].data()));
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
    return each_mask([&](std::size_t p) HWY_ATTR {
        return hn::RebindMask(Lanes(), hn::Load(unsigned_lanes, numbers.data() + p * part_size) !=
                                           hn::Set(unsigned_lanes, number));
    });
}

/// The lanes whose number differs from this one in the bits of the mask.
HWY_INLINE RowMask differ(const std::array<std::uint32_t, row_size>& numbers, std::uint32_t number,
                          std::uint32_t mask) {
    const hn::RebindToUnsigned<Lanes> unsigned_lanes;
    return each_mask([&](std::size_t p) HWY_ATTR {
        const auto row = hn::Load(unsigned_lanes, numbers.data() + p * part_size);
        return hn::RebindMask(Lanes(),
                              hn::And(row, hn::Set(unsigned_lanes, mask)) != hn::Set(unsigned_lanes, number & mask));
    });
}

/// Bit l: the highest bit of lane l's number.
HWY_INLINE unsigned top_bits(const std::array<std::uint32_t, row_size>& numbers) {
    const hn::RebindToSigned<Lanes> signed_lanes;
    const RowMask negative = each_mask([&](std::size_t p) HWY_ATTR {
        const auto row = hn::Load(hn::RebindToUnsigned<Lanes>(), numbers.data() + p * part_size);
        return hn::RebindMask(Lanes(), hn::MaskFromVec(hn::BroadcastSignBit(hn::BitCast(signed_lanes, row))));
    });
    return negative.bits();
}

/// For each lane a lane of another row.
struct RowPlaces {
    hn::Vec<hn::RebindToUnsigned<Lanes>> part[part_count]; // NOLINT(modernize-avoid-c-arrays): as above
};

/// The places that four bits each hold: those that begin at bit `Shift`.
template<int Shift>
HWY_INLINE RowPlaces unpack_places(const std::array<std::uint16_t, row_size>& packed) {
    const hn::RebindToUnsigned<Lanes> unsigned_lanes;
    const hn::Rebind<std::uint16_t, Lanes> short_lanes;
    RowPlaces places;
    for (std::size_t p = 0; p < part_count; ++p) {
        const auto row = hn::PromoteTo(unsigned_lanes, hn::Load(short_lanes, packed.data() + p * part_size));
        places.part[p] = hn::And(hn::ShiftRight<Shift>(row), hn::Set(unsigned_lanes, 15U));
    }
    return places;
}

HWY_INLINE Row pick(const Row& row, const RowPlaces& places) {
#if HWY_TARGET == HWY_SCALAR
    alignas(64) std::array<float, row_size> from{};
    store(row, from);
    return each_part([&](std::size_t p) { return hn::Set(Lanes(), from[hn::GetLane(places.part[p])]); });
#else
    // From each of the row's vectors that lane which would be the one if it were there.
    const hn::RebindToUnsigned<Lanes> unsigned_lanes;
    const hn::RebindToSigned<Lanes> signed_lanes;
    return each_part([&](std::size_t p) HWY_ATTR {
        const auto place = places.part[p];
        const auto within =
            hn::IndicesFromVec(Lanes(), hn::And(place, hn::Set(unsigned_lanes, std::uint32_t{part_size - 1})));
        Vector picked = hn::TableLookupLanes(row.part[0], within);
        for (std::size_t q = 1; q < part_count; ++q) {
            const auto before = hn::Set(signed_lanes, static_cast<std::int32_t>(q * part_size) - 1);
            const auto there = hn::RebindMask(Lanes(), before < hn::BitCast(signed_lanes, place));
            picked = hn::IfThenElse(there, hn::TableLookupLanes(row.part[q], within), picked);
        }
        return picked;
    });
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
    return each_part([&](std::size_t p) HWY_ATTR { return level[p]; });
}
HWY_INLINE Row least_of_rows(const std::array<std::array<float, row_size>, row_size>& rows) {
    return reduce_rows(rows, [](Vector a, Vector b) HWY_ATTR { return hn::Min(a, b); });
}
HWY_INLINE Row greatest_of_rows(const std::array<std::array<float, row_size>, row_size>& rows) {
    return reduce_rows(rows, [](Vector a, Vector b) HWY_ATTR { return hn::Max(a, b); });
}
