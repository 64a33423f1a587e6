// The light that lanes get along rays that seek where it comes from.
#pragma once

#include <cstdint>
#include <optional>

#include "trace/emitter_tracer.hpp"
#include "trace/lamp_tracer.hpp"
#include "trace/lane_harmonics.hpp"
#include "trace/peak_tracer.hpp"
#include "trace/tracer.hpp"

namespace vkbake {

/// Of evenly spread rays: what lamps and the sky's peaks send, and of emitters what by chance is found badly. For one
/// thread; allocates nothing after it is made.
class SoughtLight {
public:
    /// All must outlive it. `plan`: of sampler cosine. `emitters`: null where none are sought. `spread`: hemisphere, or
    /// sphere, where no surface hides what is below.
    SoughtLight(const TracedScene& scene, const RayPlan& plan, const EmitterSet* emitters, RaySpread spread);

    /// `around`: in the unit of the plan's rays. `sent`: that of lamps and peaks.
    void add(const TileLanes& lanes, LaneHarmonics& around, LaneHarmonics& sent);
    /// Null where none are sought.
    [[nodiscard]] const EmitterTracer* emitters() const { return m_emitters ? &*m_emitters : nullptr; }
    [[nodiscard]] std::uint64_t rays() const; ///< traced so far

private:
    Horizon m_horizon;
    std::optional<LampTracer> m_lamps;
    std::optional<PeakTracer> m_peaks;
    std::optional<EmitterTracer> m_emitters;
};

} // namespace vkbake
