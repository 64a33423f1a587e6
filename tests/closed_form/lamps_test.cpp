// Lamps where their light is known: the laws of a point, a cone, a disc and a sphere.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "amount.hpp"
#include "bounces.hpp"
#include "hand_made.hpp"
#include "highway_targets.hpp"
#include "host_bake.hpp"
#include "same_bits.hpp"
#include "stage_clock.hpp"
#include "trace/tracer.hpp"
#include "vkbake/error.hpp"

namespace vkbake {
namespace {

constexpr double pi = std::numbers::pi;
/// The scenes here are 8 m wide: bake-frame coordinates times this are metres.
constexpr float metres = 4.0F;
constexpr int exponent = -2;

Sky black_sky() { return test::constant_sky(glm::vec3(0.0F)); }

Lamp point_lamp(const glm::dvec3& position, double candela = 10.0) {
    return {.name = "point", .intensity = candela, .position = position};
}

Lamp spot_lamp(const glm::dvec3& position, const glm::dvec3& direction, double inner, double outer) {
    return {.name = "spot",
            .kind = LampKind::spot,
            .intensity = 10.0,
            .position = position,
            .direction = glm::normalize(direction),
            .inner_cone = inner,
            .outer_cone = outer};
}

Lamp sun(const glm::dvec3& direction, double lux, double degrees = 0.0) {
    return {.name = "sun",
            .kind = LampKind::directional,
            .intensity = lux,
            .direction = glm::normalize(direction),
            .angular_diameter = degrees};
}

/// A floor of 8 m × 8 m in the plane y = 0, facing up; what a test adds stands on it.
class Floor {
public:
    Floor() { m_maker.add_quad({-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}); }

    /// A wall or roof, corners in metres.
    void add_quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
        m_maker.add_quad(a / metres, b / metres, c / metres, d / metres);
    }
    /// A texel at (x, z), metres.
    void add_texel(double x, double z) {
        // The diagonal of the quad runs from (−1, 1) to (1, −1): right of it lies triangle 0.
        const std::uint32_t triangle = x + z >= 0.0 ? 0U : 1U;
        m_points.push_back({glm::vec3(glm::dvec3(x, 0.0, z) / double{metres}), {0, 1, 0}, {0, 1, 0}, triangle});
    }
    void turn_shading_normal(const glm::vec3& normal) { m_points.back().shading_normal = glm::normalize(normal); }

    [[nodiscard]] LightMap trace(const std::vector<Lamp>& lamps, const Settings& settings = {},
                                 const Sky& sky = black_sky()) {
        const Surface surface = m_maker.finish(exponent);
        return Tracer(surface, sky, settings, lamps).trace(test::geometry_image(m_points, 16));
    }
    /// One value a texel: E/π of a white lamp.
    [[nodiscard]] std::vector<double> light(const std::vector<Lamp>& lamps, const Settings& settings = {}) {
        const LightMap map = trace(lamps, settings);
        std::vector<double> values;
        for (std::size_t i = 0; i < m_points.size(); ++i) {
            values.push_back(double{map.image.texels[i].g});
        }
        return values;
    }

private:
    test::SurfaceMaker m_maker;
    std::vector<test::SamplePoint> m_points;
};

Settings with_rays(std::uint32_t rays) {
    Settings settings;
    settings.rays = rays;
    return settings;
}

TEST(Lamps, APointsLightFallsWithTheSquareAndTheCosine) {
    Floor floor;
    const glm::dvec3 place(0.5, 1.5, -0.25);
    std::vector<double> expected;
    for (int i = 0; i < 40; ++i) {
        const double x = -3.9 + 0.2 * i;
        const double z = 0.1 * (i % 7);
        floor.add_texel(x, z);
        const double square = glm::dot(place - glm::dvec3(x, 0, z), place - glm::dvec3(x, 0, z));
        expected.push_back(10.0 * (place.y / std::sqrt(square)) / square / pi);
    }
    const std::vector<double> found = floor.light({point_lamp(place)});
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_NEAR(found[i], expected[i], 2e-5 * expected[i]) << i;
    }
}

