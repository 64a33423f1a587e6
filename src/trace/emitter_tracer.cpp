#include "trace/emitter_tracer.hpp"

#include <bit>
#include <cmath>
#include <numbers>
#include <optional>
#include <variant>

#include <glm/geometric.hpp>

#include "base/luminance.hpp"

namespace vkbake {

namespace {

/// So much before an emitter its rays end, bake frame, so that it does not hide itself.
constexpr double emitter_gap = 0x1p-18;

glm::dvec3 at_lane(const TileLanes::Rows& rows, std::size_t lane) {
    return {static_cast<double>(rows[0][lane]), static_cast<double>(rows[1][lane]), static_cast<double>(rows[2][lane])};
}

/// Over solid angle, where rays go at all.
double density_by_chance(RaySpread spread, double cosine) {
    switch (spread) {
    case RaySpread::cosine:
        return cosine / std::numbers::pi;
    case RaySpread::hemisphere:
        return 0.5 / std::numbers::pi;
    case RaySpread::sphere:
        break;
    }
    return 0.25 / std::numbers::pi;
}

/// Densities over solid angle.
struct Densities {
    double by_chance;
    double by_choice;

    /// `density`: of the choice, over area, seen from a distance² at a cosine.
    Densities(double chance, double density, double square, double cosine_sent)
        : by_chance(chance), by_choice(density * square / cosine_sent) {}

    [[nodiscard]] double squares() const { return by_chance * by_chance + by_choice * by_choice; }
    [[nodiscard]] double weight_by_chance() const { return by_chance * by_chance / squares(); }
    /// Times the radiance, in the unit of the rays by chance.
    [[nodiscard]] double share_by_choice() const { return by_chance * by_choice / squares(); }
};

} // namespace

EmitterTracer::EmitterTracer(const EmitterSet& emitters, const RayPlan& plan, RaySpread spread,
                             const Visibility& visibility)
    : m_emitters(&emitters), m_spread(spread), m_plan(&plan), m_strata(&std::get<CosineStrata>(plan.directions())),
      m_visibility(&visibility), m_scratch(visibility.make_scratch()) {
    m_block.max_distance = 1.0F; // directions are as long as the way to the emitter
}

void EmitterTracer::set_plan(const RayPlan& plan) {
    m_plan = &plan;
    m_strata = &std::get<CosineStrata>(plan.directions());
}

// Evenly spread rays count what comes from low as much as what comes from high: so should the choice.
Receiver EmitterTracer::receiver_of(const TileLanes& lanes, std::size_t lane) const {
    return {at_lane(lanes.origin, lane), m_spread == RaySpread::cosine ? at_lane(lanes.normal, lane) : glm::dvec3(0.0)};
}

void EmitterTracer::add(const TileLanes& lanes, std::array<glm::dvec3, RayBlock::lanes>& sums, LaneParts* parts) {
    const unsigned shift = parts != nullptr ? part_shift(m_plan->samples()) : 0;
    trace(lanes, [&](std::size_t stratum, std::size_t lane, const glm::dvec3& light) {
        sums[lane] += light;
        if (parts != nullptr) {
            parts->add(lane, m_indices.of[stratum][lane], shift, luminance(light));
            parts->of_lights[lane] += luminance(light);
        }
    });
}

void EmitterTracer::add_harmonics(const TileLanes& lanes, LaneHarmonics& sums) {
    trace(lanes, [&](std::size_t stratum, std::size_t lane, const glm::dvec3& light) {
        const auto& [x, y, z] = m_block.direction[stratum];
        sums.add(lane, glm::normalize(glm::vec3(x[lane], y[lane], z[lane])), light);
    });
}

template<class Arrive>
void EmitterTracer::trace(const TileLanes& lanes, const Arrive& arrive) {
    constexpr std::uint64_t of_emitters = 0x656D6974;
    m_block.origin = lanes.origin;
    m_block.ignored_triangle = lanes.triangle;
    for (std::size_t lane = 0; lane < m_receivers.size(); ++lane) {
        m_receivers[lane] = receiver_of(lanes, lane);
    }
    m_own_lanes.scrambles = lanes.scrambles.salted(of_emitters);
    m_own_lanes.covered = lanes.covered;
    invert_scrambles(*m_strata, m_own_lanes, m_tables);
    for (std::size_t number = 0; number < m_strata->block_count(); ++number) {
        set_points(*m_strata, m_tables, m_own_lanes, number, m_block, &m_indices);
        aim(lanes);
        const BlockedRays blocked = m_visibility->blocked(m_block, m_scratch);
        for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
            m_ray_count += static_cast<std::uint64_t>(std::popcount(m_block.active[stratum]));
            for (unsigned left = m_block.active[stratum] & ~static_cast<unsigned>(blocked[stratum]); left != 0;
                 left &= left - 1) {
                const auto lane = static_cast<std::size_t>(std::countr_zero(left));
                arrive(stratum, lane, glm::dvec3(m_scratch.transmittance(stratum, lane)) * m_light[stratum][lane]);
            }
        }
    }
}

