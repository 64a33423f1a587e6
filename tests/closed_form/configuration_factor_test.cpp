// Light maps under a white sky against configuration factors: what a shape covers of the hemisphere is what it takes
// away.
#include "configuration_factors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "hand_made.hpp"
#include "statistics.hpp"
#include "trace/tracer.hpp"

namespace vkbake {
namespace {

using test::white_sky;

std::vector<double> traced(const Surface& surface, const std::vector<test::SamplePoint>& points,
                           const Settings& settings) {
    const LightMap map = Tracer(surface, white_sky(), settings).trace(test::geometry_image(points, 64));
    std::vector<double> values;
    for (std::size_t i = 0; i < points.size(); ++i) {
        values.push_back(static_cast<double>(map.image.texels[i].x));
    }
    return values;
}

/// 1 − factor is expected; `repeats` texels of their own scrambles at one place. A (0, 2)-sequence's scatter is at most
/// √e times that of independent rays (Owen 1997, "Monte Carlo variance of scrambled net quadrature").
void expect_factor(const std::vector<double>& values, double factor, double rays, double slack = 0.0) {
    const test::MeanEstimate found = test::estimate_mean(values);
    EXPECT_NEAR(1.0 - found.mean, factor, test::allowed_errors * found.standard_error + slack);
    EXPECT_LE(found.standard_deviation, 1.2 * std::sqrt(std::exp(1.0) * factor * (1.0 - factor) / rays) + 1e-9);
}

TEST(ConfigurationFactors, AgreeWithTheirDefinitionSummedUp) {
    // Σ cos θ₁ cos θ₂ / (π r²) dA by the midpoint rule.
    constexpr int steps = 600;
    double parallel = 0.0;
    double perpendicular = 0.0;
    for (int i = 0; i < steps; ++i) {
        for (int j = 0; j < steps; ++j) {
            const double x = (i + 0.5) / steps * 0.7;
            const double y = (j + 0.5) / steps * 1.3;
            const double area = 0.7 * 1.3 / (steps * steps);
            const double square = x * x + y * y + 0.5 * 0.5;
            parallel += 0.5 * 0.5 / (std::numbers::pi * square * square) * area;
            // The wall: x high, y wide, 0.5 away.
            perpendicular += x * 0.5 / (std::numbers::pi * square * square) * area;
        }
    }
    EXPECT_NEAR(test::element_to_parallel_rectangle(0.7, 1.3, 0.5), parallel, 1e-6);
    EXPECT_NEAR(test::element_to_perpendicular_rectangle(0.7, 1.3, 0.5), perpendicular, 1e-6);
    double squares = 0.0;
    for (int i = 0; i < steps; ++i) {
        for (int j = 0; j < steps; ++j) {
            const double x = (i + 0.5) / steps;
            const double y = (j + 0.5) / steps;
            squares += 4.0 * test::element_to_parallel_rectangle(x, y, 0.8) / (steps * steps);
        }
    }
    // Over all places of the element, the rectangle to its lower left takes in each quarter alike.
    EXPECT_NEAR(test::square_to_opposed_square(1.0 / 0.8), squares, 1e-5);
    EXPECT_NEAR(test::square_to_opposed_square(1.0), 0.199825, 1e-6); // tabulated
}

TEST(Occlusion, FloorBesideALongWall) {
    test::SurfaceMaker maker;
    const std::uint32_t floor = maker.add_quad({-0.9F, 0, 0.9F}, {0.9F, 0, 0.9F}, {0.9F, 0, -0.9F}, {-0.9F, 0, -0.9F});
    maker.add_quad({0, 0, 0.9F}, {0, 0.25F, 0.9F}, {0, 0.25F, -0.9F}, {0, 0, -0.9F});
    const Surface surface = maker.finish();
    Settings settings;
    settings.rays = 256;
    for (const double distance : {0.002, 0.02, 0.1, 0.25, 0.6}) {
        SCOPED_TRACE(distance);
        for (const double along : {0.0, 0.5}) {
            const glm::vec3 up(0, 1, 0);
            const std::vector<test::SamplePoint> points(
                256, {{static_cast<float>(distance), 0, static_cast<float>(along)}, up, up, floor});
            const double factor = test::element_to_perpendicular_rectangle(0.25, 0.9 - along, distance) +
                                  test::element_to_perpendicular_rectangle(0.25, 0.9 + along, distance);
            expect_factor(traced(surface, points, settings), factor, 256);
        }
    }
}

TEST(Occlusion, SquareOnAParallelSquare) {
    constexpr double side = 0.8;
    constexpr double distance = 0.6;
    const auto half = static_cast<float>(side / 2);
    const auto height = static_cast<float>(distance);
    test::SurfaceMaker maker;
    maker.add_quad({-half, 0, half}, {half, 0, half}, {half, 0, -half}, {-half, 0, -half});
    maker.add_quad({-half, height, half}, {half, height, half}, {half, height, -half}, {-half, height, -half});
    const Surface surface = maker.finish();
    constexpr int size = 64;
    std::vector<test::SamplePoint> points;
    std::vector<double> factors;
    double mean_factor = 0.0;
    for (int j = 0; j < size; ++j) {
        for (int i = 0; i < size; ++i) {
            const double x = (i + 0.5) / size * side;
            const double z = (j + 0.5) / size * side;
            const glm::vec3 up(0, 1, 0);
            // The quad's first triangle has its right angle at (+, +), below the diagonal from (−, +) to (+, −).
            const std::uint32_t triangle = x + z > side ? 0U : 1U;
            points.push_back(
                {{static_cast<float>(x - side / 2), 0, static_cast<float>(z - side / 2)}, up, up, triangle});
            double factor = 0.0;
            for (const double a : {x, side - x}) {
                for (const double b : {z, side - z}) {
                    factor += test::element_to_parallel_rectangle(a, b, distance);
                }
            }
            factors.push_back(factor);
            mean_factor += factor / (size * size);
        }
    }
    // The mean over texel centres is the factor from square to square but for the midpoint rule's error.
    EXPECT_NEAR(mean_factor, test::square_to_opposed_square(side / distance), 3e-5);

    Settings settings;
    const std::vector<double> values = traced(surface, points, settings);
    std::vector<double> errors;
    for (std::size_t i = 0; i < values.size(); ++i) {
        errors.push_back(1.0 - values[i] - factors[i]);
    }
    const test::MeanEstimate error = test::estimate_mean(errors);
    EXPECT_NEAR(error.mean, 0.0, test::allowed_errors * error.standard_error);
    EXPECT_LT(error.standard_deviation, std::sqrt(0.25 / settings.rays));
}

/// A sphere of triangles with its corners on the radius; returns the radius of the largest sphere inside it.
double add_sphere(test::SurfaceMaker& maker, const glm::dvec3& centre, double radius, int divisions) {
    std::array<glm::dvec3, 6> tips{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};
    constexpr std::array<std::array<std::size_t, 3>, 8> faces{
        {{0, 1, 2}, {0, 2, 4}, {0, 4, 5}, {0, 5, 1}, {3, 2, 1}, {3, 4, 2}, {3, 5, 4}, {3, 1, 5}}};
    double inner = radius;
    const auto place = [&](const glm::dvec3& direction) {
        return glm::vec3(centre + radius * glm::normalize(direction));
    };
    const auto add = [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
        const glm::dvec3 corner = place(a);
        const glm::dvec3 normal =
            glm::normalize(glm::cross(glm::dvec3(place(b)) - corner, glm::dvec3(place(c)) - corner));
        inner = std::min(inner, glm::dot(normal, corner - centre));
        maker.add(place(a), place(b), place(c));
    };
    for (const auto& face : faces) {
        const auto point = [&](int i, int j) {
            return (tips[face[0]] * static_cast<double>(divisions - i - j) + tips[face[1]] * static_cast<double>(i) +
                    tips[face[2]] * static_cast<double>(j)) /
                   static_cast<double>(divisions);
        };
        for (int i = 0; i < divisions; ++i) {
            for (int j = 0; i + j < divisions; ++j) {
                add(point(i, j), point(i + 1, j), point(i, j + 1));
                if (i + j + 2 <= divisions) {
                    add(point(i + 1, j), point(i + 1, j + 1), point(i, j + 1));
                }
            }
        }
    }
    return inner;
}

TEST(Occlusion, SphereAboveAPlane) {
    test::SurfaceMaker maker;
    const std::uint32_t floor = maker.add_quad({-0.9F, 0, 0.9F}, {0.9F, 0, 0.9F}, {0.9F, 0, -0.9F}, {-0.9F, 0, -0.9F});
    constexpr double radius = 0.3;
    constexpr double height = 0.45;
    const double inner = add_sphere(maker, {0.0, height, 0.0}, radius, 40);
    ASSERT_GT(inner, 0.998 * radius);
    const Surface surface = maker.finish();
    for (const double aside : {0.05, 0.3, 0.7}) {
        SCOPED_TRACE(aside);
        const glm::vec3 up(0, 1, 0);
        const std::vector<test::SamplePoint> points(512, {{static_cast<float>(aside), 0, 0.03F}, up, up, floor});
        const double distance = std::sqrt(aside * aside + 0.03 * 0.03 + height * height);
        // The triangles lie between two spheres, so the factor does: hold it against the middle.
        const double outer_factor = test::element_to_sphere(radius, distance, height / distance);
        const double inner_factor = test::element_to_sphere(inner, distance, height / distance);
        expect_factor(traced(surface, points, {}), 0.5 * (outer_factor + inner_factor), 256,
                      0.5 * (outer_factor - inner_factor));
    }
}

/// A floor in the bake frame, and over it a wide ceiling that is 2 m high: one unit is 8 m.
struct UnderACeiling {
    Surface surface;
    std::vector<test::SamplePoint> points;