TEST(Lamps, ColoursAndLampsAddUp) {
    Floor floor;
    floor.add_texel(0.0, 0.0);
    Lamp red = point_lamp({0, 2, 0}, 8.0);
    red.color = {1.0, 0.5, 0.0};
    Lamp blue = sun({0, -1, 0}, 3.0);
    blue.color = {0.0, 0.0, 1.0};
    const glm::vec4 found = floor.trace({red, blue}).image.texels[0];
    EXPECT_NEAR(found.r, 8.0 / 4.0 / pi, 1e-5);
    EXPECT_NEAR(found.g, 4.0 / 4.0 / pi, 1e-5);
    EXPECT_NEAR(found.b, 3.0 / pi, 1e-5);
}

TEST(Lamps, ASpotHasAConeWithASoftEdge) {
    constexpr double height = 2.0;
    constexpr double inner = 0.3;
    constexpr double outer = 0.6;
    const std::array<double, 9> angles{0.0, 0.15, 0.29, 0.35, 0.45, 0.55, 0.59, 0.61, 0.9};
    Floor floor;
    for (const double angle : angles) {
        floor.add_texel(height * std::tan(angle), 0.0);
    }
    const std::vector<double> found = floor.light({spot_lamp({0, height, 0}, {0, -1, 0}, inner, outer)});
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const double cosine = std::cos(angles[i]);
        const double full = 10.0 * cosine * (cosine * cosine / (height * height)) / pi;
        const double ramp = std::clamp((cosine - std::cos(outer)) / (std::cos(inner) - std::cos(outer)), 0.0, 1.0);
        EXPECT_NEAR(found[i], full * ramp * ramp, 2e-5 * full) << angles[i];
        EXPECT_EQ(found[i] == 0.0, angles[i] > outer) << angles[i];
    }
}

TEST(Lamps, ARangeEndsALight) {
    Floor floor;
    for (const double x : {0.0, 1.0, 2.0, 2.7, 3.0}) {
        floor.add_texel(x, 0.0);
    }
    Lamp lamp = point_lamp({0, 1, 0});
    lamp.range = 3.0;
    const std::vector<double> found = floor.light({lamp});
    std::size_t texel = 0;
    for (const double x : {0.0, 1.0, 2.0, 2.7, 3.0}) {
        const double square = x * x + 1.0;
        const double full = 10.0 / (square * std::sqrt(square)) / pi;
        EXPECT_NEAR(found[texel], full * std::max(1.0 - square * square / 81.0, 0.0), 2e-5 * full) << x;
        ++texel;
    }
    EXPECT_EQ(found[4], 0.0);
}

TEST(Lamps, ADirectionalLampGivesItsLuxTimesTheCosine) {
    Floor floor;
    floor.add_texel(-3.0, 2.0);
    floor.add_texel(0.0, 0.0);
    floor.add_texel(3.9, -3.9);
    for (const double found : floor.light({sun({3, -4, 0}, 5.0)})) {
        EXPECT_NEAR(found, 5.0 * 0.8 / pi, 1e-6);
    }
    for (const double found : floor.light({sun({3, 1, 0}, 5.0)})) { // from below
        EXPECT_EQ(found, 0.0);
    }
}

TEST(Lamps, LieNeitherBelowTheSurfaceNorBehindTheShadingNormal) {
    Floor floor;
    floor.add_texel(0.0, 0.0);
    floor.turn_shading_normal({-1, 0.2F, 0}); // the lamp is above the surface, behind this
    floor.add_texel(1.0, 0.0);
    floor.turn_shading_normal({1, 1, 0});
    const std::vector<double> from_right = floor.light({sun({-1, -0.5, 0}, 1.0), sun({-1, -0.5, 0}, 1.0, 5.0)});
    EXPECT_EQ(from_right[0], 0.0);
    EXPECT_NEAR(from_right[1], 2.0 * (1.5 / std::sqrt(2.5)) / pi, 1e-3); // the shading normal's cosine
    // Above what it is shaded by, below the surface that it lies on.
    EXPECT_EQ(floor.light({sun({-1, 0.1, 0}, 1.0), sun({-1, 0.1, 0}, 1.0, 5.0)})[1], 0.0);
}

