#include "make_scenes/paint.hpp"

#include <cstddef>

namespace vkbake::scenes {

const PaintInfo& paint_info(Paint paint) {
    static constexpr std::array<PaintInfo, static_cast<std::size_t>(Paint::count)> table{{
        {"white", {0.80, 0.80, 0.80}},
        {"plaster", {0.84, 0.82, 0.77}, Texture::grain},
        {"cream plaster", {0.86, 0.76, 0.58}, Texture::grain},
        {"terracotta", {0.72, 0.38, 0.24}, Texture::grain},
        {"brick", {0.62, 0.27, 0.18}, Texture::grain},
        {"pale brick", {0.70, 0.38, 0.26}, Texture::grain},
        {"dark brick", {0.48, 0.22, 0.17}, Texture::grain},
        {"mortar", {0.62, 0.59, 0.54}, Texture::grain},
        {"stone", {0.56, 0.57, 0.58}, Texture::grain},
        {"warm stone", {0.68, 0.60, 0.48}, Texture::grain},
        {"concrete", {0.60, 0.59, 0.57}, Texture::grain},
        {"earth", {0.50, 0.39, 0.28}, Texture::grain},
        {"grass", {0.36, 0.46, 0.24}, Texture::grain},
        {"oak", {0.76, 0.52, 0.30}, Texture::wood},
        {"pine", {0.90, 0.70, 0.44}, Texture::wood},
        {"walnut", {0.50, 0.31, 0.18}, Texture::wood},
        {"weathered wood", {0.62, 0.58, 0.52}, Texture::wood},
        {"green wood", {0.34, 0.52, 0.42}, Texture::wood},
        {"blue wood", {0.34, 0.50, 0.66}, Texture::wood},
        {"iron", {0.33, 0.34, 0.36}},
        {"bronze", {0.58, 0.43, 0.24}},
        {"rubber", {0.30, 0.30, 0.30}},
        {"red enamel", {0.72, 0.16, 0.11}},
        {"yellow enamel", {0.80, 0.60, 0.16}},
        {"green enamel", {0.24, 0.46, 0.30}},
        {"blue enamel", {0.26, 0.42, 0.62}},
        {"linen", {0.78, 0.70, 0.56}, Texture::grain},
        {"straw", {0.80, 0.66, 0.36}, Texture::grain},
        {"leaves", {1.0, 1.0, 1.0}, Texture::sprig},
        {"gauze", {0.86, 0.82, 0.74}, Texture::none, 0.5},
        {"red glass", {0.86, 0.07, 0.05}, Texture::none, 1.0, 0.9},
        {"amber glass", {0.95, 0.58, 0.08}, Texture::none, 1.0, 0.9},
        {"blue glass", {0.06, 0.22, 0.80}, Texture::none, 1.0, 0.9},
        {"cobbles", {0.50, 0.47, 0.43}, Texture::grain, 1.0, 0.0, Texture::cobble_normals},
        {"glow", {0.80, 0.80, 0.80}, Texture::none, 1.0, 0.0, Texture::none, {60.0, 34.0, 14.0}},
    }};
    return table[static_cast<std::size_t>(paint)];
}

} // namespace vkbake::scenes
