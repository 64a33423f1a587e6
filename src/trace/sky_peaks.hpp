// What of a sky's picture is too bright to be found by chance: its sun, its lamps.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

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

/// Directions to the peaks, in proportion to what they send. Holds the peaks that it took out of a picture.
class SkyPeaks {
public:
    struct Sample {
        glm::vec3 direction{0.0F}; ///< unit, of the scene
        glm::vec3 light{0.0F};     ///< cos θ times this is on average what the peaks add to E/π
        std::size_t peak = 0;      ///< < count()
    };

    /// Cuts off `sky`'s picture at the threshold; there is something above it.
    SkyPeaks(SkyLookup& sky, double threshold);

    /// `u`, `v`: uniform in (0, 1). v chooses a row of the picture, u a texel in it, and what is left of both a point
    /// of the texel's tent; so points beside each other give directions beside each other, and stratified ones
    /// stratified ones.
    [[nodiscard]] Sample sample(double u, double v) const;

    [[nodiscard]] std::size_t count() const { return m_peaks.size(); }
    [[nodiscard]] double probability(std::size_t peak) const;

private:
    /// A texel's excess. Those of a ring around an image count too: the tent of a texel reaches over its border.
    struct Peak {
        int image = 0;
        int x = 0;
        int y = 0;
        glm::dvec3 light{0.0}; ///< excess · the tent's volume / (π · probability)
        double until = 0.0;    ///< Σ of probabilities in the row, this one's with it
    };
    struct PeakRow {
        std::size_t first = 0; ///< in m_peaks
        double until = 0.0;    ///< Σ of probabilities, this one's with it
    };

    void collect(BorderedImages& images, int image_count, double threshold);
    void finish();
    /// Direction of a point of the picture, and the solid angle of a texel there.
    struct Placed {
        glm::dvec3 direction{0.0};
        double solid_angle = 0.0;
    };
    [[nodiscard]] Placed place(const Peak& peak, double across, double down) const;

    bool m_cube = false;
    int m_width = 0;
    int m_height = 0;
    SkyTurn m_turn;
    std::vector<SineCosine> m_columns; ///< equirectangular: of the azimuth of column x, from −1 on
    std::vector<SineCosine> m_rows;    ///< of the polar angle of row y, from −1 on
    std::vector<Peak> m_peaks;
    std::vector<PeakRow> m_peak_rows;
};

} // namespace vkbake
