#include "bench/common/ray_source.hpp"

namespace vkbake::bench {

RaySource::RaySource(const PreparedScene& scene) : m_scene(&scene), m_plan(scene.settings, scene.max_distance) {
    for (std::uint32_t page = 0; page < scene.pages.size(); ++page) {
        for (const TexelTile& tile : make_tiles(scene.pages[page], scene.surface.triangle_count())) {
            m_tiles.push_back({page, tile});
        }
    }
}

std::size_t RaySource::texel_count() const {
    std::size_t texels = 0;
    for (const Tile& tile : m_tiles) {
        texels += tile.texels.count;
    }
    return texels;
}

RayMaker::RayMaker(const RaySource& source) : m_source(&source) {
    for (const GeometryImage& page : source.scene().pages) {
        m_pages.emplace_back(source.scene().surface, page, source.plan());
    }
}

void RayMaker::begin(std::size_t tile) {
    const RaySource::Tile& begun = m_source->tiles()[tile];
    m_page = begun.page;
    m_pages[m_page].begin(begun.texels);
}

} // namespace vkbake::bench
