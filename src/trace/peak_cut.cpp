#include "trace/peak_cut.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <locale>
#include <sstream>
#include <variant>

#include "base/luminance.hpp"
#include "trace/sky_solid_angle.hpp"

namespace vkbake {

namespace {

constexpr int least_width = 16; ///< texels: no tent reaches over more than 22.5° on either side

/// Of a sky's luminance, in steps of a quarter of an octave.
class Histogram {
public:
    void add(double value, double solid_angle) {
        m_whole.solid_angle += solid_angle;
        m_whole.sum += solid_angle * value;
        m_whole.squares += solid_angle * value * value;
        if (value > 0.0) {
            Step& step = m_steps[step_of(value)];
            step.solid_angle += solid_angle;
            step.sum += solid_angle * value;
            step.squares += solid_angle * value * value;
        }
    }

    [[nodiscard]] PeakCut best_cut() const {
        const double all = m_whole.solid_angle;
        const double mean = m_whole.sum / all;
        PeakCut best{.variance_uncut = half_hidden(m_whole.squares / all, mean)};
        best.variance = best.variance_uncut;
        Step above;
        for (std::size_t step = m_steps.size(); step-- > 1;) {
            above.solid_angle += m_steps[step].solid_angle;
            above.sum += m_steps[step].sum;
            above.squares += m_steps[step].squares;
            const double threshold = least_of(step);
            if (threshold <= mean || above.sum == 0.0) {
                continue;
            }
            const double peaks = (above.sum - threshold * above.solid_angle) / all;
            const double rest = mean - peaks;
            const double squares = (m_whole.squares - above.squares + threshold * threshold * above.solid_angle) / all;
            const double variance = half_hidden(squares, rest) + half_hidden(peaks * peaks, peaks);
            if (variance < best.variance) {
                best = {threshold, peaks / mean, above.solid_angle / all, variance, best.variance_uncut};
            }
        }
        return best;
    }

private:
    struct Step {
        double solid_angle = 0.0;
        double sum = 0.0;
        double squares = 0.0;
    };
    static constexpr int octaves = 300; ///< floats' and more
    static constexpr std::array<double, 4> quarters{0.5, 0.59460355750136051, 0.70710678118654757, 0.84089641525371450};

    /// The variance of what has this mean and this mean square where every second ray is blocked.
    static double half_hidden(double squares, double mean) { return 0.5 * squares - 0.25 * mean * mean; }
    static std::size_t step_of(double value) {
        int octave = 0;
        const double share = std::frexp(value, &octave);
        const auto quarter = std::upper_bound(quarters.begin(), quarters.end(), share) - quarters.begin() - 1;
        return static_cast<std::size_t>(4 * std::clamp(octave + octaves / 2, 0, octaves - 1) + quarter);
    }
    static double least_of(std::size_t step) {
        return std::ldexp(quarters[step % 4], static_cast<int>(step / 4) - octaves / 2);
    }

    Step m_whole;
    std::array<Step, 4 * octaves> m_steps{};
};

struct Measure {
    PeakCut operator()(const EquirectangularLookup& sky) const {
        const int width = sky.image.width();
        const int height = sky.image.height();
        Histogram histogram;
        if (width < least_width || 2 * height < least_width) {
            return {};
        }
        for (int y = 0; y < height; ++y) {
            const double solid_angle =
                panorama_solid_angle(sine_cosine_degrees(180.0 * (y + 0.5) / height).sine, width, height);
            for (int x = 0; x < width; ++x) {
                histogram.add(luminance(glm::dvec3(sky.image.at(0, x, y))), solid_angle);
            }
        }
        return histogram.best_cut();
    }
    PeakCut operator()(const CubeLookup& sky) const {
        const int size = sky.faces.width();
        Histogram histogram;
        for (int face = 0; face < 6; ++face) {
            for (int y = 0; y < size; ++y) {
                for (int x = 0; x < size; ++x) {
                    histogram.add(luminance(glm::dvec3(sky.faces.at(face, x, y))), cube_solid_angle(x, y, size));
                }
            }
        }
        return 4 * size >= least_width ? histogram.best_cut() : PeakCut();
    }
    template<class Formula>
    PeakCut operator()(const Formula& /*sky*/) const {
        return {};
    }
};

} // namespace

PeakCut find_peaks(const SkyLookup& sky) { return std::visit(Measure(), sky); }

std::string describe(const PeakCut& cut) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(2);
    text << 100.0 * cut.light_share << " % of the sky's light comes from " << 100.0 * cut.solid_share
         << " % of its solid angle";
    return text.str();
}

} // namespace vkbake
