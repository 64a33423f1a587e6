// The materials that all the models share.
#pragma once

#include <array>
#include <string_view>

#include <glm/vec3.hpp>

namespace vkbake::scenes {

enum class Paint {
    white,
    plaster,
    cream_plaster,
    terracotta,
    brick,
    brick_pale,
    brick_dark,
    mortar,
    stone,
    stone_warm,
    concrete,
    earth,
    grass,
    oak,
    pine,
    walnut,
    weathered_wood,
    green_wood,
    blue_wood,
    iron,
    bronze,
    rubber,
    red_enamel,
    yellow_enamel,
    green_enamel,
    blue_enamel,
    linen,
    straw,
    leaves,
    gauze,
    red_glass,
    amber_glass,
    blue_glass,
    cobbles,
    glow,
    count
};

enum class Texture { none, wood, grain, sprig, cobble_normals };

struct PaintInfo {
    std::string_view name;
    glm::dvec3 colour; ///< linear base colour, 0…1; multiplies the texture
    Texture texture = Texture::none;
    double alpha = 1.0;        ///< < 1: blended
    double transmission = 0.0; ///< > 0: glass
    Texture normals = Texture::none;
    glm::dvec3 emission{0.0}; ///< radiance
};

/// Whether light gets through; such surfaces are thin, and seen from both sides.
[[nodiscard]] inline bool lets_light_through(const PaintInfo& info) {
    return info.texture == Texture::sprig || info.alpha < 1.0 || info.transmission > 0.0;
}

[[nodiscard]] const PaintInfo& paint_info(Paint paint);

} // namespace vkbake::scenes
