// How the error of each sampler falls with the number of rays, where the truth is known in closed form: the table of
// docs/accuracy.md.
//   vkbake_slopes
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "accuracy/measure.hpp"
#include "closed_form/configuration_factors.hpp"
#include "closed_form/hand_made.hpp"
#include "trace/tracer.hpp"
#include "vkbake/names.hpp"

namespace {

using namespace vkbake;

constexpr int side = 48; // texels

/// A floor below a white sky, of which something hides a part that is known.
struct KnownScene {
    std::string name;
    Surface surface;
    std::vector<test::SamplePoint> points;
    std::vector<double> visible;

    void add(double x, double z, double seen) {
        const std::uint32_t half_of_floor = x + z >= 0.0 ? 0 : 1;
        points.push_back({glm::vec3(x, 0.0, z), {0, 1, 0}, {0, 1, 0}, half_of_floor});
        visible.push_back(seen);
    }
};

/// The floor is the first two triangles, cut along x + z = 0.
test::SurfaceMaker floor_alone() {
    test::SurfaceMaker maker;
    maker.add_quad({-0.9F, 0, 0.9F}, {0.9F, 0, 0.9F}, {0.9F, 0, -0.9F}, {-0.9F, 0, -0.9F});
    return maker;
}

/// A square roof, turned so that its borders lie askew to all strata.
KnownScene under_a_roof() {
    KnownScene scene{.name = "under a roof"};
    constexpr double half = 0.5;
    constexpr double height = 0.1;
    const glm::dvec2 along(std::cos(0.5), std::sin(0.5));
    const glm::dvec2 across(-along.y, along.x);
    const auto corner = [&](double u, double v) {
        const glm::dvec2 place = u * along + v * across;
        return glm::vec3(place.x, height, place.y);
    };
    test::SurfaceMaker maker = floor_alone();
    maker.add_quad(corner(-half, half), corner(half, half), corner(half, -half), corner(-half, -half));
    scene.surface = maker.finish();
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            const double u = 0.3 + 0.5 * (column + 0.3) / side;
            const double v = -0.5 + 1.1 * (row + 0.6) / side;
            const glm::dvec2 place = u * along + v * across;
            const auto factor = [&](double at_u, double at_v) {
                return test::element_to_parallel_rectangle(at_u - u, at_v - v, height);
            };
            scene.add(place.x, place.y,
                      1.0 - factor(half, half) + factor(-half, half) + factor(half, -half) - factor(-half, -half));
        }
    }
    return scene;
}

/// A wall on the floor, along x = 0.
KnownScene before_a_wall() {
    KnownScene scene{.name = "before a wall"};
    constexpr double half = 0.6;
    constexpr double height = 0.3;
    test::SurfaceMaker maker = floor_alone();
    maker.add_quad({0, 0, -half}, {0, 0, half}, {0, height, half}, {0, height, -half});
    scene.surface = maker.finish();
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            const double x = 0.02 + 0.4 * (column + 0.3) / side;
            const double z = -0.5 + (row + 0.6) / side;
            scene.add(x, z,
                      1.0 - test::element_to_perpendicular_rectangle(height, half - z, x) -
                          test::element_to_perpendicular_rectangle(height, half + z, x));
        }
    }
    return scene;
}

struct Measured {
    double rmse = 0.0; ///< ÷ mean
    double bias = 0.0; ///< ÷ mean
};

Measured measured(const KnownScene& scene, Sampler sampler, std::uint32_t rays) {
    Settings settings;
    settings.sampler = sampler;
    settings.rays = rays;
    const LightMap map =
        Tracer(scene.surface, test::white_sky(), settings).trace(test::geometry_image(scene.points, side));
    double squares = 0.0;
    double off = 0.0;
    double mean = 0.0;
    const auto count = static_cast<double>(scene.visible.size());
    for (std::size_t texel = 0; texel < scene.visible.size(); ++texel) {
        const double error = static_cast<double>(map.image.texels[texel].x) - scene.visible[texel];
        squares += error * error / count;
        off += error / count;
        mean += scene.visible[texel] / count;
    }
    return {std::sqrt(squares) / mean, off / mean};
}

void print_row(const KnownScene& scene, std::string_view name, Sampler sampler) {
    if (sampler == Sampler::thesis) {
        const Measured only = measured(scene, sampler, 256);
        fmt::print("| {} | {} | | {:.2f} % | | {:+.2f} % |\n", scene.name, name, 100.0 * only.rmse, 100.0 * only.bias);
        return;
    }
    std::vector<std::pair<double, double>> errors;
    for (std::uint32_t rays = 16; rays <= 4096; rays *= 2) {
        errors.emplace_back(rays, measured(scene, sampler, rays).rmse);
    }
    const accuracy::Slope slope = accuracy::fit_slope(errors);
    constexpr double interval_95 = 2.36; // Student's t: nine points, two of them the line's
    const Measured usual = measured(scene, sampler, 256);
    fmt::print("| {} | {} | −{:.3f} ± {:.3f} | {:.3f} % | {:.3f} % | {:+.3f} % |\n", scene.name, name, -slope.value,
               interval_95 * slope.standard_error, 100.0 * usual.rmse, 100.0 * errors.back().second,
               100.0 * usual.bias);
}

} // namespace

int main() {
    fmt::print("| scene | sampler | slope | error, 256 rays | error, 4096 rays | bias, 256 rays |\n"
               "|---|---|---|---|---|---|\n");
    for (const KnownScene& scene : {under_a_roof(), before_a_wall()}) {
        for (const auto& [name, sampler] : Names<Sampler>::values) {
            print_row(scene, name, sampler);
        }
    }
    return 0;
}
