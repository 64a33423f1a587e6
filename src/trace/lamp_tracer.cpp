#include "trace/lamp_tracer.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <variant>

#include <glm/geometric.hpp>

#include "base/luminance.hpp"
#include "base/sampling.hpp"

namespace vkbake {

namespace {

/// Longer than the bake frame is wide: from there on nothing can be in the way.
constexpr double beyond_the_scene = 4.0;
/// So much before a lamp its rays end, bake frame: four times the offset of origins. In a scene of 16 m, 31 µm.
constexpr double lamp_gap = 0x1p-18;

/// What is farther is seen alike, and squares stay finite.
constexpr double far_enough = 0x1p60;

using LaneRows = std::array<RayBlock::LaneRow, 3>;

glm::vec3 vector_of(const LaneRows& rows, std::size_t lane) { return {rows[0][lane], rows[1][lane], rows[2][lane]}; }

void put_vector(LaneRows& rows, std::size_t lane, const glm::vec3& value) {
    rows[0][lane] = value.x;
    rows[1][lane] = value.y;
    rows[2][lane] = value.z;
}

/// Where a lane sees a lamp's centre.
struct Sight {
    glm::dvec3 direction{0.0}; ///< unit
    double distance = 0.0;
    double strength = 0.0; ///< ReadyLamp::light times this arrives at a surface that faces it
};

Sight sight_of(const ReadyLamp& lamp, const glm::dvec3& origin) {
    if (lamp.kind == LampKind::directional) {
        return {lamp.axis, beyond_the_scene, 1.0};
    }
    const glm::dvec3 way = lamp.place - origin;
    const double distance = glm::length(way);
    if (!(distance > 0.0)) {
        return {};
    }
    const glm::dvec3 direction = way / distance;
    const double near = std::max({distance, lamp.size, least_lamp_distance});
    return {direction, distance, attenuation(lamp, distance, -direction) / (near * near)};
}

TileLanes upright_lanes() {
    TileLanes lanes;
    lanes.tangent[0].fill(1.0F);
    lanes.bitangent[1].fill(1.0F);
    lanes.normal[2].fill(1.0F);
    lanes.geometric_normal[2].fill(1.0F);
    return lanes;
}

} // namespace

LampTracer::LampTracer(const LampSet& lamps, const Visibility& visibility)
    : m_lamps(&lamps), m_visibility(&visibility), m_scratch(visibility.make_scratch()), m_points_lanes(upright_lanes()),
      m_discs(lamps.soft.size()), m_reached(lamps.count, 0) {
    m_block.max_distance = 1.0F; // directions are as long as the way to the lamp
}

void LampTracer::set_plan(const RayPlan& plan) {
    m_plan = &plan;
    m_strata = std::get_if<CosineStrata>(&plan.directions());
    if (m_strata == nullptr) {
        m_own_strata.emplace(plan.samples());
        m_strata = &*m_own_strata;
    }
}

void LampTracer::sum_up(const TileLanes& lanes, LaneParts* parts) {
    m_sums.fill(glm::dvec3(0.0));
    trace(lanes, parts);
    // Sums of a plan that does not take the plain mean are scaled otherwise.
    const double unit = 1.0 / (m_plan->scale() * m_plan->samples());
    for (std::size_t lane = 0; lane < m_sums.size(); ++lane) {
        m_sums[lane] *= unit;
        if (parts != nullptr) {
            parts->of_lights[lane] += luminance(m_sums[lane]);
        }
    }
}

void LampTracer::add_harmonics(const TileLanes& lanes, Horizon horizon, LaneHarmonics& harmonics) {
    m_horizon = horizon;
    m_harmonics = &harmonics;
    trace(lanes, nullptr);
    m_horizon = Horizon::surface;
    m_harmonics = nullptr;
}

void LampTracer::trace(const TileLanes& lanes, LaneParts* parts) {
    m_block.origin = lanes.origin;
    m_block.ignored_triangle = lanes.triangle;
    trace_hard(lanes);
    if (!m_lamps->soft.empty()) {
        constexpr std::uint64_t of_lamps = 0x6C616D70; // scrambles that the sky's samples do not have
        m_points_lanes.scrambles = lanes.scrambles.salted(of_lamps);
        m_points_lanes.covered = lanes.covered;
        invert_scrambles(*m_strata, m_points_lanes, m_tables);
        for (std::size_t lamp = 0; lamp < m_discs.size(); ++lamp) {
            see(m_lamps->soft[lamp], lanes, m_discs[lamp]);
        }
        for (std::size_t number = 0; number < m_strata->block_count(); ++number) {
            (void)set_directions(*m_strata, m_tables, m_points_lanes, m_strata->block(number), m_points, &m_indices);
            for (std::size_t lamp = 0; lamp < m_discs.size(); ++lamp) {
                if (m_discs[lamp].lit != 0) {
                    aim(m_lamps->soft[lamp], m_discs[lamp]);
                    trace_soft(m_lamps->soft[lamp], m_discs[lamp], parts);
                }
            }
        }
    }
}

void LampTracer::trace_hard(const TileLanes& lanes) {
    for (std::size_t first = 0; first < m_lamps->hard.size(); first += RayBlock::strata) {
        trace_hard(lanes, first, std::min(RayBlock::strata, m_lamps->hard.size() - first));
    }
}

void LampTracer::trace_hard(const TileLanes& lanes, std::size_t first, std::size_t count) {
    const auto samples = static_cast<double>(m_plan->samples() - m_plan->first());
    std::array<std::array<double, RayBlock::lanes>, RayBlock::strata> strength{};
    m_block.active = {};
    for (std::size_t i = 0; i < count; ++i) {
        const ReadyLamp& lamp = m_lamps->hard[first + i];
        for (unsigned left = lanes.covered; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            const Sight sight = sight_of(lamp, glm::dvec3(vector_of(lanes.origin, lane)));
            const double cosine = glm::dot(glm::dvec3(vector_of(lanes.normal, lane)), sight.direction);
            const double above = glm::dot(glm::dvec3(vector_of(lanes.geometric_normal, lane)), sight.direction);
            strength[i][lane] = samples * sight.strength * (m_harmonics != nullptr ? 1.0 : cosine);
            const double way = std::min(sight.distance, beyond_the_scene) - lamp_gap;
            const bool faces = m_horizon == Horizon::none || (cosine > 0.0 && above > 0.0);
            if (faces && sight.strength > 0.0 && way > 0.0) {
                m_block.active[i] = static_cast<RayBlock::LaneBits>(m_block.active[i] | (1U << lane));
                put_vector(m_block.direction[i], lane, glm::vec3(sight.direction * way));
            }
        }
        m_ray_count += static_cast<std::uint64_t>(std::popcount(m_block.active[i]));
    }
    const BlockedRays blocked = m_visibility->blocked(m_block, m_scratch);
    for (std::size_t i = 0; i < count; ++i) {
        const ReadyLamp& lamp = m_lamps->hard[first + i];
        const unsigned open = m_block.active[i] & ~static_cast<unsigned>(blocked[i]);
        m_reached[lamp.number] += static_cast<std::uint64_t>(std::popcount(open));
        for (unsigned left = open; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            const glm::dvec3 light = strength[i][lane] * (glm::dvec3(m_scratch.transmittance(i, lane)) * lamp.light);
            if (m_harmonics != nullptr) {
                m_harmonics->add(lane, glm::normalize(vector_of(m_block.direction[i], lane)), light);
            } else {
                m_sums[lane] += light;
            }
        }
    }
}

void LampTracer::see(const ReadyLamp& lamp, const TileLanes& lanes, Disc& disc) const {
    disc.lit = 0;
    for (unsigned left = lanes.covered; left != 0; left &= left - 1) {
        see_lane(lamp, lanes, static_cast<std::size_t>(std::countr_zero(left)), disc);
    }
}

void LampTracer::see_lane(const ReadyLamp& lamp, const TileLanes& lanes, std::size_t lane, Disc& disc) const {
    const Sight sight = sight_of(lamp, glm::dvec3(vector_of(lanes.origin, lane)));
    if (!(sight.strength > 0.0)) {
        return;
    }
    const double sine =
        lamp.kind == LampKind::directional ? lamp.size : lamp.size / std::max(sight.distance, lamp.size);
    const OrthonormalFrame frame = orthonormal_frame(glm::vec3(sight.direction));
    const auto in_frame = [&](const glm::vec3& vector) {
        return glm::vec3(glm::dot(vector, frame.tangent), glm::dot(vector, frame.bitangent),
                         glm::dot(vector, frame.normal));
    };
    put_vector(disc.tangent, lane, frame.tangent);
    put_vector(disc.bitangent, lane, frame.bitangent);
    put_vector(disc.centre, lane, frame.normal);
    // A point in the air sees a lamp as a surface does that faces it.
    const bool in_air = m_horizon == Horizon::none;
    put_vector(disc.shading, lane, in_frame(in_air ? frame.normal : vector_of(lanes.normal, lane)));
    put_vector(disc.geometric, lane, in_frame(in_air ? frame.normal : vector_of(lanes.geometric_normal, lane)));
    disc.sine[lane] = static_cast<float>(sine);
    disc.distance[lane] = static_cast<float>(std::min(sight.distance, far_enough));
    disc.strength[lane] = sight.strength;
    disc.lit = static_cast<RayBlock::LaneBits>(disc.lit | (1U << lane));
}

// Each lane for itself, in float: what a compiler can do for several lanes at a time.
void LampTracer::aim(const ReadyLamp& lamp, const Disc& disc) {
    const bool directional = lamp.kind == LampKind::directional;
    const auto radius = static_cast<float>(std::min(lamp.size, far_enough));
    constexpr auto longest = static_cast<float>(beyond_the_scene);
    constexpr auto gap = static_cast<float>(lamp_gap);
    for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
        const Rows& point = m_points.direction[stratum];
        Rows& direction = m_block.direction[stratum];
        std::array<std::uint8_t, RayBlock::lanes> counts{};
        std::array<std::uint8_t, RayBlock::lanes> beside{};
        for (std::size_t lane = 0; lane < RayBlock::lanes; ++lane) {
            const float x = disc.sine[lane] * point[0][lane];
            const float y = disc.sine[lane] * point[1][lane];
            const float z = std::sqrt(std::max(1.0F - x * x - y * y, 0x1p-40F));
            const float cosine = disc.shading[0][lane] * x + disc.shading[1][lane] * y + disc.shading[2][lane] * z;
            const float above = disc.geometric[0][lane] * x + disc.geometric[1][lane] * y + disc.geometric[2][lane] * z;
            const float near_side = disc.distance[lane] * z - radius * point[2][lane];
            const float way = (directional ? longest : std::min(near_side, longest)) - gap;
            m_weights[stratum][lane] = cosine / z;
            counts[lane] = cosine > 0.0F && above > 0.0F ? 1 : 0;
            beside[lane] = way > 0.0F ? 0 : 1;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                direction[axis][lane] =
                    (disc.tangent[axis][lane] * x + disc.bitangent[axis][lane] * y + disc.centre[axis][lane] * z) * way;
            }
        }
        unsigned seen = 0;
        unsigned inside = 0;
        for (std::size_t lane = 0; lane < RayBlock::lanes; ++lane) {
            seen |= static_cast<unsigned>(counts[lane]) << lane;
            inside |= static_cast<unsigned>(beside[lane]) << lane;
        }
        seen &= static_cast<unsigned>(m_points.active[stratum]) & disc.lit;
        m_block.active[stratum] = static_cast<RayBlock::LaneBits>(seen & ~inside);
        m_beside[stratum] = static_cast<RayBlock::LaneBits>(seen & inside);
    }
}

