#include "trace/tile_rays.hpp"

#include <numbers>

namespace vkbake {

namespace {

std::variant<CosineStrata, ThesisDirections> make_directions(const Settings& settings, std::uint32_t first) {
    if (settings.sampler == Sampler::thesis) {
        return ThesisDirections();
    }
    return CosineStrata(settings.rays, first);
}

} // namespace

RayPlan::RayPlan(const Settings& settings, float max_distance, std::uint32_t first)
    : m_settings(settings), m_max_distance(max_distance), m_directions(make_directions(settings, first)) {}

std::size_t RayPlan::block_count() const {
    const auto* cosine = std::get_if<CosineStrata>(&m_directions);
    return cosine != nullptr ? cosine->block_count() : ThesisDirections::block_count;
}

std::uint32_t RayPlan::samples() const {
    const auto* cosine = std::get_if<CosineStrata>(&m_directions);
    return cosine != nullptr ? cosine->rays() : ThesisDirections::count;
}

std::uint32_t RayPlan::first() const {
    const auto* cosine = std::get_if<CosineStrata>(&m_directions);
    return cosine != nullptr ? cosine->first() : 0;
}

std::uint64_t RayPlan::full_strata() const {
    const auto* cosine = std::get_if<CosineStrata>(&m_directions);
    return cosine != nullptr ? cosine->full_count() : ThesisDirections::count;
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
        m_asked = set_directions(*cosine, m_tables, m_lanes, block, m_block, indices);
    } else {
        m_asked = set_directions(*std::get_if<ThesisDirections>(&m_plan->directions()), m_lanes, block, m_block);
    }
    return m_block;
}

} // namespace vkbake