    UnderACeiling() {
        test::SurfaceMaker maker;
        const std::uint32_t floor =
            maker.add_quad({-0.2F, 0, 0.2F}, {0.2F, 0, 0.2F}, {0.2F, 0, -0.2F}, {-0.2F, 0, -0.2F});
        maker.add_quad({-0.9F, 0.25F, 0.9F}, {0.9F, 0.25F, 0.9F}, {0.9F, 0.25F, -0.9F}, {-0.9F, 0.25F, -0.9F});
        surface = maker.finish(-3);
        const glm::vec3 up(0, 1, 0);
        points.assign(256, {{0.01F, 0, 0.03F}, up, up, floor});
    }
};

/// Under a ceiling so wide that the limit never passes its border, a ray of length D meets it where cos θ > H / D; what
/// is left has the cosine-weighted share (H / D)².
TEST(Occlusion, DistanceLimitUnderACeiling) {
    const auto [surface, points] = UnderACeiling();
    Settings settings;
    settings.mode = Mode::ao;
    for (const double limit : {2.5, 4.0, 6.0}) {
        SCOPED_TRACE(limit);
        settings.ao_distance = limit;
        expect_factor(traced(surface, points, settings), 1.0 - (2.0 / limit) * (2.0 / limit), 256, 3e-6);
    }
    settings.ao_distance = 1.99;
    for (const double value : traced(surface, points, settings)) {
        EXPECT_EQ(value, 1.0);
    }
    settings.ao_distance.reset();
    double everything = 0.0;
    for (const double a : {0.9 - 0.01, 0.9 + 0.01}) {
        for (const double b : {0.9 - 0.03, 0.9 + 0.03}) {
            everything += test::element_to_parallel_rectangle(a, b, 0.25);
        }
    }
    expect_factor(traced(surface, points, settings), everything, 256, 3e-6);
}

/// Where it meets the ceiling it has gone H / cos θ. With k = H / D, what is hidden is ∫ 2 c (1 − k / c) dc from k to
/// 1, (1 − k)², or that of the square, 1 − 4 k + 3 k² − 2 k² ln k.
TEST(Occlusion, FallsOffWithDistanceUnderACeiling) {
    const auto [surface, points] = UnderACeiling();
    Settings settings;
    settings.mode = Mode::ao;
    for (const double limit : {2.5, 4.0, 6.0}) {
        SCOPED_TRACE(limit);
        const double k = 2.0 / limit;
        settings.ao_distance = limit;
        settings.ao_falloff = Falloff::linear;
        expect_factor(traced(surface, points, settings), (1.0 - k) * (1.0 - k), 256, 3e-6);
        settings.ao_falloff = Falloff::square;
        expect_factor(traced(surface, points, settings), 1.0 - 4.0 * k + 3.0 * k * k - 2.0 * k * k * std::log(k), 256,
                      3e-6);
    }
    settings.ao_distance = 1.99;
    for (const double value : traced(surface, points, settings)) {
        EXPECT_EQ(value, 1.0);
    }
}

} // namespace
} // namespace vkbake
