#include "trace/sampled_map.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/luminance.hpp"
#include "base/percentile.hpp"
#include "trace/tile_loop.hpp"

namespace vkbake {

double MapEstimate::relative_rmse() const {
    const double variance = before.variance + sampled.variance;
    return variance > 0.0 ? std::sqrt(variance) / mean() : 0.0;
}

SampledMap::SampledMap(std::span<const TexelTile> tiles, const Settings& settings, float max_distance, double intensity,
                       const KnownLight& before)
    : m_tiles(tiles), m_settings(settings), m_max_distance(max_distance), m_intensity(intensity), m_before(before),
      m_rays(tiles.size(), 0), m_sums(tiles.size()) {
    std::uint32_t slots = 0;
    m_first_slot.reserve(tiles.size());
    for (const TexelTile& tile : tiles) {
        m_first_slot.push_back(slots);
        slots += tile.count;
    }
    m_records.resize(slots);
    if (reuses_visibility(settings)) {
        m_seen.resize(tiles.size());
    }
}

std::size_t SampledMap::extend(std::span<const TileOrder> orders, const Samplers& samplers,
                               const std::function<bool(std::size_t done)>& report) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, RayPlan> plans; // by the samples before and after
    std::uint64_t rays = 0;
    for (const TileOrder& order : orders) {
        const std::uint32_t had = m_rays[order.tile];
        rays += std::uint64_t{order.rays - had} * RayBlock::lanes;
        if (!plans.contains({had, order.rays})) {
            Settings settings = m_settings;
            settings.rays = order.rays;
            plans.try_emplace({had, order.rays}, settings, m_max_distance, had);
        }
    }
    const TileLoop loop{.count = orders.size(),
                        .rays_a_job = orders.empty() ? 1 : rays / orders.size(),
                        .threads = m_settings.threads,
                        .report = report};
    return run(loop, [&](std::size_t job, std::size_t worker) {
        const TileOrder& order = orders[job];
        const std::uint32_t had = m_rays[order.tile];
        TileSampler& sampler = *samplers[worker];
        sampler.set_plan(plans.find({had, order.rays})->second);
        sampler.sample(m_tiles[order.tile], m_seen.empty() ? nullptr : &m_seen[order.tile]);
        for (std::uint32_t lane = 0; lane < m_tiles[order.tile].count; ++lane) {
            add(m_first_slot[order.tile] + lane, lane, sampler.light(lane), sampler.parts(), had, order.rays);
        }
        m_rays[order.tile] = order.rays;
        m_sums[order.tile] = sums_of(order.tile);
    });
}

void SampledMap::add(std::size_t slot, std::size_t lane, const glm::dvec3& sum, const LaneParts& parts,
                     std::uint32_t had, std::uint32_t has) {
    Record& record = m_records[slot];
    std::array<double, part_count> sums{};
    if (had > 0) { // a part of then is a piece of one of now
        const unsigned fold = part_shift(has) - part_shift(had);
        for (std::size_t part = 0; part < part_count; ++part) {
            sums[part >> fold] += static_cast<double>(record.parts[part]);
        }
    }
    for (std::size_t part = 0; part < part_count; ++part) {
        record.parts[part] = static_cast<float>(sums[part] + m_intensity * parts.luminance[part][lane]);
    }
    record.sum += m_intensity * sum;
    record.of_lights += m_intensity * parts.of_lights[lane];
    record.open += parts.open[lane];
    record.blocked += parts.blocked[lane];
}

template<typename Visit>
void SampledMap::each_texel(const Visit& visit) const {
    for (std::size_t tile = 0; tile < m_tiles.size(); ++tile) {
        for (std::uint32_t lane = 0; lane < m_tiles[tile].count; ++lane) {
            visit(m_tiles[tile].texels[lane], m_records[m_first_slot[tile] + lane], m_rays[tile]);
        }
    }
}

