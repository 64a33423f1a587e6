#include "trace/peak_directions.hpp"

#include <numbers>

#include "base/simd_targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/peak_directions.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace vkbake::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#include "trace/simd_rows.inl"

#include "trace/simd_elementary.inl"

HWY_INLINE Wholes whole(std::int32_t value) { return hn::Set(WholeLanes(), value); }

/// Entries of a table, one a lane, and their members.
template<typename Entry>
class Entries {
public:
    HWY_INLINE Entries(const Entry* table, Wholes number) : m_table(table), m_number(number) {}

    HWY_INLINE Vector operator()(const float& of_first) const { return gather(Lanes(), of_first); }
    HWY_INLINE Wholes operator()(const std::int32_t& of_first) const { return gather(WholeLanes(), of_first); }
    HWY_INLINE const Entry& first() const { return *m_table; }
    HWY_INLINE Wholes number() const { return m_number; }

private:
    template<class Tag, typename Member>
    HWY_INLINE hn::Vec<Tag> gather(Tag tag, const Member& of_first) const {
        const auto* const members = reinterpret_cast<const Member*>(m_table);
        const auto offset = static_cast<std::int32_t>(&of_first - members);
        return hn::GatherIndex(tag, members, m_number * whole(sizeof(Entry) / sizeof(Member)) + whole(offset));
    }

    const Entry* m_table;
    Wholes m_number;
};

template<typename Entry>
struct Choice {
    Entries<Entry> entries;
    Vector share; ///< of the way from the option's begin to its end
};

struct GuideLanes {
    Wholes first, shift;
};

/// What a number, odd multiple of 2⁻²⁴ in (−1, 1), chooses among the entries from `first` on.
template<typename Entry>
HWY_INLINE Choice<Entry> choose(const Entry* table, Wholes first, const std::int32_t* all_guides,
                                const GuideLanes& guides, Vector number) {
    const WholeLanes wholes;
    const Wholes steps = hn::ConvertTo(wholes, number * set(0x1p24F)) + whole(1 << 24); // exact, as all that follows
    const Wholes part = guides.first + hn::Shr(steps, guides.shift);
    Wholes low = first + hn::GatherIndex(wholes, all_guides, part);
    Wholes high = first + hn::GatherIndex(wholes, all_guides, part + whole(1));
    while (!hn::AllFalse(wholes, hn::Lt(low, high))) {
        const Wholes middle = hn::ShiftRight<1>(low + high);
        const Vector end = Entries<Entry>(table, middle)(table->option.end);
        const auto behind = hn::RebindMask(wholes, hn::Le(end, number));
        low = hn::IfThenElse(behind, middle + whole(1), low);
        high = hn::IfThenElse(behind, high, middle);
    }
    const Entries<Entry> entries(table, low);
    const Vector begin = entries(table->option.begin);
    return {entries, hn::Min((number - begin) / (entries(table->option.end) - begin), set(1.0F))};
}

/// How far from the middle of its tent, in texels, the share leads.
template<typename Entry>
HWY_INLINE Vector along_tent(const Choice<Entry>& choice, bool clips) {
    Vector share = choice.share;
    if (clips) {
        const SkyPeaks::Option& option = choice.entries.first().option;
        const Vector clipped = choice.entries(option.tent_low) + share * choice.entries(option.tent_mass);
        share = hn::Min(clipped, set(1.0F));
    }
    const Vector other = set(1.0F) - share;
    const Vector from_end = hn::Sqrt(set(2.0F) * hn::Min(share, other)) - set(1.0F);
    return hn::IfThenElse(hn::Lt(share, other), from_end, hn::Neg(from_end));
}

struct Placed {
    Vector3 direction;
    Vector solid_angle;
};

