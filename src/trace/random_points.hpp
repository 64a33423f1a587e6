// Samples without a sequence: what the sampler `cosine` is measured against.
#pragma once

#include <cstddef>
#include <cstdint>

#include "bvh/ray_block.hpp"
#include "trace/tile_lanes.hpp"
#include "vkbake/settings.hpp"

namespace vkbake {

/// Points of the square (−1, 1)² by random numbers, each a function of its texel's scramble and its own number.
///
/// `uniform`: independent. `stratified`: one in each cell of a partition of the square into as many cells of one area:
/// about √N rows of about √N cells, each row as high as it has cells.
class RandomPoints {
public:
    /// `rays` ≥ 1; `sampler`: uniform or stratified.
    RandomPoints(Sampler sampler, std::uint32_t rays);

    [[nodiscard]] std::uint32_t rays() const { return m_rays; }
    /// Whether directions are to be spread evenly over the hemisphere, each with a weight of twice its cosine; else by
    /// the cosine.
    [[nodiscard]] bool even() const { return m_sampler == Sampler::uniform; }
    [[nodiscard]] std::size_t block_count() const { return (m_rays + RayBlock::strata - 1) / RayBlock::strata; }

    /// Sets x and y, in the first two axes of block.direction, and `active`: all samples of covered lanes.
    void set_points(const TileLanes& lanes, std::size_t number, RayBlock& block) const;

private:
    Sampler m_sampler;
    std::uint32_t m_rays;
    std::uint32_t m_rows;
};

} // namespace vkbake
