#include "trace/sky_sum.hpp"

#include <cstdint>
#include <numbers>
#include <span>

#include "base/luminance.hpp"
#include "base/simd_targets.hpp"

#ifndef VKBAKE_TRACE_SKY_SUM
#define VKBAKE_TRACE_SKY_SUM // read once for each target; this is for all
namespace vkbake {

/// Some strata's rays.
struct SkyRays {
    std::span<const std::array<RayBlock::LaneRow, 3>> directions;
    std::span<const RayBlock::LaneBits> open;
    std::span<const double> weights;
    LuminanceRows* luminance = nullptr;
};

} // namespace vkbake
#endif

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/sky_sum.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace vkbake::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#include "trace/simd_rows.inl"

#include "trace/simd_elementary.inl"

#include "trace/sky_radiance.inl"

#include "trace/sky_map.inl"

/// Adds weight · value to one channel of all lanes.
HWY_INLINE void add_row(const RayBlock::LaneRow& row, double weight, std::array<double, RayBlock::lanes>& sums) {
    const hn::CappedTag<double, RayBlock::lanes> wide;
    const hn::Rebind<float, decltype(wide)> narrow;
    const auto factor = hn::Set(wide, weight);
    for (std::size_t first = 0; first < RayBlock::lanes; first += hn::Lanes(wide)) {
        const auto value = hn::PromoteTo(wide, hn::Load(narrow, &row[first]));
        hn::Store(hn::Load(wide, &sums[first]) + factor * value, wide, &sums[first]);
    }
}

HWY_INLINE Vector luminance_of(const Vector3& value) {
    return value.x * set(static_cast<float>(luminance_weights.x)) +
           value.y * set(static_cast<float>(luminance_weights.y)) +
           value.z * set(static_cast<float>(luminance_weights.z));
}

template<std::size_t channels>
HWY_INLINE void set_luminance(const std::array<RayBlock::LaneRow, channels>& rows, RayBlock::LaneRow& luminance) {
    for (std::size_t first = 0; first < RayBlock::lanes; first += hn::Lanes(Lanes())) {
        Vector value = load(rows[0], first);
        if constexpr (channels == 3) {
            value = luminance_of(load(rows, first));
        }
        hn::Store(value, Lanes(), &luminance[first]);
    }
}

template<class Radiance>
HWY_INLINE void add(const Radiance& radiance, const SkyRays& rays, LaneSums& sums) {
    // Two short loops: in one long one each look-up's chain of operations would hide behind too few others.
    // What is read of it was written. NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
    alignas(64) std::array<std::array<RayBlock::LaneRow, 3>, RayBlock::strata> places;
    const std::size_t strata = rays.directions.size();
    for (std::size_t stratum = 0; stratum < strata; ++stratum) {
        for (std::size_t first = 0; rays.open[stratum] != 0 && first < RayBlock::lanes; first += hn::Lanes(Lanes())) {
            store(radiance.place(load(rays.directions[stratum], first)), places[stratum], first);
        }
    }
    alignas(64) std::array<RayBlock::LaneRow, Radiance::channels> rows{};
    for (std::size_t stratum = 0; stratum < strata; ++stratum) {
        if (rays.open[stratum] == 0) {
            continue;
        }
        for (std::size_t first = 0; first < RayBlock::lanes; first += hn::Lanes(Lanes())) {
            radiance.look_up(load(places[stratum], first), mask_at(first, rays.open[stratum]), first, rows);
        }
        if (rays.luminance != nullptr) {
            set_luminance(rows, (*rays.luminance)[stratum]);
        }
        for (std::size_t channel = 0; channel < Radiance::channels; ++channel) {
            add_row(rows[channel], rays.weights[stratum], sums.channels[channel]);
        }
    }
}

