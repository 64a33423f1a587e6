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
    count
};

enum class Texture { none, wood, grain };

struct PaintInfo {
    std::string_view name;
    glm::dvec3 colour; ///< linear base colour, 0…1; multiplies the texture
    Texture texture = Texture::none;
};

[[nodiscard]] const PaintInfo& paint_info(Paint paint);

} // namespace vkbake::scenes