TEST(Lamps, AWallHidesALamp) {
    Floor floor;
    floor.add_quad({0, 0, 3}, {0, 0, -3}, {0, 2, -3}, {0, 2, 3});
    floor.add_texel(1.0, 0.0);
    floor.add_texel(-1.0, 0.0);
    for (Lamp lamp : {point_lamp({1, 1, 0}), spot_lamp({1, 1, 0}, {-1, -1, 0}, 0.7, 1.5), sun({-1, -1, 0}, 1.0)}) {
        for (const bool soft : {false, true}) {
            lamp.radius = soft ? 0.05 : 0.0;
            lamp.angular_diameter = soft ? 1.0 : 0.0;
            const LightMap map = floor.trace({lamp}, with_rays(16));
            EXPECT_GT(map.image.texels[0].r, 0.0F);
            EXPECT_EQ(map.image.texels[1].r, 0.0F);
        }
    }
}

TEST(Lamps, ALampInASurfaceIsNotHiddenByIt) {
    Floor floor;
    floor.add_quad({-2, 2, -2}, {2, 2, -2}, {2, 2, 2}, {-2, 2, 2}); // faces down
    for (int i = 0; i < 64; ++i) {
        floor.add_texel(0.03 * i, 0.017 * i);
    }
    for (const double found : floor.light({point_lamp({0.1, 2, 0.1})})) {
        EXPECT_GT(found, 0.0);
    }
}

