// Look-ups of a SkyMap, a vector of directions at a time. Included after simd_rows.inl.

/// Of the texels that directions end in.
class MapIndices {
public:
    HWY_INLINE explicit MapIndices(const SkyMap& map)
        : m_half(0.5F * static_cast<float>(map.side()) * (1.0F - 0x1p-20F)),
          m_middle(0.5F * static_cast<float>(map.side()) - 0.5F), m_side(map.side()) {}

    HWY_INLINE Wholes of(const Vector3& direction) const {
        const Vector one = set(1.0F);
        const Vector scale = one / (hn::Abs(direction.x) + hn::Abs(direction.y) + hn::Abs(direction.z));
        const Vector u = direction.x * scale;
        const Vector v = direction.z * scale;
        const Vector x = hn::IfNegativeThenElse(direction.y, hn::CopySign(one - hn::Abs(v), u), u);
        const Vector y = hn::IfNegativeThenElse(direction.y, hn::CopySign(one - hn::Abs(u), v), v);
        return place(y) * hn::Set(WholeLanes(), m_side) + place(x);
    }

private:
    /// Of a coordinate in [−1, 1] the column or row. Half the side is short of itself by so little that 1 still falls
    /// into the last texel.
    HWY_INLINE Wholes place(Vector coordinate) const {
        // Added, this leaves the nearest whole number in the lowest bits; the thread rounds to nearest.
        const Vector whole = (coordinate * set(m_half) + set(m_middle)) + set(0x1.8p23F);
        return hn::And(hn::BitCast(WholeLanes(), whole), hn::Set(WholeLanes(), 0x3FFFFF));
    }

    float m_half;
    float m_middle;
    std::int32_t m_side;
};

class FloatMapRadiance {
public:
    static constexpr std::size_t channels = 3;

    HWY_INLINE explicit FloatMapRadiance(const SkyMap& map) : m_indices(map), m_floats(map.floats()) {}

    /// The index of a texel's first float, as bits.
    HWY_INLINE Vector3 place(const Vector3& direction) const {
        const Wholes index = m_indices.of(direction) * hn::Set(WholeLanes(), 3);
        return {hn::BitCast(Lanes(), index), set(0.0F), set(0.0F)};
    }

    HWY_INLINE void look_up(const Vector3& place, Mask asked, std::size_t first,
                            std::array<RayBlock::LaneRow, channels>& rows) const {
        const Wholes index = hn::BitCast(WholeLanes(), hn::IfThenElseZero(asked, place.x));
        for (std::size_t channel = 0; channel < channels; ++channel) {
            const Vector value = hn::GatherIndex(Lanes(), m_floats + channel, index);
            hn::Store(hn::IfThenElseZero(asked, value), Lanes(), &rows[channel][first]);
        }
    }

private:
    MapIndices m_indices;
    const float* m_floats;
};

/// The words of a packed map that the open rays end in, black ones for the others. All are found before any is used:
/// vectors that are put together from single words want time between the two.
class MapWords {
public:
    HWY_INLINE MapWords(const SkyMap& map, const SkyRays& rays) : m_least_exponent(map.least_exponent() << 23U) {
        const MapIndices indices(map);
        const Wholes nowhere = hn::Set(WholeLanes(), static_cast<std::int32_t>(map.nowhere()));
        for (std::size_t stratum = 0; stratum < rays.directions.size(); ++stratum) {
            for (std::size_t first = 0; first < RayBlock::lanes; first += hn::Lanes(Lanes())) {
                const auto open = hn::RebindMask(WholeLanes(), mask_at(first, rays.open[stratum]));
                const Wholes index = hn::IfThenElse(open, indices.of(load(rays.directions[stratum], first)), nowhere);
                hn::Store(hn::BitCast(WordLanes(), index), WordLanes(), &m_rows[stratum][first]);
            }
        }
        map.read({m_rows[0].data(), rays.directions.size() * RayBlock::lanes});
    }

    HWY_INLINE Vector3 radiance(std::size_t stratum, std::size_t first) const {
        const Words word = hn::Load(WordLanes(), &m_rows[stratum][first]);
        const Vector unit =
            hn::BitCast(Lanes(), hn::And(hn::ShiftRight<4>(word), set_word(0x0F800000U)) + set_word(m_least_exponent));
        const auto channel = [&](Words bits) HWY_ATTR {
            return hn::ConvertTo(Lanes(), hn::BitCast(WholeLanes(), hn::And(bits, set_word(511)))) * unit;
        };
        return {channel(word), channel(hn::ShiftRight<9>(word)), channel(hn::ShiftRight<18>(word))};
    }

private:
    alignas(64) std::array<std::array<std::uint32_t, RayBlock::lanes>, RayBlock::strata> m_rows;
    std::uint32_t m_least_exponent;
};
