// Furniture in detail, for a dense interior. Each stands on y = contact_gap, centred on the origin, its back towards
// −Z.
#pragma once

#include "make_scenes/solid.hpp"

namespace vkbake::scenes {

[[nodiscard]] Model make_chair();
[[nodiscard]] Model make_table(const glm::dvec3& size, Paint paint);

/// A shelf of five boards, each full of books; `number` varies them.
[[nodiscard]] Model make_bookcase(double width, std::uint32_t number);

/// Three seats, six large cushions and some small ones.
[[nodiscard]] Model make_sofa();

/// With mattress, blanket and pillows.
[[nodiscard]] Model make_bed(double width);

[[nodiscard]] Model make_floor_lamp();
/// Hangs: its top is at y = 0.
[[nodiscard]] Model make_chandelier(int arms);

/// A row of cupboards with a worktop, `count` of 0.6 m.
[[nodiscard]] Model make_cupboards(int count, double height);

[[nodiscard]] Model make_bathtub();

} // namespace vkbake::scenes