/// At so many texels from the centre.
HWY_INLINE Placed on_panorama(const SkyPeaks& peaks, const Entries<SkyPeaks::Row>& row,
                              const Entries<SkyPeaks::Peak>& peak, Vector across, Vector down) {
    constexpr auto pi = std::numbers::pi_v<float>;
    const Vector a_column = set(2.0F * pi / static_cast<float>(peaks.width()));
    const Vector a_row = set(pi / static_cast<float>(peaks.height()));
    const auto turned = [](Vector sine, Vector cosine, const SineCosineOf& by) HWY_ATTR {
        return SineCosineOf{sine * by.cosine + cosine * by.sine, cosine * by.cosine - sine * by.sine};
    };
    const SineCosineOf around =
        turned(peak(peak.first().sine), peak(peak.first().cosine), sine_cosine(across * a_column));
    const SineCosineOf polar = turned(row(row.first().sine), row(row.first().cosine), sine_cosine(down * a_row));
    return {{polar.sine * around.cosine, polar.cosine, polar.sine * around.sine}, polar.sine * (a_column * a_row)};
}

HWY_INLINE Placed on_cube(const SkyPeaks& peaks, const Entries<SkyPeaks::Row>& row, const Entries<SkyPeaks::Peak>& peak,
                          Vector across, Vector down) {
    const Vector texel = set(2.0F / static_cast<float>(peaks.width()));
    const Vector a = peak(peak.first().cosine) + across * texel;
    const Vector b = row(row.first().cosine) + down * texel;
    const Vector square = set(1.0F) + a * a + b * b;
    const Vector length = hn::Sqrt(square);
    const Entries<SkyPeaks::Face> face(peaks.faces().data(), row(row.first().image));
    const auto along = [&](const float& axis, const float& to_right, const float& to_below)
                           HWY_ATTR { return (face(axis) + a * face(to_right) + b * face(to_below)) / length; };
    const SkyPeaks::Face& first = face.first();
    return {{along(first.axis.x, first.across.x, first.down.x), along(first.axis.y, first.across.y, first.down.y),
             along(first.axis.z, first.across.z, first.down.z)},
            texel * texel / (square * length)};
}

void peak_directions(const SkyPeaks& peaks, RayBlock& block, PeakSamples& samples) {
    const GuideLanes guides_of_rows{whole(peaks.guides_of_rows().first), whole(peaks.guides_of_rows().shift)};
    for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
        for (std::size_t first = 0; first < RayBlock::lanes; first += hn::Lanes(Lanes())) {
            const Vector3 point = load(block.direction[stratum], first);
            const auto in_rows =
                choose(peaks.rows().data(), whole(0), peaks.row_guides().data(), guides_of_rows, point.y);
            const auto& row = in_rows.entries;
            const SkyPeaks::Guides& guides = row.first().guides;
            const auto in_row = choose(peaks.peaks().data(), row(row.first().first), peaks.peak_guides().data(),
                                       {row(guides.first), row(guides.shift)}, point.x);
            const auto& peak = in_row.entries;
            const Vector across = along_tent(in_row, peaks.clips());
            const Vector down = along_tent(in_rows, peaks.clips());
            const Placed placed =
                peaks.is_cube() ? on_cube(peaks, row, peak, across, down) : on_panorama(peaks, row, peak, across, down);
            store(placed.direction, block.direction[stratum], first);
            const auto& light = peak.first().light;
            store({peak(light[0]) * placed.solid_angle, peak(light[1]) * placed.solid_angle,
                   peak(light[2]) * placed.solid_angle},
                  samples.light[stratum], first);
            hn::Store(hn::BitCast(WordLanes(), peak.number()), WordLanes(), &samples.peak[stratum][first]);
        }
    }
}

} // namespace vkbake::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vkbake {

HWY_EXPORT(peak_directions);

void set_peak_directions(const SkyPeaks& peaks, RayBlock& block, PeakSamples& samples) {
    HWY_DYNAMIC_DISPATCH(peak_directions)(peaks, block, samples);
}

} // namespace vkbake
#endif
