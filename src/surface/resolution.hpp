// What the bake frame is too coarse for.
#pragma once

#include <string>
#include <vector>

#include "vkbake/atlas.hpp"
#include "vkbake/scene.hpp"
#include "vkbake/surface.hpp"

namespace vkbake {

/// The distance between neighbouring floats at the frame's border: the frame's *step*. A vertex is within half a step
/// of its place in each coordinate, rays start 16 steps off the surface.
inline constexpr double frame_step = 0x1p-24;

/// What spans fewer steps is not resolved: over 64 steps a surface's slope is within 1/64 of right, and the light of
/// what stands on it is lost within a quarter of its length.
inline constexpr double resolved_steps = 64.0;

/// Throws Error{bad_input} where an object that has area spans fewer than 64 steps, or keeps none of its area; the
/// message names it and the step. Returns a note for what is lost of objects that do: triangles below 64 steps, and
/// triangles whose area is lost to rounding; and one where nothing has area.
[[nodiscard]] std::vector<std::string> check_resolution(const Scene& scene, const Surface& surface);

/// A note where texels are smaller than 64 steps; nothing else.
[[nodiscard]] std::vector<std::string> note_small_texels(const Surface& surface, const Atlas& atlas);

} // namespace vkbake