/// Each ray's own, in three channels.
template<class Radiance>
HWY_INLINE void write(const Radiance& radiance, const SkyRays& rays, RadianceRows& out) {
    alignas(64) std::array<RayBlock::LaneRow, Radiance::channels> rows{};
    for (std::size_t stratum = 0; stratum < rays.directions.size(); ++stratum) {
        for (std::size_t first = 0; first < RayBlock::lanes; first += hn::Lanes(Lanes())) {
            radiance.look_up(radiance.place(load(rays.directions[stratum], first)), mask_at(first, rays.open[stratum]),
                             first, rows);
        }
        for (std::size_t channel = 0; channel < 3; ++channel) {
            out[stratum][channel] = rows[channel % Radiance::channels];
        }
    }
}

void write_clear(const ClearSkyLookup& sky, const SkyRays& rays, RadianceRows& out) {
    write(ClearRadiance(sky), rays, out);
}

void write_equirectangular(const EquirectangularLookup& sky, const SkyRays& rays, RadianceRows& out) {
    write(EquirectangularRadiance(sky), rays, out);
}

void write_cube(const CubeLookup& sky, const SkyRays& rays, RadianceRows& out) { write(CubeRadiance(sky), rays, out); }

/// Without rows between: what lanes bring is summed in floats over strata of one weight, which 16 texels of 9 bits
/// hardly ever need to be rounded for.
HWY_INLINE void add_words(const MapWords& words, const SkyRays& rays, LaneSums& sums) {
    const std::size_t strata = rays.directions.size();
    alignas(64) std::array<RayBlock::LaneRow, 3> rows{};
    for (std::size_t begin = 0, end = 0; begin < strata; begin = end) {
        for (end = begin + 1; end < strata && rays.weights[end] == rays.weights[begin];) {
            ++end;
        }
        for (std::size_t first = 0; first < RayBlock::lanes; first += hn::Lanes(Lanes())) {
            Vector3 sum{set(0.0F), set(0.0F), set(0.0F)};
            for (std::size_t stratum = begin; stratum < end; ++stratum) {
                const Vector3 value = words.radiance(stratum, first);
                sum = {sum.x + value.x, sum.y + value.y, sum.z + value.z};
                if (rays.luminance != nullptr) {
                    hn::Store(luminance_of(value), Lanes(), &(*rays.luminance)[stratum][first]);
                }
            }
            store(sum, rows, first);
        }
        for (std::size_t channel = 0; channel < 3; ++channel) {
            add_row(rows[channel], rays.weights[begin], sums.channels[channel]);
        }
    }
}

HWY_INLINE void write_words(const MapWords& words, const SkyRays& rays, RadianceRows& out) {
    for (std::size_t stratum = 0; stratum < rays.directions.size(); ++stratum) {
        for (std::size_t first = 0; first < RayBlock::lanes; first += hn::Lanes(Lanes())) {
            store(words.radiance(stratum, first), out[stratum], first);
        }
    }
}

void add_map(const MapLookup& sky, const SkyRays& rays, LaneSums& sums) {
    sky.map.is_packed() ? add_words(MapWords(sky.map, rays), rays, sums) : add(FloatMapRadiance(sky.map), rays, sums);
}

void write_map(const MapLookup& sky, const SkyRays& rays, RadianceRows& out) {
    sky.map.is_packed() ? write_words(MapWords(sky.map, rays), rays, out) : write(FloatMapRadiance(sky.map), rays, out);
}

void add_constant(const SkyRays& rays, LaneSums& sums) { add(UnitRadiance(), rays, sums); }

void add_clear(const ClearSkyLookup& sky, const SkyRays& rays, LaneSums& sums) { add(ClearRadiance(sky), rays, sums); }

void add_equirectangular(const EquirectangularLookup& sky, const SkyRays& rays, LaneSums& sums) {
    add(EquirectangularRadiance(sky), rays, sums);
}

void add_cube(const CubeLookup& sky, const SkyRays& rays, LaneSums& sums) { add(CubeRadiance(sky), rays, sums); }

} // namespace vkbake::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vkbake {

