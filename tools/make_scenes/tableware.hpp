// What stands on tables and in cupboards. Each stands on y = contact_gap, centred on the origin.
#pragma once

#include "make_scenes/solid.hpp"

namespace vkbake::scenes {

[[nodiscard]] Model make_plate(double radius, Paint paint);
[[nodiscard]] Model make_bowl(double radius, Paint paint);
[[nodiscard]] Model make_glass();
[[nodiscard]] Model make_bottle(double height, Paint paint);
[[nodiscard]] Model make_jug(Paint paint);

/// Plate, bowl, glass, knife, fork and spoon, for one who sits at +Z.
[[nodiscard]] Model make_place_setting();

/// A bowl with a dozen round fruits.
[[nodiscard]] Model make_fruit_bowl();

} // namespace vkbake::scenes
