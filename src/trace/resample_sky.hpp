// A sky's picture → the map that rays look up.
#pragma once

#include "trace/sky_lookup.hpp"

namespace vkbake {

/// Where the sky is a picture, puts a SkyMap of it in its place, whose texels are the means of what the picture,
/// bilinear, has there: about as many texels as the picture, but no more than stay in a processor's caches. Packed
/// where that is no coarser than the picture is. Other skies stay as they are. `threads` as parallel_ranges; the map
/// does not depend on it.
void resample(SkyLookup& sky, int threads);

} // namespace vkbake
