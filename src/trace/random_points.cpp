#include "trace/random_points.hpp"

#include <algorithm>
#include <cmath>

#include "base/random.hpp"

namespace vkbake {

namespace {

/// A part of the square [0, 1]².
struct Area {
    double left = 0.0;
    double top = 0.0;
    double width = 1.0;
    double height = 1.0;
};

/// Of the cell that holds sample `number` of `rays`, in `rows` rows.
Area cell_of(std::uint32_t number, std::uint32_t rays, std::uint32_t rows) {
    const auto first_of = [&](std::uint64_t row) { return (row * rays + rows - 1) / rows; };
    const std::uint64_t row = std::uint64_t{number} * rows / rays;
    const auto first = static_cast<double>(first_of(row));
    const double cells = static_cast<double>(first_of(row + 1)) - first;
    return {(number - first) / cells, first / rays, 1.0 / cells, cells / rays};
}

/// 25 of a word's bits as an odd number of 2⁻²⁶: never 0, ½ or 1, so that no point lies on an axis or a border.
double inner(std::uint64_t bits) { return (2.0 * static_cast<double>(bits & 0x1FFFFFFU) + 1.0) * 0x1p-26; }

float centred_point(double place) {
    constexpr float most = 1.0F - 0x1p-24F;
    return std::clamp(static_cast<float>(2.0 * place - 1.0), -most, most);
}

} // namespace

RandomPoints::RandomPoints(Sampler sampler, std::uint32_t rays)
    : m_sampler(sampler), m_rays(rays), m_rows(static_cast<std::uint32_t>(std::lround(std::sqrt(rays)))) {}

void RandomPoints::set_points(const TileLanes& lanes, std::size_t number, RayBlock& block) const {
    for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
        const auto sample = static_cast<std::uint32_t>(number * RayBlock::strata + stratum);
        const bool asked = sample < m_rays;
        block.active[stratum] = asked ? lanes.covered : RayBlock::LaneBits{0};
        const Area area = asked && m_sampler == Sampler::stratified ? cell_of(sample, m_rays, m_rows) : Area{};
        const std::uint64_t salt = mix64(sample + 1U);
        for (std::size_t lane = 0; lane < RayBlock::lanes; ++lane) {
            const std::uint64_t random = mix64(lanes.scrambles.random(lane) ^ salt);
            block.direction[stratum][0][lane] = centred_point(area.left + inner(random >> 32U) * area.width);
            block.direction[stratum][1][lane] = centred_point(area.top + inner(random) * area.height);
        }
    }
}

} // namespace vkbake
