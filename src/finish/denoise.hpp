// The compute passes that take noise out of a map.
#pragma once

#include <cstdint>

#include "finish/denoise_fields.hpp"
#include "vkbake/lightmap.hpp"

namespace vkbake {

namespace gpu {
class Context;
}

struct DenoiseSettings {
    int tile = 1024; ///< side of a tile without its border, texels; the result does not depend on it
};

/// Three passes over the map's texels:
///
/// 1. guides: means of luminance and of its variance over 3 × 3 texels.
/// 2. fits: of the 7 × 7 texels around each one those count that lie on its chart, on one smooth piece of surface with
///    it (normals, tangent plane), and whose luminance, and mean around them, differ from its own by at most three
///    standard errors of the difference. The plane of least squares through their light gives the new value, so that a
///    gradient stays what it is where a border cuts the window. Texels whose noise is an eighth of the map's or less
///    stay as they are.
/// 3. choice: y being a texel's luminance with variance v, f its fit's, in which it has the share h, (f − y)² −
///    (1 − 2h) v is an unbiased estimate of (f − truth)² (Stein 1981, for filters of this kind Van De Ville and Kocher
///    2009, Li, Wu and Chuang 2012), so far as which texels count does not hang on y itself. Where its mean over 9 × 9
///    texels is more than that of v, the fits blur more than they mend, and the texel stays as it was. (Over 5 × 5 the
///    estimate is so noisy that specks of the old noise stay on even walls: 10 % more error in the storage room's
///    draft.)
///
/// That texels are compared with their measured variance, and pixel by pixel and by means, is after Rousselle, Knaus
/// and Zwicker (2012); that planes are fitted, after Moon, Carr and Yoon (2014) and Bitterli et al. (2016).
///
/// Sets the light, the standard errors and the error of the map: of what they are now. Returns how many texels it
/// changed; the others keep their bits. The result depends neither on the device nor on the tiles.
std::uint64_t denoise(gpu::Context& context, LightMap& map, const DenoiseGuides& guides,
                      const DenoiseSettings& settings = {});

} // namespace vkbake