void EmitterTracer::aim(const TileLanes& lanes) {
    for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
        auto& [x, y, z] = m_block.direction[stratum];
        unsigned active = 0;
        for (unsigned left = m_block.active[stratum]; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            const Receiver& receiver = m_receivers[lane];
            const std::optional<EmitterSet::Sample> sample = m_emitters->sample(
                receiver, 0.5 + 0.5 * static_cast<double>(x[lane]), 0.5 + 0.5 * static_cast<double>(y[lane]));
            if (!sample) {
                continue;
            }
            const glm::dvec3 way = sample->point - receiver.place;
            const double square = glm::dot(way, way);
            const double distance = std::sqrt(square);
            const double cosine = glm::dot(at_lane(lanes.normal, lane), way) / distance;
            const double sent = -glm::dot(sample->normal, way) / distance;
            const double cosine_sent = sample->two_sided ? std::abs(sent) : sent;
            const bool above = m_spread == RaySpread::sphere ||
                               (cosine > 0.0 && glm::dot(at_lane(lanes.geometric_normal, lane), way) > 0.0);
            if (!(distance > emitter_gap && cosine_sent > 0.0 && above)) {
                continue;
            }
            active |= 1U << lane;
            const Densities densities(density_by_chance(m_spread, cosine), sample->density, square, cosine_sent);
            m_light[stratum][lane] = densities.share_by_choice() * glm::dvec3(sample->radiance);
            const glm::vec3 ray(way * (1.0 - emitter_gap / distance));
            x[lane] = ray.x;
            y[lane] = ray.y;
            z[lane] = ray.z;
        }
        m_block.active[stratum] = static_cast<RayBlock::LaneBits>(active);
    }
}

ArrivingLight EmitterTracer::arriving(const SurfaceLight& light, const TileLanes& lanes, std::size_t lane,
                                      const Ray& ray, const Hit& hit) const {
    const glm::vec3 all = light.along(ray, hit);
    const glm::vec3 sought = light.sought_along(ray, hit);
    if (sought == glm::vec3(0.0F)) {
        return {.all = all};
    }
    const double density = m_emitters->density(receiver_of(lanes, lane), hit.triangle);
    if (density == 0.0) {
        return {.all = all};
    }
    const glm::dvec3 direction(ray.direction);
    const auto distance = static_cast<double>(hit.distance);
    const double chance = density_by_chance(m_spread, glm::dot(at_lane(lanes.normal, lane), direction));
    const double sent = std::abs(glm::dot(m_emitters->normal(hit.triangle), direction));
    const double left = sent > 0.0 ? Densities(chance, density, distance * distance, sent).weight_by_chance() : 0.0;
    const glm::vec3 left_over = static_cast<float>(left) * sought;
    return {.all = (all - sought) + left_over, .sought = left_over};
}

} // namespace vkbake
