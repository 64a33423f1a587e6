#include "trace/sky_peaks.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <span>
#include <variant>

#include "base/luminance.hpp"
#include "trace/sky_solid_angle.hpp"

namespace vkbake {

namespace {

constexpr double choice_steps = 0x1p24;

/// The distribution of the tent 1 − |t| over [−1, 1].
double tent_until(double t) { return t < 0.0 ? 0.5 * (1.0 + t) * (1.0 + t) : 1.0 - 0.5 * (1.0 - t) * (1.0 - t); }

/// The part of a texel's tent along an axis that lies in its image.
struct Clipped {
    Clipped(int place, int size)
        : low(tent_until(std::max(-1.0, -0.5 - place))), mass(tent_until(std::min(1.0, size - 0.5 - place)) - low) {}
    /// Halfway through what is left of the tent.
    [[nodiscard]] double middle() const {
        const double share = low + 0.5 * mass;
        return share < 0.5 ? std::sqrt(2.0 * share) - 1.0 : 1.0 - std::sqrt(2.0 - 2.0 * share);
    }
    double low, mass;
};

/// Whole steps, `choice_steps` in all and one at least of each, as near to the powers' shares as that allows.
std::vector<double> steps_of(std::span<const double> powers) {
    double all = 0.0;
    for (const double power : powers) {
        all += power;
    }
    const double free = choice_steps - static_cast<double>(powers.size());
    std::vector<double> steps;
    double left = free;
    for (const double power : powers) {
        steps.push_back(1.0 + std::floor(free * (power / all)));
        left -= steps.back() - 1.0;
    }
    steps[static_cast<std::size_t>(std::max_element(powers.begin(), powers.end()) - powers.begin())] += left;
    return steps;
}

/// The options of one choice, side by side.
std::vector<SkyPeaks::Option> options_of(std::span<const double> steps) {
    std::vector<SkyPeaks::Option> options;
    double begin = -1.0;
    for (const double step : steps) {
        const double end = begin + step * (2.0 / choice_steps);
        SkyPeaks::Option& option = options.emplace_back();
        option.begin = static_cast<float>(begin);
        option.end = static_cast<float>(end);
        begin = end;
    }
    return options;
}

SkyPeaks::Guides append_guides(std::span<const SkyPeaks::Option> options, std::vector<std::int32_t>& guides) {
    const auto bits = static_cast<unsigned>(std::bit_width(options.size() - 1));
    const SkyPeaks::Guides result{static_cast<std::int32_t>(guides.size()), static_cast<std::int32_t>(25U - bits)};
    const std::size_t parts = std::size_t{1} << bits;
    std::int32_t option = 0;
    for (std::size_t part = 0; part < parts; ++part) {
        const auto begin = 2.0F * static_cast<float>(part) / static_cast<float>(parts) - 1.0F;
        while (options[static_cast<std::size_t>(option)].end <= begin) {
            ++option;
        }
        guides.push_back(option);
    }
    guides.push_back(static_cast<std::int32_t>(options.size() - 1));
    return result;
}

/// Whether anything is clipped off.
bool clip(const Clipped& clipped, SkyPeaks::Option& option) {
    option.tent_low = static_cast<float>(clipped.low);
    option.tent_mass = static_cast<float>(clipped.mass);
    return clipped.mass < 1.0;
}

double polar_degrees(double y, int height) { return 180.0 * (y + 0.5) / height; }

float cube_coordinate(int place, int size) { return static_cast<float>((2.0 * place + 1.0) / size - 1.0); }

} // namespace

SkyPeaks::SkyPeaks(SkyLookup& sky, double threshold) {
    std::vector<Excess> excess;
    if (auto* const panorama = std::get_if<EquirectangularLookup>(&sky)) {
        m_width = panorama->image.width();
        m_height = panorama->image.height();
        m_turn = panorama->turn;
        excess = cut(panorama->image, 1, threshold);
    } else if (auto* const cube = std::get_if<CubeLookup>(&sky)) {
        m_cube = true;
        m_width = m_height = cube->faces.width();
        m_turn = cube->turn;
        excess = cut(cube->faces, 6, threshold);
        place_faces(cube->turn);
    }
    add_rows(excess);
    add_peaks(excess);
}

std::vector<SkyPeaks::Excess> SkyPeaks::cut(BorderedImages& images, int image_count, double threshold) const {
    std::vector<Excess> result;
    for (int image = 0; image < image_count; ++image) {
        for (int y = -1; y <= m_height; ++y) {
            for (int x = -1; x <= m_width; ++x) {
                glm::vec3& texel = images.at(image, x, y);
                const double bright = luminance(glm::dvec3(texel));
                if (bright > threshold) {
                    const glm::vec3 rest = packed_below(glm::vec3(glm::dvec3(texel) * (threshold / bright)));
                    result.push_back({image, x, y, glm::dvec3(texel) - glm::dvec3(rest)});
                    result.back().power = power(result.back());
                    texel = rest;
                }
            }
        }
    }
    return result;
}

double SkyPeaks::power(const Excess& excess) const {
    const Clipped across(excess.x, m_width);
    const Clipped down(excess.y, m_height);
    // A ring's texels are met beside the border, not at their own centres; poles included.
    const double x = excess.x + across.middle();
    const double y = excess.y + down.middle();
    const double solid_angle =
        m_cube ? cube_solid_angle(x, y, m_width)
               : panorama_solid_angle(sine_cosine_degrees(polar_degrees(y, m_height)).sine, m_width, m_height);
    return luminance(excess.light) * across.mass * down.mass * std::max(solid_angle, 0.0);
}

void SkyPeaks::add_rows(const std::vector<Excess>& excess) {
    std::vector<double> powers;
    for (std::size_t i = 0; i < excess.size(); ++i) {
        if (i == 0 || excess[i].y != excess[i - 1].y || excess[i].image != excess[i - 1].image) {
            Row& row = m_rows.emplace_back();
            row.first = static_cast<std::int32_t>(i);
            row.image = excess[i].image;
            const SineCosine polar = sine_cosine_degrees(polar_degrees(excess[i].y, m_height));
            row.cosine = m_cube ? cube_coordinate(excess[i].y, m_height) : static_cast<float>(polar.cosine);
            row.sine = m_cube ? 0.0F : static_cast<float>(polar.sine);
            powers.push_back(0.0);
        }
        powers.back() += excess[i].power;
    }
    const std::vector<double> steps = steps_of(powers);
    const std::vector<Option> options = options_of(steps);
    m_guides_of_rows = append_guides(options, m_row_guides);
    for (std::size_t row = 0; row < m_rows.size(); ++row) {
        m_rows[row].option = options[row];
        const Clipped down(excess[static_cast<std::size_t>(m_rows[row].first)].y, m_height);
        m_clips = clip(down, m_rows[row].option) || m_clips;
        const std::size_t end =
            row + 1 < m_rows.size() ? static_cast<std::size_t>(m_rows[row + 1].first) : excess.size();
        m_probabilities.resize(end, steps[row] / choice_steps);
    }
}

void SkyPeaks::add_peaks(const std::vector<Excess>& excess) {
    const auto sine = static_cast<double>(m_turn.sine);
    const auto cosine = static_cast<double>(m_turn.cosine);
    for (std::size_t number = 0; number < m_rows.size(); ++number) {
        Row& row = m_rows[number];
        const auto first = static_cast<std::size_t>(row.first);
        const std::size_t end =
            number + 1 < m_rows.size() ? static_cast<std::size_t>(m_rows[number + 1].first) : excess.size();
        const std::span<const Excess> in_row(&excess[first], end - first);
        std::vector<double> powers;
        for (const Excess& some : in_row) {
            powers.push_back(some.power);
        }
        const std::vector<double> steps = steps_of(powers);
        const std::vector<Option> options = options_of(steps);
        row.guides = append_guides(options, m_peak_guides);
        for (std::size_t i = 0; i < in_row.size(); ++i) {
            double& probability = m_probabilities[m_peaks.size()];
            probability *= steps[i] / choice_steps;
            const Clipped across(in_row[i].x, m_width);
            const double volume = across.mass * static_cast<double>(row.option.tent_mass);
            // The sky's turn is in it: (x, z) → (x cos + z sin, z cos − x sin) takes the turn from the azimuth.
            const SineCosine azimuth = sine_cosine_degrees(360.0 * ((in_row[i].x + 0.5) / m_width - 0.5));
            const glm::vec3 light(in_row[i].light * (volume / (std::numbers::pi * probability)));
            Peak& peak = m_peaks.emplace_back();
            peak.option = options[i];
            m_clips = clip(across, peak.option) || m_clips;
            peak.cosine = m_cube ? cube_coordinate(in_row[i].x, m_width)
                                 : static_cast<float>(azimuth.cosine * cosine + azimuth.sine * sine);
            peak.sine = m_cube ? 0.0F : static_cast<float>(azimuth.sine * cosine - azimuth.cosine * sine);
            peak.light = {light.x, light.y, light.z};
        }
    }
}

void SkyPeaks::place_faces(const SkyTurn& turn) {
    const auto turned = [&](const glm::dvec3& d) {
        const auto sine = static_cast<double>(turn.sine);
        const auto cosine = static_cast<double>(turn.cosine);
        return glm::vec3(d.x * cosine + d.z * sine, d.y, d.z * cosine - d.x * sine);
    };
    for (std::size_t number = 0; number < m_faces.size(); ++number) {
        const auto face = static_cast<int>(number);
        const glm::dvec3 axis = cube_direction(face, 0.5, 0.5);
        m_faces[number] = {turned(axis), turned(cube_direction(face, 1.0, 0.5) - axis),
                           turned(cube_direction(face, 0.5, 1.0) - axis)};
    }
}

} // namespace vkbake
