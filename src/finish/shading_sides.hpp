// Which triangles of a chart are shaded as one surface, and which meet at a crease.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "vkbake/atlas.hpp"
#include "vkbake/surface.hpp"

namespace vkbake {

/// The cosine of the least angle between shading normals that makes a crease: light changes by less than a twentieth
/// across what is bent less, unless it grazes.
inline constexpr float crease_cosine = 0.999F;

/// For each of the triangles (of one page, each once) a number that it shares with those of its chart that it hangs
/// together with across edges without a crease: with which it shares both corners' UVs, and their normals. The number
/// is the place of one of them in `triangles`.
[[nodiscard]] std::vector<std::uint32_t> shading_sides(const Surface& surface, const Atlas& atlas,
                                                       std::span<const std::uint32_t> triangles);

} // namespace vkbake
