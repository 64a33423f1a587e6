// Half-shadows where they are known, and what is said of their noise.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "amount.hpp"
#include "lamp_scenes.hpp"

namespace vkbake {
namespace {

using test::LitFloor;
using test::pi;
using test::point_lamp;
using test::sun;
using test::with_rays;

/// What a straight edge leaves of a disc's area, at a distance of t radii from its centre: a circular segment.
double disc_beside_edge(double t) {
    const double place = std::clamp(t, -1.0, 1.0);
    return 0.5 + (place * std::sqrt(1.0 - place * place) + std::asin(place)) / pi;
}

constexpr double edge_height = 1.0;
constexpr double disc_degrees = 2.0;

/// Under a roof over x < 0 that ends in a straight edge, lit from straight above: texels across the half-shadow, and
/// the share of the disc that each sees. The edge cuts the disc's projection in an ellipse so nearly straight that it
/// matters less than 2e-4.
std::vector<double> make_half_shadow(LitFloor& floor) {
    floor.add_quad({-3.9F, 1, -3.9F}, {0, 1, -3.9F}, {0, 1, 3.9F}, {-3.9F, 1, 3.9F});
    const double sine = std::sin(0.5 * disc_degrees * pi / 180.0);
    std::vector<double> shares;
    for (int i = 0; i < 64; ++i) {
        const double x = edge_height * sine * (-1.3 + 2.6 * i / 63.0);
        floor.add_texel(x, 0.05 * (i % 13));
        shares.push_back(disc_beside_edge(x / std::hypot(x, edge_height) / sine));
    }
    return shares;
}

TEST(SoftLamps, ASoftDirectionalLampsHalfShadowIsADiscCutByALine) {
    LitFloor floor;
    const std::vector<double> shares = make_half_shadow(floor);
    const std::vector<double> found = floor.light({sun({0, -1, 0}, 2.0, disc_degrees)}, with_rays(4096));
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_NEAR(found[i], 2.0 / pi * shares[i], 2.0 / pi * 2e-3) << i;
    }
    EXPECT_EQ(found.front(), 0.0);
    EXPECT_NEAR(found.back(), 2.0 / pi, 1e-6);
}

/// Configuration factor from a plane element to a sphere of radius r at the distance d, its normal at cos θ to the
/// centre, which may lie below the horizon in part (Naylor 1967; in the form of I. Quilez, "sphere ambient occlusion").
double factor_of_sphere(double cosine, double ratio) {
    const double h = ratio * ratio; // (d / r)²
    const double k = 1.0 - h * cosine * cosine;
    if (k <= 0.0) {
        return std::max(cosine, 0.0) / h;
    }
    const double hidden =
        cosine * std::acos(std::clamp(-cosine * std::sqrt((h - 1.0) / (1.0 - cosine * cosine)), -1.0, 1.0)) -
        std::sqrt(k * (h - 1.0));
    return (hidden / h + std::atan(std::sqrt(k / (h - 1.0)))) / pi;
}

TEST(SoftLamps, ASphereGivesItsConfigurationFactor) {
    // L = I / (π r²), E/π = L F: above the horizon F = (r/d)² cos θ, the point's law.
    LitFloor floor;
    Lamp lamp = point_lamp({0, 0.5, 0});
    lamp.radius = 0.4;
    std::vector<double> expected;
    for (int i = 0; i < 30; ++i) {
        const double x = 0.1 * i;
        const double distance = std::hypot(x, 0.5);
        floor.add_texel(x, 0.0);
        expected.push_back(10.0 / (pi * 0.16) * factor_of_sphere(0.5 / distance, distance / 0.4));
        if (x == 0.0) {
            EXPECT_NEAR(expected.back(), 10.0 / 0.25 / pi, 1e-9);
        }
    }
    const std::vector<double> found = floor.light({lamp}, with_rays(1024));
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_NEAR(found[i], expected[i], 2e-3 * expected[i]) << i;
    }
    // Sunk into the floor by half: the horizon cuts it.
    lamp.position.y = 0.0;
    std::vector<double> sunk;
    LitFloor other;
    for (int i = 0; i < 20; ++i) {
        other.add_texel(0.5 + 0.1 * i, 0.0);
        sunk.push_back(10.0 / (pi * 0.16) * factor_of_sphere(0.0, (0.5 + 0.1 * i) / 0.4));
    }
    const std::vector<double> beside = other.light({lamp}, with_rays(1024));
    for (std::size_t i = 0; i < beside.size(); ++i) {
        EXPECT_NEAR(beside[i], sunk[i], 0.01 * sunk[i]) << i;
    }
}

TEST(SoftLamps, HardOnesHaveNoErrorAndSoftOnesSayTheirs) {
    LitFloor floor;
    const std::vector<double> shares = make_half_shadow(floor);
    Settings settings = with_rays(256);
    settings.estimate_error = true;
    const LightMap hard = floor.trace({sun({0, -1, 0}, 2.0)}, settings);
    EXPECT_EQ(hard.error.value().relative_rmse, 0.0);
    EXPECT_EQ(*std::ranges::max_element(hard.standard_error), 0.0F);
    double estimated = 0.0;
    double real = 0.0;
    for (std::uint64_t seed = 0; seed < test::amount<std::uint64_t>(16, 4); ++seed) {
        settings.seed = seed;
        const LightMap soft = floor.trace({sun({0, -1, 0}, 2.0, disc_degrees)}, settings);
        for (std::size_t i = 0; i < shares.size(); ++i) {
            const double miss = double{soft.image.texels[i].r} - 2.0 / pi * shares[i];
            real += miss * miss;
            estimated += double{soft.standard_error[i]} * double{soft.standard_error[i]};
        }
    }
    EXPECT_GT(real, 0.0);
    EXPECT_NEAR(std::sqrt(estimated / real), 1.0, 0.3);
}

TEST(SoftLamps, ATargetCountsTheirError) {
    LitFloor floor;
    const std::vector<double> shares = make_half_shadow(floor);
    double mean = 0.0;
    for (const double share : shares) {
        mean += 2.0 / pi * share / static_cast<double>(shares.size());
    }
    for (const double target : {0.02, 0.004}) {
        Settings settings;
        settings.target_error = target;
        const LightMap map = floor.trace({sun({0, -1, 0}, 2.0, disc_degrees)}, settings);
        EXPECT_TRUE(map.error.value().target_reached);
        double real = 0.0;
        for (std::size_t i = 0; i < shares.size(); ++i) {
            const double miss = double{map.image.texels[i].r} - 2.0 / pi * shares[i];
            real += miss * miss / static_cast<double>(shares.size());
        }
        EXPECT_LT(std::sqrt(real) / mean, 1.5 * target);
        EXPECT_GT(std::sqrt(real) / mean, 0.2 * target); // and no more rays than it takes
    }
}

} // namespace
} // namespace vkbake
