// Things that stand about in rooms. Each stands on y = contact_gap, centred on the origin unless said otherwise.
#pragma once

#include "make_scenes/solid.hpp"

namespace vkbake::scenes {

/// 0.9 m high, with hoops that are part of the turned shape.
[[nodiscard]] Model make_barrel(int segments = 20);

/// A box of planks with a frame, `size` metres, painted `paint`.
[[nodiscard]] Model make_crate(const glm::dvec3& size, Paint paint);

/// A plain crate of three solids: box, and a lid that stands out.
[[nodiscard]] Model make_chest(const glm::dvec3& size, Paint paint);

/// Two ladders of posts with `boards` boards; its back towards −Z.
[[nodiscard]] Model make_shelf(double width, double depth, double height, int boards, Paint paint);

/// A jar with a lip, 0.3 m high.
[[nodiscard]] Model make_jar(int segments, Paint paint);

/// A full sack that bulges, 0.55 m high.
[[nodiscard]] Model make_sack(int segments);

} // namespace vkbake::scenes
