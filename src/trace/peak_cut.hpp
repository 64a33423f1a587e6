// What of a sky's picture is too bright to be found by chance: its sun, its lamps.
#pragma once

#include <string>

#include "trace/sky_lookup.hpp"

namespace vkbake {

/// A sky cut in two at a radiance T: of a texel that is brighter (luminance), what T leaves is a *peak*. Look-ups being
/// linear in the texels, the sky is what it was: the sum of the picture cut off at T and of the peaks' tents.
struct PeakCut {
    double threshold = 0.0;   ///< T
    double light_share = 0.0; ///< what the peaks send of all the sky's light
    double solid_share = 0.0; ///< of the sphere, where they are
    double variance = 0.0;    ///< of a sample's luminance, the peaks' sampled on its own (see find_peaks)
    double variance_uncut = 0.0;
    /// Rays of their own for the peaks are worth it where they do more than as many rays more by the cosine: scrambled
    /// nets take a variance to 2^−1.5 by twice the rays, and so much must the cut take away, and a little more.
    [[nodiscard]] bool worthwhile() const { return variance < 0.25 * variance_uncut; }
};

/// The cut at a quarter-octave of radiance that leaves the least variance. A sample's variance is taken for that of the
/// sky's luminance over the sphere where every second ray is blocked; the peaks' own samples all bring the same then.
/// Skies that are no pictures, or narrower than 16 texels, have no peaks: nothing is worthwhile.
[[nodiscard]] PeakCut find_peaks(const SkyLookup& sky);

/// "83 % of the sky's light comes from 0.003 % of its solid angle"
[[nodiscard]] std::string describe(const PeakCut& cut);

} // namespace vkbake