HWY_EXPORT(add_constant);
HWY_EXPORT(add_clear);
HWY_EXPORT(add_equirectangular);
HWY_EXPORT(add_cube);
HWY_EXPORT(write_clear);
HWY_EXPORT(write_equirectangular);
HWY_EXPORT(write_cube);
HWY_EXPORT(add_map);
HWY_EXPORT(write_map);

namespace {

struct Write {
    SkyRays rays;
    RadianceRows& out;

    void operator()(const ConstantLookup& sky) const {
        for (std::size_t stratum = 0; stratum < out.size(); ++stratum) {
            for (std::size_t lane = 0; lane < RayBlock::lanes; ++lane) {
                const bool open = (rays.open[stratum] >> lane & 1U) != 0;
                for (std::size_t channel = 0; channel < 3; ++channel) {
                    out[stratum][channel][lane] = open ? sky.radiance[static_cast<glm::length_t>(channel)] : 0.0F;
                }
            }
        }
    }
    void operator()(const ClearSkyLookup& sky) const { HWY_DYNAMIC_DISPATCH(write_clear)(sky, rays, out); }
    void operator()(const EquirectangularLookup& sky) const {
        HWY_DYNAMIC_DISPATCH(write_equirectangular)(sky, rays, out);
    }
    void operator()(const CubeLookup& sky) const { HWY_DYNAMIC_DISPATCH(write_cube)(sky, rays, out); }
    void operator()(const MapLookup& sky) const { HWY_DYNAMIC_DISPATCH(write_map)(sky, rays, out); }
};

struct Add {
    SkyRays rays;
    LaneSums& sums;

    void operator()(const ConstantLookup& /*sky*/) const { HWY_DYNAMIC_DISPATCH(add_constant)(rays, sums); }
    void operator()(const ClearSkyLookup& sky) const { HWY_DYNAMIC_DISPATCH(add_clear)(sky, rays, sums); }
    void operator()(const EquirectangularLookup& sky) const {
        HWY_DYNAMIC_DISPATCH(add_equirectangular)(sky, rays, sums);
    }
    void operator()(const CubeLookup& sky) const { HWY_DYNAMIC_DISPATCH(add_cube)(sky, rays, sums); }
    void operator()(const MapLookup& sky) const { HWY_DYNAMIC_DISPATCH(add_map)(sky, rays, sums); }
};

} // namespace

void add_sky(const SkyLookup& sky, const RayBlock& block, const BlockedRays& open,
             const std::array<double, RayBlock::strata>& weights, LaneSums& sums, LuminanceRows* luminance) {
    std::visit(Add{{block.direction, open, weights, luminance}, sums}, sky);
}

void look_up_sky(const SkyLookup& sky, const RayBlock& block, const BlockedRays& open, RadianceRows& radiance) {
    std::visit(Write{{block.direction, open, {}}, radiance}, sky);
}

double luminance_scale(const SkyLookup& sky) {
    const auto* constant = std::get_if<ConstantLookup>(&sky);
    return constant != nullptr ? luminance(glm::dvec3(constant->radiance)) : 1.0;
}

glm::vec3 radiance(const SkyLookup& sky, const glm::vec3& direction) {
    alignas(64) std::array<RayBlock::LaneRow, 3> row{};
    row[0][0] = direction.x;
    row[1][0] = direction.y;
    row[2][0] = direction.z;
    const RayBlock::LaneBits first = 1;
    const double weight = 1.0;
    LaneSums sums;
    std::visit(Add{{{&row, 1}, {&first, 1}, {&weight, 1}}, sums}, sky);
    return glm::vec3(total(sky, sums, 0));
}

glm::dvec3 total(const SkyLookup& sky, const LaneSums& sums, std::size_t lane) {
    const double first = sums.channels[0][lane];
    if (const auto* constant = std::get_if<ConstantLookup>(&sky)) {
        return first * glm::dvec3(constant->radiance);
    }
    if (std::holds_alternative<ClearSkyLookup>(sky)) {
        return glm::dvec3(first);
    }
    return {first, sums.channels[1][lane], sums.channels[2][lane]};
}

} // namespace vkbake
#endif