void LampTracer::trace_soft(const ReadyLamp& lamp, const Disc& disc, LaneParts* parts) {
    const BlockedRays blocked = m_visibility->blocked(m_block, m_scratch);
    const unsigned shift = parts != nullptr ? part_shift(m_plan->samples()) : 0;
    const double bright = luminance(lamp.light);
    std::array<double, RayBlock::lanes> weights{};
    for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
        m_ray_count += static_cast<std::uint64_t>(std::popcount(m_block.active[stratum]));
        const unsigned open = (m_block.active[stratum] & ~static_cast<unsigned>(blocked[stratum])) | m_beside[stratum];
        const unsigned dimmed = m_scratch.dimmed()[stratum];
        m_reached[lamp.number] += static_cast<std::uint64_t>(std::popcount(open));
        for (unsigned left = open; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            if (m_harmonics != nullptr) {
                add_soft(lamp, disc, stratum, lane);
                continue;
            }
            const auto weight = static_cast<double>(m_weights[stratum][lane]);
            double luminance_seen = bright;
            if ((dimmed >> lane & 1U) == 0) {
                weights[lane] += weight;
            } else {
                const glm::dvec3 light = glm::dvec3(m_scratch.transmittance(stratum, lane)) * lamp.light;
                m_sums[lane] += weight * disc.strength[lane] * light;
                luminance_seen = luminance(light);
            }
            if (parts != nullptr) {
                parts->add(lane, m_indices.of[stratum][lane], shift, luminance_seen * disc.strength[lane] * weight);
            }
        }
    }
    for (std::size_t lane = 0; lane < weights.size(); ++lane) {
        if (weights[lane] > 0.0) {
            m_sums[lane] += weights[lane] * disc.strength[lane] * lamp.light;
        }
    }
}

void LampTracer::add_soft(const ReadyLamp& lamp, const Disc& disc, std::size_t stratum, std::size_t lane) {
    const float x = disc.sine[lane] * m_points.direction[stratum][0][lane];
    const float y = disc.sine[lane] * m_points.direction[stratum][1][lane];
    const float z = std::sqrt(std::max(1.0F - x * x - y * y, 0x1p-40F));
    const glm::vec3 direction =
        vector_of(disc.tangent, lane) * x + vector_of(disc.bitangent, lane) * y + vector_of(disc.centre, lane) * z;
    const glm::dvec3 through(m_scratch.transmittance(stratum, lane));
    m_harmonics->add(lane, direction, disc.strength[lane] / static_cast<double>(z) * (through * lamp.light));
}

} // namespace vkbake