TEST(Lamps, ALampInAClosedBoxLightsItAndNothingElse) {
    test::SurfaceMaker maker;
    const std::uint32_t inside = maker.add_box({-0.5F, 0.0F, -0.5F}, {0.5F, 0.5F, 0.5F}, true);
    const std::uint32_t floor = maker.add_quad({-1, -0.25F, 1}, {1, -0.25F, 1}, {1, -0.25F, -1}, {-1, -0.25F, -1});
    const Surface surface = maker.finish(exponent);
    std::vector<test::SamplePoint> points;
    for (std::uint32_t face = 0; face < 12; ++face) {
        points.push_back(test::point_on(surface, inside + face, glm::dvec3(1.0 / 3.0)));
    }
    points.push_back(test::point_on(surface, floor, {0.5, 0.25, 0.25}));
    Lamp soft = point_lamp({0, 1, 0});
    soft.radius = 0.2;
    for (const Lamp& lamp : {point_lamp({0, 1, 0}), soft}) {
        const LightMap map =
            Tracer(surface, black_sky(), {}, std::vector<Lamp>{lamp}).trace(test::geometry_image(points, 16));
        for (std::size_t face = 0; face < 12; ++face) {
            EXPECT_GT(map.image.texels[face].r, 0.1F) << face;
        }
        EXPECT_EQ(map.image.texels[12].r, 0.0F);
    }
}

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
std::vector<double> make_half_shadow(Floor& floor) {
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

TEST(Lamps, ASoftDirectionalLampsHalfShadowIsADiscCutByALine) {
    Floor floor;
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

TEST(Lamps, ASphereGivesItsConfigurationFactor) {
    // L = I / (π r²), E/π = L F: above the horizon F = (r/d)² cos θ, the point's law.
    Floor floor;
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
    Floor other;
    for (int i = 0; i < 20; ++i) {
        other.add_texel(0.5 + 0.1 * i, 0.0);
        sunk.push_back(10.0 / (pi * 0.16) * factor_of_sphere(0.0, (0.5 + 0.1 * i) / 0.4));
    }
    const std::vector<double> beside = other.light({lamp}, with_rays(1024));
    for (std::size_t i = 0; i < beside.size(); ++i) {
        EXPECT_NEAR(beside[i], sunk[i], 0.01 * sunk[i]) << i;
    }
}

TEST(Lamps, TheSkysIntensityIsNotTheirs) {
    Floor floor;
    floor.add_texel(0.0, 0.0);
    Sky sky = black_sky();
    for (const double intensity : {0.0, 1.0, 3.0}) {
        sky.intensity = intensity;
        EXPECT_NEAR(floor.trace({point_lamp({0, 1, 0})}, {}, sky).image.texels[0].r, 10.0 / pi, 1e-4) << intensity;
    }
    EXPECT_NEAR(floor.trace({point_lamp({0, 1, 0})}, {}, test::white_sky()).image.texels[0].r, 1.0 + 10.0 / pi, 1e-4);
}

TEST(Lamps, EverySamplerGivesTheSameLight) {
    Floor floor;
    floor.add_texel(1.0, 0.5);
    Settings thesis;
    thesis.sampler = Sampler::thesis;
    Lamp soft = point_lamp({0, 1, 0});
    soft.radius = 0.1;
    for (const Lamp& lamp : {point_lamp({0, 1, 0}), soft}) {
        EXPECT_NEAR(floor.light({lamp}, thesis)[0], floor.light({lamp})[0], 1e-5);
    }
}

TEST(Lamps, AreLeftOutWhereTheyAreNotAskedFor) {
    Floor floor;
    floor.add_texel(0.0, 0.0);
    Settings settings;
    settings.lamps = Switch::off;
    EXPECT_EQ(floor.light({point_lamp({0, 1, 0})}, settings)[0], 0.0);
    settings.lamps = Switch::on;
    settings.mode = Mode::ao;
    EXPECT_EQ(floor.light({point_lamp({0, 1, 0})}, settings)[0], 1.0);
}

TEST(Lamps, ThatCannotBeAreRefused) {
    Floor floor;
    floor.add_texel(0.0, 0.0);
    const auto refused = [&](const auto& change) {
        Lamp lamp = point_lamp({0, 1, 0});
        change(lamp);
        EXPECT_THROW((void)floor.trace({lamp}), Error);
    };
    refused([](Lamp& l) { l.intensity = -1.0; });
    refused([](Lamp& l) { l.intensity = NAN; });
    refused([](Lamp& l) { l.intensity = 1e38; }); // beside it more than a float holds
    refused([](Lamp& l) { l.position.x = INFINITY; });
    refused([](Lamp& l) { l.direction = {0, 2, 0}; });
    refused([](Lamp& l) { l.inner_cone = 1.0; });
    refused([](Lamp& l) { l.range = 0.0; });
    refused([](Lamp& l) { l.radius = -1.0; });
}

TEST(Lamps, HardOnesHaveNoErrorAndSoftOnesSayTheirs) {
    Floor floor;
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

TEST(Lamps, ATargetCountsTheirError) {
    Floor floor;
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

std::vector<Lamp> many_lamps() {
    std::vector<Lamp> lamps;
    for (int i = 0; i < 20; ++i) {
        lamps.push_back(point_lamp({0.4 * i - 3.5, 0.5 + 0.1 * i, 0.3 * (i % 5)}, 1.0 + i));
        lamps.back().radius = i % 6 == 0 ? 0.15 : 0.0;
        lamps.back().range = 2.5 + 0.1 * i;
    }
    lamps.push_back(spot_lamp({1, 3, 1}, {-1, -2, 0}, 0.2, 0.5));
    lamps.push_back(spot_lamp({-1, 3, 1}, {1, -2, 0}, 0.2, 0.5));
    lamps.back().radius = 0.3;
    lamps.push_back(sun({1, -1, 0.5}, 2.0));
    lamps.push_back(sun({-1, -1, 0.5}, 2.0, 4.0));
    return lamps;
}

TEST(Lamps, GiveTheSameBitsHoweverTheyAreTraced) {
    test::SurfaceMaker maker;
    const std::uint32_t floor = maker.add_quad({-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1});
    maker.add_box({-0.3F, 0.1F, -0.2F}, {-0.1F, 0.3F, 0.2F}, false);
    maker.add_box({0.2F, 0.0F, -0.2F}, {0.3F, 0.5F, 0.1F}, false);
    const Surface surface = maker.finish(exponent);
    std::vector<test::SamplePoint> points;
    for (int i = 0; i < 150; ++i) {
        points.push_back(test::point_on(surface, floor, {0.6 - 0.004 * i, 0.3, 0.1 + 0.004 * i}));
    }
    const GeometryImage geometry = test::geometry_image(points, 16);
    const std::vector<Lamp> lamps = many_lamps();
    std::vector<Lamp> reversed = lamps;
    std::ranges::reverse(reversed);
    Settings settings = with_rays(50);
    settings.accelerator = Accelerator::brute;
    settings.threads = 1;
    const LightMap oracle = Tracer(surface, {}, settings, lamps).trace(geometry);
    EXPECT_GT(oracle.statistics.lamp_rays, 1000U);
    for (const Accelerator accelerator : {Accelerator::brute, Accelerator::clusters, Accelerator::bvh}) {
        for (const int threads : {1, 2}) {
            settings.accelerator = accelerator;
            settings.threads = threads;
            const LightMap found = Tracer(surface, {}, settings, lamps).trace(geometry);
            EXPECT_TRUE(test::same_bits(found.image.texels, oracle.image.texels));
            EXPECT_EQ(found.statistics.lamp_rays, oracle.statistics.lamp_rays);
            EXPECT_EQ(found.statistics.lamps_reached, oracle.statistics.lamps_reached);
            const LightMap other = Tracer(surface, {}, settings, reversed).trace(geometry);
            EXPECT_TRUE(test::same_bits(other.image.texels, oracle.image.texels));
        }
    }
    const Tracer tracer(surface, {}, settings, lamps);
    test::for_every_target(
        [&] { EXPECT_TRUE(test::same_bits(tracer.trace(geometry).image.texels, oracle.image.texels)); });
}

TEST(Lamps, InAClosedRoomAllFluxArrivesAndIsReflectedAsBounces) {
    // ∫ E dA over the walls is the flux of the lamp, 4 π I; of a bounce ρ times the last.
    Primitive walls = test::box_of({-2, 0, -1}, {2, 2, 1});
    for (std::size_t first = 0; first < walls.indices.size(); first += 3) {
        std::swap(walls.indices[first + 1], walls.indices[first + 2]);
    }
    Scene room = test::scene_of(walls);
    test::paint(room, 0, {.base_color = {0.5F, 0.5F, 0.5F, 1.0F}});
    room.lamps = {point_lamp({0.3, 1.1, -0.1}, 3.0)};
    Settings settings = with_rays(16);
    settings.size = test::amount(128, 48);
    settings.bounces = 1;
    settings.bounce_rays = test::amount(64U, 16U);
    Bake bake{.settings = settings};
    bake.surface = make_surface(room);
    bake.atlas = make_atlas(room, bake.surface, settings);
    const Tracer tracer(bake.surface, black_sky(), settings, room.lamps);
    const GeometryImage geometry = reference_geometry_image(bake.surface, bake.atlas, 0);
    bake.light_maps.push_back(tracer.trace(geometry));
    const auto mean = [&] {
        double sum = 0.0;
        for (const glm::vec4& texel : bake.light_maps[0].image.texels) {
            sum += double{texel.g};
        }
        return sum / static_cast<double>(bake.light_maps[0].statistics.covered_texels);
    };
    const double direct = mean();
    const double area = 2.0 * (4.0 * 2.0 + 2.0 * 2.0 + 4.0 * 2.0);
    EXPECT_NEAR(direct * pi * area, 4.0 * pi * 3.0, test::amount(0.03, 0.1) * 4.0 * pi * 3.0);
    const Progress silent;
    StageClock clock(silent);
    add_bounces(
        room, tracer, [&](std::size_t) -> const GeometryImage& { return geometry; }, clock, bake);
    EXPECT_NEAR((mean() - direct) / direct, 0.5, test::amount(0.02, 0.06));
}

} // namespace
} // namespace vkbake
