#include "trace/sought_light.hpp"

namespace vkbake {

SoughtLight::SoughtLight(const TracedScene& scene, const RayPlan& plan, const EmitterSet* emitters, RaySpread spread)
    : m_horizon(spread == RaySpread::sphere ? Horizon::none : Horizon::surface) {
    if (scene.lamps != nullptr) {
        m_lamps.emplace(*scene.lamps, *scene.visibility);
        m_lamps->set_plan(plan);
    }
    if (scene.peaks != nullptr) {
        m_peaks.emplace(*scene.peaks, *scene.visibility);
        m_peaks->set_plan(plan);
    }
    if (emitters != nullptr) {
        m_emitters.emplace(*emitters, plan, spread, *scene.visibility);
    }
}

void SoughtLight::add(const TileLanes& lanes, LaneHarmonics& around, LaneHarmonics& sent) {
    if (m_peaks) {
        m_peaks->add_harmonics(lanes, m_horizon, sent);
    }
    if (m_lamps) {
        m_lamps->add_harmonics(lanes, m_horizon, sent);
    }
    if (m_emitters) {
        m_emitters->add_harmonics(lanes, around);
    }
}

std::uint64_t SoughtLight::rays() const {
    return (m_lamps ? m_lamps->rays() : 0) + (m_peaks ? m_peaks->rays() : 0) + (m_emitters ? m_emitters->rays() : 0);
}

} // namespace vkbake
