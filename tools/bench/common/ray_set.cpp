#include "bench/common/ray_set.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/random.hpp"
#include "vkbake/error.hpp"

namespace vkbake::bench {
std::size_t count_active(const RayBlock& block) {
    std::size_t rays = 0;
    for (const RayBlock::LaneBits bits : block.active) {
        rays += static_cast<std::size_t>(std::popcount(bits));
    }
    return rays;
}

RaySet choose_rays(const RaySource& source, std::size_t rays) {
    const std::size_t all = source.texel_count() * source.plan().samples();
    if (all == 0) {
        throw Error(ErrorKind::bad_input, "rays: the map covers no texel; choose a larger size");
    }
    const double share = std::min(1.0, static_cast<double>(rays) / static_cast<double>(all));
    const auto wanted = std::max(1.0, std::round(share * static_cast<double>(source.tiles().size())));
    RaySet set{.source = &source, .blocks_a_tile = source.blocks_a_tile()};
    for (std::size_t k = 0; static_cast<double>(k) < wanted; ++k) {
        const double place = (static_cast<double>(k) + 0.5) * static_cast<double>(source.tiles().size()) / wanted;
        set.tiles.push_back(static_cast<std::size_t>(place));
    }
    set.blocks.resize(set.tiles.size() * set.blocks_a_tile);
    RayMaker maker(source);
    for (std::size_t i = 0; i < set.tiles.size(); ++i) {
        maker.begin(set.tiles[i]);
        for (std::size_t b = 0; b < set.blocks_a_tile; ++b) {
            RayBlock& block = set.blocks[i * set.blocks_a_tile + b];
            block = maker.make(b);
            set.ray_count += count_active(block);
        }
    }
    return set;
}

RaySet thinned(const RaySet& set, std::size_t rays) {
    RaySet thin{.source = set.source, .blocks_a_tile = 1};
    const double share = std::min(1.0, static_cast<double>(rays) / static_cast<double>(set.ray_count));
    const auto limit = static_cast<std::uint64_t>(share * 0x1p63);
    for (std::size_t b = 0; b < set.blocks.size(); ++b) {
        RayBlock block = set.blocks[b];
        for (std::size_t ray = 0; ray < RayBlock::rays; ++ray) {
            if (mix64(b * RayBlock::rays + ray + 1) >> 1U >= limit) {
                RayBlock::LaneBits& bits = block.active[ray / RayBlock::lanes];
                bits = static_cast<RayBlock::LaneBits>(bits & ~(1U << ray % RayBlock::lanes));
            }
        }
        if (const std::size_t left = count_active(block); left > 0) {
            thin.tiles.push_back(thin.tiles.size());
            thin.blocks.push_back(block);
            thin.ray_count += left;
        }
    }
    return thin;
}

} // namespace vkbake::bench
