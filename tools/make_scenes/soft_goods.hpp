// Cloth and cushions: finely tessellated, as modelling programs export them.
#pragma once

#include <functional>

#include "make_scenes/solid.hpp"

namespace vkbake::scenes {

/// A cloth of `columns` × `rows` cells whose middle is `surface`(u, v), u and v in 0…1, `thickness` metres thick along
/// `across`: closed.
[[nodiscard]] Solid sheet(int columns, int rows, const std::function<glm::dvec3(double, double)>& surface,
                          const glm::dvec3& across, double thickness, Paint paint);

/// Hangs from y = height in folds, `width` along X.
[[nodiscard]] Model make_curtain(double width, double height, Paint paint);

/// Lies on y = 0 with waves, centred, and hangs down at its sides by `drop`.
[[nodiscard]] Model make_blanket(double width, double length, double drop, Paint paint);

/// A pillow of these measures, its lowest point at y = contact_gap.
[[nodiscard]] Model make_cushion(const glm::dvec3& size, Paint paint);

} // namespace vkbake::scenes
