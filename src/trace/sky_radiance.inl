// The radiance of each kind of sky, a vector of directions at a time. Included after simd_elementary.inl.
//
// Each finds the *place* of a direction, three numbers of its own choice, and looks up what is there: it is given the
// mask of the directions that are asked for, and where in the rows to write to; it writes 0 for the others.

/// What only counts the rays that arrive; the sum is multiplied once.
struct UnitRadiance {
    static constexpr std::size_t channels = 1;

    HWY_INLINE Vector3 place(const Vector3& direction) const { return direction; }
    HWY_INLINE void look_up(const Vector3& /*place*/, Mask asked, std::size_t first,
                            std::array<RayBlock::LaneRow, channels>& rows) const {
        hn::Store(hn::IfThenElseZero(asked, set(1.0F)), Lanes(), &rows[0][first]);
    }
};

HWY_INLINE Vector3 into_sky(const SkyTurn& turn, const Vector3& direction) {
    return {direction.x * set(turn.cosine) - direction.z * set(turn.sine), direction.y,
            direction.x * set(turn.sine) + direction.z * set(turn.cosine)};
}

/// ISO 15469, type 12 (gradation group 5, indicatrix group 4): L / Lz = f(χ) φ(Z) / (f(45°) φ(0)) with φ = 1 −
/// e^(−0.32 / cos Z), f = 1 + 10 (e^(−3 χ) − e^(−3 π / 2)) + 0.45 cos² χ, χ from the sun at 45° towards +X.
class ClearRadiance {
public:
    static constexpr std::size_t channels = 1;

    HWY_INLINE explicit ClearRadiance(const ClearSkyLookup& sky) : m_turn(&sky.turn) {}

    /// φ(Z), or 0 below the horizon; cos χ; χ.
    HWY_INLINE Vector3 place(const Vector3& direction) const {
        const Vector3 turned = into_sky(*m_turn, direction);
        // Below 1/100 the exponential, e⁻³² there, is lost beside 1: no division by a zero at the horizon.
        const Vector gradation = set(1.0F) - exponential(set(-0.32F) / hn::Max(turned.y, set(0.01F)));
        const Vector half = set(static_cast<float>(1.0 / std::numbers::sqrt2));
        const Vector along = (turned.x + turned.y) * half;
        const Vector across = (turned.y - turned.x) * half;
        const Vector sun_distance = arc_tangent(hn::Sqrt(across * across + turned.z * turned.z), along);
        return {hn::IfThenElseZero(hn::Ge(turned.y, set(0.0F)), gradation), along, sun_distance};
    }

    HWY_INLINE void look_up(const Vector3& place, Mask asked, std::size_t first,
                            std::array<RayBlock::LaneRow, channels>& rows) const {
        const Vector indicatrix = set(static_cast<float>(1.0 - 10.0 * 0.0089832910211294273)) +
                                  set(10.0F) * exponential(set(-3.0F) * place.z) + set(0.45F) * (place.y * place.y);
        // The zenith's, 1 / (f(45°) φ(0)), is the unit.
        const Vector value = place.x * indicatrix * set(1.7530845026F);
        hn::Store(hn::IfThenElseZero(asked, value), Lanes(), &rows[0][first]);
    }

private:
    const SkyTurn* m_turn; ///< never null
};

/// Bilinear look-ups between texel centres. A texel whose weight is 0 does not count, so that a value that is no number
/// stays in its place.
class Picture {
public:
    static constexpr std::size_t channels = 3;

    HWY_INLINE explicit Picture(const BorderedImages& images)
        : m_images(&images), m_row(static_cast<std::int32_t>(images.floats_a_row())),
          m_image(static_cast<std::int32_t>(images.floats_an_image())) {}

    /// Of a place x and y, where (0, 0) is the centre of the upper left texel, and the number of the image as z. What
    /// lies outside by more than half a texel is brought back.
    HWY_INLINE void look_up(const Vector3& place, Mask asked, std::size_t first,
                            std::array<RayBlock::LaneRow, channels>& rows) const {
        const Cell column = cell(place.x, m_images->width(), asked);
        const Cell row = cell(place.y, m_images->height(), asked);
        const Wholes number = hn::ConvertTo(WholeLanes(), hn::IfThenElseZero(asked, place.z));
        const Wholes left = column.before * whole(3);
        const Wholes above = number * whole(m_image) + row.before * whole(m_row);
        const Wholes below = above + whole(m_row);
        const Vector3 upper = blend(texel(above + left), texel(above + left + whole(3)), column.share);
        const Vector3 lower = blend(texel(below + left), texel(below + left + whole(3)), column.share);
        const Vector3 value = blend(upper, lower, row.share);
        hn::Store(hn::IfThenElseZero(asked, value.x), Lanes(), &rows[0][first]);
        hn::Store(hn::IfThenElseZero(asked, value.y), Lanes(), &rows[1][first]);
        hn::Store(hn::IfThenElseZero(asked, value.z), Lanes(), &rows[2][first]);
    }

private:
    /// The cell between texel centres that holds a coordinate: the texel before it, counted from the ring's, and where
    /// between this and the next one it lies.
    struct Cell {
        Wholes before;
        Vector share; ///< 0 … 1
    };