SampledMap::TileSums SampledMap::sums_of(std::size_t tile) const {
    TileSums sums;
    for (std::uint32_t lane = 0; lane < m_tiles[tile].count; ++lane) {
        const Record& record = m_records[m_first_slot[tile] + lane];
        sums.contrasts += contrasts(record.parts, m_rays[tile]);
        sums.luminance += luminance(record.sum) / m_rays[tile];
    }
    if (!m_seen.empty()) {
        sums.traced_share = KnownCells(m_seen[tile], m_rays[tile], m_tiles[tile].count).traced_share();
    }
    return sums;
}

MapEstimate SampledMap::estimate() const {
    MapEstimate result{.before = m_before};
    if (m_records.empty()) {
        return result;
    }
    FallOfVariance fall;
    for (const TileSums& sums : m_sums) {
        fall.add(sums.contrasts);
        result.sampled.mean += sums.luminance;
    }
    result.ratio = fall.ratio();
    for (std::size_t tile = 0; tile < m_tiles.size(); ++tile) {
        result.sampled.variance += coarse_variance(m_sums[tile].contrasts, result.ratio, m_rays[tile]);
    }
    result.sampled.mean /= static_cast<double>(m_records.size());
    result.sampled.variance /= static_cast<double>(m_records.size());
    return result;
}

double SampledMap::tile_variance(std::size_t tile, double ratio) const {
    return variance(m_sums[tile].contrasts, ratio, m_rays[tile]);
}

double SampledMap::greatest_luminance() const {
    double greatest = 0.0;
    each_texel([&](std::uint32_t /*texel*/, const Record& record, std::uint32_t rays) {
        greatest = std::max(greatest, (luminance(record.sum) - record.of_lights) / rays);
    });
    return greatest;
}

double SampledMap::standard_error(const Record& record, std::uint32_t rays, double ratio, double greatest) const {
    // Of what none of N rays met, the share may still be 3 / N (95 %).
    constexpr double rule_of_three = 3.0 / interval_95;
    const bool unseen = record.open == 0 || record.blocked == 0;
    const double least = unseen ? rule_of_three * greatest / static_cast<double>(rays) : 0.0;
    return std::sqrt(variance(contrasts(record.parts, rays), ratio, rays) + least * least);
}

std::vector<float> SampledMap::variances(std::size_t texels) const {
    const MapEstimate whole = estimate();
    double sum = 0.0;
    for (std::size_t tile = 0; tile < m_tiles.size(); ++tile) {
        sum += tile_variance(tile, whole.ratio);
    }
    const double scale = sum > 0.0 ? whole.sampled.variance * static_cast<double>(m_records.size()) / sum : 0.0;
    std::vector<float> result(texels, 0.0F);
    each_texel([&](std::uint32_t texel, const Record& record, std::uint32_t rays) {
        result[texel] = static_cast<float>(scale * variance(contrasts(record.parts, rays), whole.ratio, rays));
    });
    return result;
}

void SampledMap::write_to(LightMap& map) const {
    const MapEstimate whole = estimate();
    const double greatest = greatest_luminance();
    map.texel_rays.assign(map.image.texels.size(), 0);
    map.standard_error.assign(map.image.texels.size(), 0.0F);
    each_texel([&](std::uint32_t texel, const Record& record, std::uint32_t rays) {
        map.image.texels[texel] = glm::vec4(glm::vec3(record.sum / static_cast<double>(rays)), 1.0F);
        map.image.coverage[texel] = 1.0F;
        map.texel_rays[texel] = rays;
        map.standard_error[texel] = static_cast<float>(standard_error(record, rays, whole.ratio, greatest));
    });
    MapError error{.relative_rmse = whole.relative_rmse()};
    if (whole.mean() > 0.0) {
        error.percentile_99 = covered_percentile_99(map.standard_error, map.image.coverage) / whole.mean();
    }
    error.slope = 0.5 * std::log2(whole.ratio);
    map.error = error;
}

} // namespace vkbake
