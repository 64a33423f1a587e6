// Light mixed across creases inside charts.
#pragma once

#include <span>
#include <vector>

#include "finish/crease_texels.hpp"
#include "vkbake/image.hpp"
#include "vkbake/lightmap.hpp"

namespace vkbake {

/// Mixes RGB by the texels' shares; A, coverage and all other texels keep their bits.
void blend_creases(std::span<const CreaseTexel> creases, Image& image);

/// The same with standard errors, row-major in rows of `width`: of the mixed light they are no greater than the mixed
/// ones.
void blend_creases(std::span<const CreaseTexel> creases, int width, std::vector<float>& standard_errors);

/// All pictures of a map and, where it has them, its standard errors; counts the texels.
void blend_creases(std::span<const CreaseTexel> creases, LightMap& map);

} // namespace vkbake
