// A scene whose light is known in closed form, from nearly none to nearly all, and what errors are against it.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "configuration_factors.hpp"
#include "hand_made.hpp"
#include "trace/contrasts.hpp"
#include "trace/tracer.hpp"

namespace vkbake::test {

inline constexpr int roof_side = 64; // texels

/// A floor under a square roof at height 0.1 that is turned, so that its borders lie askew to all strata: beneath its
/// middle nearly all of the sky is hidden, beside it nearly none.
struct Roof {
    Surface surface;
    std::vector<SamplePoint> points;
    std::vector<double> visible;

    Roof() {
        SurfaceMaker maker;
        const std::uint32_t floor =
            maker.add_quad({-0.9F, 0, 0.9F}, {0.9F, 0, 0.9F}, {0.9F, 0, -0.9F}, {-0.9F, 0, -0.9F});
        constexpr double half = 0.5;
        constexpr double height = 0.1;
        const glm::dvec2 along(std::cos(0.5), std::sin(0.5)); // the roof's own axes
        const glm::dvec2 across(-along.y, along.x);
        const auto corner = [&](double u, double v) {
            const glm::dvec2 place = u * along + v * across;
            return glm::vec3(place.x, height, place.y);
        };
        maker.add_quad(corner(-half, half), corner(half, half), corner(half, -half), corner(-half, -half));
        surface = maker.finish();
        for (int row = 0; row < roof_side; ++row) {
            for (int column = 0; column < roof_side; ++column) {
                // From the roof's middle to beyond its border: texels in each tenth of visibility.
                const double u = 0.3 + 0.5 * (column + 0.3) / roof_side;
                const double v = -0.5 + 1.1 * (row + 0.6) / roof_side;
                const glm::dvec2 place = u * along + v * across;
                points.push_back({glm::vec3(place.x, 0.0, place.y), {0, 1, 0}, {0, 1, 0}, floor});
                // The factor to a rectangle with a corner overhead is odd in both sides, so four of them add up to any.
                const auto factor = [&](double at_u, double at_v) {
                    return element_to_parallel_rectangle(at_u - u, at_v - v, height);
                };
                visible.push_back(1.0 - factor(half, half) + factor(-half, half) + factor(half, -half) -
                                  factor(-half, -half));
            }
        }
    }

    [[nodiscard]] LightMap trace(const Settings& settings, const MapFilter& filter = {}) const {
        return Tracer(surface, white_sky(), settings).trace(geometry_image(points, roof_side), {}, {}, filter);
    }
    [[nodiscard]] double mean() const {
        double sum = 0.0;
        for (const double value : visible) {
            sum += value / static_cast<double>(visible.size());
        }
        return sum;
    }
};

struct Errors {
    double relative_rmse = 0.0;
    double bias = 0.0; ///< relative
};

inline Errors errors_of(const LightMap& map, const Roof& roof) {
    double squares = 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < roof.visible.size(); ++i) {
        const double off = static_cast<double>(map.image.texels[i].x) - roof.visible[i];
        squares += off * off;
        sum += off;
    }
    const auto count = static_cast<double>(roof.visible.size());
    return {std::sqrt(squares / count) / roof.mean(), sum / count / roof.mean()};
}

/// By tenth of true visibility, how many texels there were and how many had the truth in their interval.
struct VisibilityTally {
    std::array<int, 10> texels{};
    std::array<int, 10> right{};

    void add(const LightMap& map, const Roof& roof) {
        for (std::size_t i = 0; i < roof.visible.size(); ++i) {
            if (roof.visible[i] < 0.02 || roof.visible[i] > 0.98) {
                continue;
            }
            const auto tenth = static_cast<std::size_t>(10.0 * roof.visible[i]);
            const double off = std::abs(static_cast<double>(map.image.texels[i].x) - roof.visible[i]);
            ++texels[tenth];
            right[tenth] += off <= interval_95 * static_cast<double>(map.standard_error[i]) ? 1 : 0;
        }
    }
    [[nodiscard]] double share(std::size_t tenth) const {
        return static_cast<double>(right[tenth]) / static_cast<double>(texels[tenth]);
    }
};

} // namespace vkbake::test
