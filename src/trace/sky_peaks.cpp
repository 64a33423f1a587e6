#include "trace/sky_peaks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <locale>
#include <numbers>
#include <sstream>
#include <variant>

#include <glm/geometric.hpp>

#include "base/luminance.hpp"

namespace vkbake {

namespace {

constexpr int least_width = 16; ///< texels: no tent reaches over more than 22.5° on either side

SineCosine azimuth(double x, int width) { return sine_cosine_degrees(360.0 * ((x + 0.5) / width - 0.5)); }

SineCosine polar_angle(double y, int height) { return sine_cosine_degrees(180.0 * (y + 0.5) / height); }

SineCosine turned(const SineCosine& from, const SineCosine& by) {
    return {from.sine * by.cosine + from.cosine * by.sine, from.cosine * by.cosine - from.sine * by.sine};
}

/// Of a texel, where the cosine to its image's axis is what its place says: dω = dA / |d|³.
double cube_solid_angle(double x, double y, int size) {
    const double a = 2.0 * (x + 0.5) / size - 1.0;
    const double b = 2.0 * (y + 0.5) / size - 1.0;
    const double square = 1.0 + a * a + b * b;
    return 4.0 / (static_cast<double>(size) * size) / (square * std::sqrt(square));
}

double panorama_solid_angle(double sine, int width, int height) {
    return 2.0 * std::numbers::pi / width * (std::numbers::pi / height) * sine;
}

// The tent 1 − |t| and its distribution over [−1, 1].
double tent_until(double t) { return t < 0.0 ? 0.5 * (1.0 + t) * (1.0 + t) : 1.0 - 0.5 * (1.0 - t) * (1.0 - t); }

double tent_at(double share) { return share < 0.5 ? std::sqrt(2.0 * share) - 1.0 : 1.0 - std::sqrt(2.0 - 2.0 * share); }

/// The part of a texel's tent along an axis that lies in its image.
struct Clipped {
    Clipped(int place, int size)
        : low(tent_until(std::max(-1.0, -0.5 - place))), high(tent_until(std::min(1.0, size - 0.5 - place))) {}
    [[nodiscard]] double mass() const { return high - low; }
    [[nodiscard]] double at(double share) const { return tent_at(low + share * (high - low)); }
    double low, high;
};

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
            const double solid_angle = panorama_solid_angle(polar_angle(y, height).sine, width, height);
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

SkyPeaks::SkyPeaks(SkyLookup& sky, double threshold) {
    if (auto* const panorama = std::get_if<EquirectangularLookup>(&sky)) {
        m_width = panorama->image.width();
        m_height = panorama->image.height();
        m_turn = panorama->turn;
        for (int x = -1; x <= m_width; ++x) {
            m_columns.push_back(azimuth(x, m_width));
        }
        for (int y = -1; y <= m_height; ++y) {
            m_rows.push_back(polar_angle(y, m_height));
        }
        collect(panorama->image, 1, threshold);
    } else if (auto* const cube = std::get_if<CubeLookup>(&sky)) {
        m_cube = true;
        m_width = m_height = cube->faces.width();
        m_turn = cube->turn;
        collect(cube->faces, 6, threshold);
    }
    finish();
}

void SkyPeaks::collect(BorderedImages& images, int image_count, double threshold) {
    for (int image = 0; image < image_count; ++image) {
        for (int y = -1; y <= m_height; ++y) {
            const std::size_t first = m_peaks.size();
            for (int x = -1; x <= m_width; ++x) {
                glm::vec3& texel = images.at(image, x, y);
                const double bright = luminance(glm::dvec3(texel));
                if (bright > threshold) {
                    const glm::vec3 rest = packed_below(glm::vec3(glm::dvec3(texel) * (threshold / bright)));
                    m_peaks.push_back({image, x, y, glm::dvec3(texel) - glm::dvec3(rest)});
                    texel = rest;
                }
            }
            if (m_peaks.size() > first) {
                m_peak_rows.push_back({first});
            }
        }
    }
}

void SkyPeaks::finish() {
    std::vector<double> powers;
    double all = 0.0;
    for (const Peak& peak : m_peaks) {
        const Clipped across(peak.x, m_width);
        const Clipped down(peak.y, m_height);
        const double volume = across.mass() * down.mass();
        // A ring's texels are met beside the border, not at their own centres; poles included.
        const double solid_angle = place(peak, across.at(0.5), down.at(0.5)).solid_angle;
        powers.push_back(luminance(peak.light) * volume * std::max(solid_angle, 0.0));
        all += powers.back();
    }
    double until = 0.0;
    for (std::size_t row = 0; row < m_peak_rows.size(); ++row) {
        const std::size_t end = row + 1 < m_peak_rows.size() ? m_peak_rows[row + 1].first : m_peaks.size();
        double in_row = 0.0;
        for (std::size_t i = m_peak_rows[row].first; i < end; ++i) {
            Peak& peak = m_peaks[i];
            const double probability = powers[i] / all;
            const double volume = Clipped(peak.x, m_width).mass() * Clipped(peak.y, m_height).mass();
            in_row += probability;
            peak.until = in_row;
            peak.light *= volume / (std::numbers::pi * probability);
        }
        until += in_row;
        m_peak_rows[row].until = until;
    }
    m_peak_rows.back().until = 1.0; // whatever rounding has left
}

double SkyPeaks::probability(std::size_t peak) const {
    const bool begins =
        std::any_of(m_peak_rows.begin(), m_peak_rows.end(), [&](const PeakRow& row) { return row.first == peak; });
    return m_peaks[peak].until - (begins ? 0.0 : m_peaks[peak - 1].until);
}

SkyPeaks::Placed SkyPeaks::place(const Peak& peak, double across, double down) const {
    if (m_cube) {
        const double x = peak.x + across;
        const double y = peak.y + down;
        const glm::dvec3 direction = cube_direction(peak.image, (x + 0.5) / m_width, (y + 0.5) / m_width);
        return {glm::normalize(direction), cube_solid_angle(x, y, m_width)};
    }
    // From the texel's centre by no more than a texel: short polynomials do for that.
    const auto around = turned(m_columns[static_cast<std::size_t>(std::int64_t{peak.x} + 1)],
                               sine_cosine(across * (2.0 * std::numbers::pi / m_width)));
    const auto polar = turned(m_rows[static_cast<std::size_t>(std::int64_t{peak.y} + 1)],
                              sine_cosine(down * (std::numbers::pi / m_height)));
    return {{polar.sine * around.cosine, polar.cosine, polar.sine * around.sine},
            panorama_solid_angle(polar.sine, m_width, m_height)};
}

SkyPeaks::Sample SkyPeaks::sample(double u, double v) const {
    const auto row = std::upper_bound(m_peak_rows.begin(), m_peak_rows.end() - 1, v,
                                      [](double value, const PeakRow& some) { return value < some.until; });
    const double before = row == m_peak_rows.begin() ? 0.0 : (row - 1)->until;
    const auto first = m_peaks.begin() + static_cast<std::ptrdiff_t>(row->first);
    const auto end =
        row + 1 == m_peak_rows.end() ? m_peaks.end() : m_peaks.begin() + static_cast<std::ptrdiff_t>((row + 1)->first);
    const double target = u * (end - 1)->until;
    const auto peak =
        std::upper_bound(first, end - 1, target, [](double value, const Peak& some) { return value < some.until; });
    const double in_row = peak == first ? 0.0 : (peak - 1)->until;
    const double left_u = std::clamp((target - in_row) / (peak->until - in_row), 0.0, 1.0);
    const double left_v = std::clamp((v - before) / (row->until - before), 0.0, 1.0);
    const Placed placed = place(*peak, Clipped(peak->x, m_width).at(left_u), Clipped(peak->y, m_height).at(left_v));
    const glm::dvec3& d = placed.direction;
    const auto sine = static_cast<double>(m_turn.sine);
    const auto cosine = static_cast<double>(m_turn.cosine);
    return {.direction = glm::vec3(d.x * cosine + d.z * sine, d.y, d.z * cosine - d.x * sine),
            .light = glm::vec3(peak->light * placed.solid_angle),
            .peak = static_cast<std::size_t>(peak - m_peaks.begin())};
}

} // namespace vkbake