    HWY_INLINE Cell cell(Vector coordinate, int size, Mask asked) const {
        const Vector inside =
            hn::Min(hn::Max(coordinate, set(-0.5F)), set(static_cast<float>(size) - 0.5F)) + set(1.0F);
        const Wholes before = hn::ConvertTo(WholeLanes(), hn::IfThenElseZero(asked, inside)); // floor of what is ≥ 0.5
        return {before, inside - hn::ConvertTo(Lanes(), before)};
    }

    static HWY_INLINE Wholes whole(std::int32_t value) { return hn::Set(WholeLanes(), value); }

    /// Of the index of its first channel.
    HWY_INLINE Vector3 texel(Wholes index) const {
        const auto channel = [&](std::int32_t number) HWY_ATTR {
            return hn::GatherIndex(Lanes(), m_images->floats(), index + whole(number));
        };
        return {channel(0), channel(1), channel(2)};
    }

    /// In this form a picture of one value gives that value to the bit.
    static HWY_INLINE Vector blend(Vector first, Vector second, Vector share) {
        return hn::IfThenElse(hn::Eq(share, hn::Zero(Lanes())), first, first + (second - first) * share);
    }
    static HWY_INLINE Vector3 blend(const Vector3& first, const Vector3& second, Vector share) {
        return {blend(first.x, second.x, share), blend(first.y, second.y, share), blend(first.z, second.z, share)};
    }

    const BorderedImages* m_images; ///< never null
    std::int32_t m_row;
    std::int32_t m_image;
};

class EquirectangularRadiance {
public:
    static constexpr std::size_t channels = Picture::channels;

    HWY_INLINE explicit EquirectangularRadiance(const EquirectangularLookup& sky)
        : m_turn(&sky.turn), m_picture(sky.image), m_width(static_cast<float>(sky.image.width())),
          m_height(static_cast<float>(sky.image.height())) {}

    HWY_INLINE Vector3 place(const Vector3& direction) const {
        const Vector3 turned = into_sky(*m_turn, direction);
        const Vector around = arc_tangent(turned.z, turned.x) * set(static_cast<float>(0.5 / std::numbers::pi));
        // acos(y) loses its digits near the poles; the angle between +Y and the direction does not.
        const Vector down = arc_tangent(hn::Sqrt(turned.x * turned.x + turned.z * turned.z), turned.y) *
                            set(static_cast<float>(1.0 / std::numbers::pi));
        return {around * set(m_width) + set(0.5F * m_width - 0.5F), down * set(m_height) - set(0.5F), set(0.0F)};
    }

    HWY_INLINE void look_up(const Vector3& place, Mask asked, std::size_t first,
                            std::array<RayBlock::LaneRow, channels>& rows) const {
        m_picture.look_up(place, asked, first, rows);
    }

private:
    const SkyTurn* m_turn; ///< never null
    Picture m_picture;
    float m_width, m_height;
};

/// As cube_point() of trace/sky_lookup.hpp.
class CubeRadiance {
public:
    static constexpr std::size_t channels = Picture::channels;

    HWY_INLINE explicit CubeRadiance(const CubeLookup& sky)
        : m_turn(&sky.turn), m_picture(sky.faces), m_half(0.5F * static_cast<float>(sky.faces.width())) {}

    HWY_INLINE Vector3 place(const Vector3& direction) const {
        const Vector3 turned = into_sky(*m_turn, direction);
        const Vector zero = set(0.0F);
        const Vector width = hn::Abs(turned.x);
        const Vector height = hn::Abs(turned.y);
        const Vector depth = hn::Abs(turned.z);
        const Mask along_z = hn::And(hn::Ge(depth, width), hn::Ge(depth, height));
        const Mask along_y = hn::Ge(height, width); // unless along z
        const auto chosen = [&](Vector x, Vector y, Vector z)
                                HWY_ATTR { return hn::IfThenElse(along_z, z, hn::IfThenElse(along_y, y, x)); };
        const auto signed_by = [&](Vector value, Vector sign)
                                   HWY_ATTR { return hn::IfThenElse(hn::Lt(sign, zero), hn::Neg(value), value); };
        const Vector major = chosen(turned.x, turned.y, turned.z);
        const Vector face = chosen(zero, set(2.0F), set(4.0F)) + hn::IfThenElseZero(hn::Lt(major, zero), set(1.0F));
        const Vector s = chosen(signed_by(hn::Neg(turned.z), turned.x), turned.x, signed_by(turned.x, turned.z));
        const Vector t = chosen(hn::Neg(turned.y), signed_by(turned.z, turned.y), hn::Neg(turned.y));
        const Vector length = hn::Abs(major);
        const Vector middle = set(m_half - 0.5F);
        return {s / length * set(m_half) + middle, t / length * set(m_half) + middle, face};
    }

    HWY_INLINE void look_up(const Vector3& place, Mask asked, std::size_t first,
                            std::array<RayBlock::LaneRow, channels>& rows) const {
        m_picture.look_up(place, asked, first, rows);
    }

private:
    const SkyTurn* m_turn; ///< never null
    Picture m_picture;
    float m_half; ///< a face's
};
