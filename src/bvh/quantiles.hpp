// The quantiles of the vertices along an axis.
#pragma once

#include <array>
#include <vector>

#include "bvh/triangle_list.hpp"

namespace vkbake {

/// By axis, ascending: of all corners' coordinates, sorted, those at the places ⌊j · corners / splits⌋, counted from 0,
/// for j from 1 to splits − 1 (at least one split). None without triangles. The same as a full sort gives: a sample
/// tells about where they are, and then all corners are counted, and the few that lie there sorted out.
[[nodiscard]] std::array<std::vector<float>, 3> quantiles(const ListedTriangles& triangles, std::size_t splits,
                                                          int threads);

} // namespace vkbake
