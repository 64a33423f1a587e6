// Small procedural textures. Wood and grain tile, and are near white so that a base colour tints them.
#pragma once

#include <cstdint>

#include "make_scenes/paint.hpp"
#include "make_scenes/png.hpp"

namespace vkbake::scenes {

/// `wood` has its fibres along v; `grain` is a fine speckle for plaster, stone and earth; `sprig` is a twig with
/// leaves, from the bottom up, and clear around them. Not for Texture::none
/// and normals.
[[nodiscard]] PaletteImage make_texture(Texture texture);

/// A normal map (glTF's) of round cobbles, 64 of them, that tiles.
[[nodiscard]] ColorImage make_cobble_normals();

/// Metres of surface that one repetition of a texture covers.
inline constexpr double texture_metres = 1.0;

/// A repeatable value in 0…1 for a number, to vary things by.
[[nodiscard]] double random_of(std::uint32_t number);

} // namespace vkbake::scenes
