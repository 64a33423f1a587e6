// The rays of a bake, tile by tile, as the tracer makes them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "bench/common/prepare_scene.hpp"
#include "trace/tile_rays.hpp"

namespace vkbake::bench {

/// All tiles of a scene. The scene must outlive it.
class RaySource {
public:
    struct Tile {
        std::uint32_t page = 0;
        TexelTile texels;
    };

    explicit RaySource(const PreparedScene& scene);

    [[nodiscard]] const PreparedScene& scene() const { return *m_scene; }
    [[nodiscard]] const RayPlan& plan() const { return m_plan; }
    [[nodiscard]] const std::vector<Tile>& tiles() const { return m_tiles; }
    [[nodiscard]] std::size_t texel_count() const;
    [[nodiscard]] std::size_t blocks_a_tile() const { return m_plan.block_count(); }

private:
    const PreparedScene* m_scene; ///< never null
    RayPlan m_plan;
    std::vector<Tile> m_tiles;
};

/// Makes the blocks of one tile after the other; one a thread. The source must outlive it.
class RayMaker {
public:
    explicit RayMaker(const RaySource& source);

    void begin(std::size_t tile);
    /// Holds until the next call.
    const RayBlock& make(std::size_t block_of_tile) { return m_pages[m_page].make(block_of_tile); }

private:
    const RaySource* m_source; ///< never null
    std::vector<TileRays> m_pages;
    std::size_t m_page = 0;
};

} // namespace vkbake::bench
