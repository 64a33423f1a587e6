// xatlas on the surface that we get.
#pragma once

#include "bench/atlas/contest.hpp"

namespace vkbake::bench {

/// Its default chart options; its pack options but for the gutter and `charts rotated`: what it needs to fill a square
/// of `size` texels, which it misses by a little. Throws Error{bake_failed} where it refuses a mesh.
[[nodiscard]] Unwrapped unwrap_by_xatlas(const Surface& surface, int size, int gutter);

} // namespace vkbake::bench
