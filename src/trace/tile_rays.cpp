#include "trace/tile_rays.hpp"

#include <numbers>

namespace vkbake {

namespace {

RayPlan::Directions make_directions(const Settings& settings, std::uint32_t first) {
    if (settings.sampler == Sampler::thesis) {
        return ThesisDirections();
    }
    if (settings.sampler != Sampler::cosine) {
        return RandomPoints(settings.sampler, settings.rays);
    }
    return CosineStrata(settings.rays, first);
}

} // namespace

RayPlan::RayPlan(const Settings& settings, float max_distance, std::uint32_t first)
    : m_settings(settings), m_max_distance(max_distance), m_directions(make_directions(settings, first)) {}

std::size_t RayPlan::block_count() const {
    return std::visit([](const auto& directions) { return directions.block_count(); }, m_directions);
}

std::uint32_t RayPlan::samples() const {
    return std::visit([](const auto& directions) { return directions.rays(); }, m_directions);
}

std::uint32_t RayPlan::first() const {
    const auto* cosine = std::get_if<CosineStrata>(&m_directions);
    return cosine != nullptr ? cosine->first() : 0;
}

std::uint64_t RayPlan::full_strata() const {
    const auto* cosine = std::get_if<CosineStrata>(&m_directions);
    return cosine != nullptr ? cosine->full_count() : samples();
}

double RayPlan::scale() const {
    return (std::holds_alternative<ThesisDirections>(m_directions) ? std::numbers::pi : 1.0) / samples();
}

RayPlan::Weights RayPlan::weights(std::size_t block) const {
    Weights weights{};
    weights.fill(1.0);
    if (const auto* thesis = std::get_if<ThesisDirections>(&m_directions)) {
        for (std::size_t stratum = 0; stratum < weights.size(); ++stratum) {
            weights[stratum] = thesis->sample(block, stratum).weight;
        }
    }
    return weights;
}

bool RayPlan::weighs_rays() const {
    const auto* random = std::get_if<RandomPoints>(&m_directions);
    return random != nullptr && random->even();
}

TileRays::TileRays(const Surface& surface, const GeometryImage& geometry, const RayPlan& plan)
    : m_surface(&surface), m_geometry(&geometry), m_plan(&plan) {
    m_block.max_distance = plan.max_distance();
}

void TileRays::begin(const TexelTile& tile) {
    set_lanes(*m_surface, *m_geometry, m_plan->settings(), tile, m_lanes);
    m_block.origin = m_lanes.origin;
    m_block.ignored_triangle = m_lanes.triangle;
    if (const auto* cosine = std::get_if<CosineStrata>(&m_plan->directions())) {
        invert_scrambles(*cosine, m_lanes, m_tables);
    }
}

const RayBlock& TileRays::make(std::size_t block, SampleIndices* indices) {
    if (const auto* cosine = std::get_if<CosineStrata>(&m_plan->directions())) {
        return make(cosine->block(block), indices);
    }
    if (const auto* random = std::get_if<RandomPoints>(&m_plan->directions())) {
        random->set_points(m_lanes, block, m_block);
        m_asked = lift_points(random->even(), m_lanes, m_block);
    } else {
        m_asked = set_directions(*std::get_if<ThesisDirections>(&m_plan->directions()), m_lanes, block, m_block);
    }
    return m_block;
}

const RayBlock& TileRays::make(const BlockStrata& strata, SampleIndices* indices) {
    m_asked =
        set_directions(*std::get_if<CosineStrata>(&m_plan->directions()), m_tables, m_lanes, strata, m_block, indices);
    return m_block;
}

double TileRays::weight(std::size_t stratum, std::size_t lane) const {
    if (!m_plan->weighs_rays()) {
        return 1.0;
    }
    double cosine = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        cosine += static_cast<double>(m_block.direction[stratum][axis][lane]) *
                  static_cast<double>(m_lanes.normal[axis][lane]);
    }
    return 2.0 * cosine;
}

} // namespace vkbake
