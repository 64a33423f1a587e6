#include "trace/tile_rays.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <gtest/gtest.h>

#include "amount.hpp"
#include "base/random.hpp"
#include "chi_squared.hpp"
#include "closed_form/hand_made.hpp"

namespace vkbake {
namespace {

std::vector<glm::vec3> test_normals() {
    std::vector<glm::vec3> normals{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0},      {0, -1, 0},
                                   {0, 0, 1}, {0, 0, -1}, {0, -0.0F, -1}, {1e-20F, 1, 0}};
    for (const float tilt : {1e-3F, 1e-4F, 1e-7F}) {
        normals.push_back(glm::normalize(glm::vec3(tilt, 2 * tilt, -1.0F)));
        normals.push_back(glm::normalize(glm::vec3(tilt, -1.0F, 2 * tilt)));
    }
    for (std::uint64_t i = 0; i < 500; ++i) {
        const auto number = [&](std::uint64_t k) {
            return static_cast<float>(static_cast<double>(mix64(3 * i + k) >> 11U) * 0x1p-53 * 2.0 - 1.0);
        };
        normals.push_back(glm::normalize(glm::vec3(number(0), number(1), number(2))));
    }
    return normals;
}

void expect_orthonormal(const OrthonormalFrame& frame) {
    EXPECT_NEAR(glm::length(frame.tangent), 1.0F, 4e-7F);
    EXPECT_NEAR(glm::length(frame.bitangent), 1.0F, 4e-7F);
    EXPECT_NEAR(glm::dot(frame.tangent, frame.bitangent), 0.0F, 4e-7F);
    EXPECT_NEAR(glm::dot(frame.tangent, frame.normal), 0.0F, 2e-6F);
    EXPECT_NEAR(glm::dot(frame.bitangent, frame.normal), 0.0F, 2e-6F);
}

TEST(Frames, AreOrthonormalAboutEveryNormal) {
    for (const glm::vec3& normal : test_normals()) {
        SCOPED_TRACE(testing::Message() << normal.x << " " << normal.y << " " << normal.z);
        const OrthonormalFrame frame = orthonormal_frame(normal);
        EXPECT_EQ(frame.normal, normal);
        expect_orthonormal(frame);
        EXPECT_GT(glm::dot(glm::cross(frame.tangent, frame.bitangent), normal), 0.9999F);
        expect_orthonormal(thesis_frame(normal));
    }
}

TEST(Frames, OfNearNormalsAreNear) {
    for (const glm::vec3& normal : test_normals()) {
        if (std::abs(std::abs(normal.y) - std::sqrt(0.5F)) < 0.02F) {
            continue; // the step at 45°
        }
        for (std::uint64_t i = 0; i < 20; ++i) {
            const auto number = [&](std::uint64_t k) {
                return static_cast<float>(mix64(3 * i + k) >> 40U) * 0x1p-24F - 0.5F;
            };
            const glm::vec3 beside = glm::normalize(normal + 0.01F * glm::vec3(number(0), number(1), number(2)));
            const OrthonormalFrame frame = orthonormal_frame(normal);
            EXPECT_LT(glm::distance(orthonormal_frame(beside).tangent, frame.tangent), 0.2F);
        }
    }
    const OrthonormalFrame floor = orthonormal_frame({0, 1, 0});
    for (const glm::vec3& tilted : {glm::vec3(0, 1, -1e-7F), glm::vec3(-1e-7F, 1, 0), glm::vec3(-0.0F, 1, -0.0F)}) {
        EXPECT_LT(glm::distance(orthonormal_frame(tilted).tangent, floor.tangent), 1e-6F);
    }
}

TEST(Frames, UprightSurfacesHaveALevelTangentAndTheirBitangentIsNotMirrored) {
    for (const glm::vec3& wall : {glm::vec3(1, 0, 0), glm::vec3(0, 0, -1), glm::vec3(0.6F, 0, -0.8F)}) {
        const OrthonormalFrame frame = orthonormal_frame(wall);
        EXPECT_EQ(frame.tangent.y, 0.0F);
        EXPECT_NEAR(frame.bitangent.y, 1.0F, 1e-6F);
    }
    EXPECT_EQ(orthonormal_frame({0, 1, 0}).tangent, glm::vec3(1, 0, 0));
    EXPECT_EQ(orthonormal_frame({0, -1, 0}).tangent, glm::vec3(1, 0, 0));
}

TEST(Frames, ThesisTangentIsNormalCrossUp) {
    for (const float y : {1.0F, -1.0F}) {
        const OrthonormalFrame frame = thesis_frame({0.0F, y, 0.0F});
        EXPECT_EQ(frame.tangent, glm::vec3(1, 0, 0));
        EXPECT_EQ(frame.bitangent, glm::vec3(0, 0, 1));
    }
    // n = +X: n × up = +Z; n × tangent = −Y.
    const OrthonormalFrame wall = thesis_frame({1.0F, 0.0F, 0.0F});
    EXPECT_EQ(wall.tangent, glm::vec3(0, 0, 1));
    EXPECT_EQ(wall.bitangent, glm::vec3(0, -1, 0));
}

struct Sample {
    glm::vec3 direction{0.0F};
    double weight = 0.0;
};

/// Calls visit(texel, number in the blocks' order, sample) for `texels` texels that all have one normal and no ground
/// under them, all strata or one.
template<typename Visit>
void visit_samples(const Settings& settings, std::uint32_t texels, const glm::vec3& normal, std::size_t first,
                   std::size_t last, Visit visit) {
    test::SurfaceMaker maker;
    maker.add({0, 0, 0}, {0, 0, 0}, {0, 0, 0});
    const Surface surface = maker.finish();
    const std::vector<test::SamplePoint> points(texels, {{0, 0, 0}, normal, normal, 0});
    const GeometryImage geometry = test::geometry_image(points, 256);
    const RayPlan plan(settings, 1.0F);
    TileRays rays(surface, geometry, plan);
    for (const TexelTile& tile : make_tiles(geometry, 1)) {
        rays.begin(tile);
        for (std::size_t number = first / 16; number <= last / 16; ++number) {
            const RayBlock& block = rays.make(number);
            const RayPlan::Weights weights = plan.weights(number);
            for (std::size_t i = number * 16; i < number * 16 + 16; ++i) {
                for (std::uint32_t lane = 0; lane < tile.count && first <= i && i <= last; ++lane) {
                    if (((block.active[i % 16] >> lane) & 1U) != 0) {
                        const auto& rows = block.direction[i % 16];
                        visit(tile.texels[lane], i,
                              Sample{{rows[0][lane], rows[1][lane], rows[2][lane]},
                                     weights[i % 16] * rays.weight(i % 16, lane)});
                    }
                }
            }
        }
    }
}

Settings cosine(std::uint32_t rays) {
    Settings settings;
    settings.rays = rays;
    settings.seed = 11;
    return settings;
}

TEST(CosineSampler, StaysAboveTheHorizon) {
    float least = 1.0F;
    visit_samples(cosine(256), test::amount(65536U, 4096U), {0, 0, 1}, 0, 255,
                  [&](std::uint32_t, std::size_t, const Sample& sample) {
                      least = std::min(least, sample.direction.z);
                      ASSERT_NEAR(glm::length(glm::dvec3(sample.direction)), 1.0, 0x1p-21);
                  });
    EXPECT_GE(least, 0x1p-12F);
    EXPECT_LT(least, 0.003F); // of 16 million directions the least cos² is about 6e-8
}

/// One direction a texel, so that all are independent: the points of one texel are not (they fill the square evenly).
/// Which of a round's cells a stratum is, is the same for all texels; with 3 rays a texel the square is one cell.
template<typename Visit>
void visit_independent_directions(std::size_t stratum, const glm::vec3& normal, Visit visit) {
    std::uint32_t count = 0;
    visit_samples(cosine(3), 65536, normal, stratum, stratum, [&](std::uint32_t, std::size_t, const Sample& sample) {
        ++count;
        visit(sample);
    });
    EXPECT_EQ(count, 65536U);
}

TEST(CosineSampler, DirectionsHaveTheCosineDensity) {
    // Under cos θ / π, cos² θ and φ are independent and uniform: 16 × 16 cells of equal probability. Three tests.
    const std::array<std::size_t, 3> indices{0, 1, 2};
    for (const std::size_t index : indices) {
        std::vector<std::uint32_t> counts(256, 0);
        visit_independent_directions(index, {0, 0, 1}, [&](const Sample& sample) {
            const glm::dvec3 direction(sample.direction);
            const double turn = std::atan2(direction.y, direction.x) / (2.0 * std::numbers::pi) + 0.5;
            const auto cell = [](double share) {
                return std::min(static_cast<std::size_t>(share * 16.0), std::size_t{15});
            };
            ++counts[cell(direction.z * direction.z) * 16 + cell(turn)];
            EXPECT_EQ(sample.weight, 1.0);
        });
        EXPECT_GT(test::uniform_p_value(counts), test::corrected_level(0.01, static_cast<int>(indices.size())))
            << "sample " << index;
    }
}

TEST(CosineSampler, FirstAndSecondMomentsAboutATiltedNormal) {
    // E[ω] = ⅔ n and E[ω ωᵀ] = ¼ (1 + n nᵀ). Along any axis ω has a variance of at most ¼, its square of at most 1/10
    // (at sin² = 2/5 from the normal), and a product of two axes is half the difference of two squares. 9 tests at 5
    // standard errors: they fail by chance once in 200,000 keys.
    const glm::vec3 normal = glm::normalize(glm::vec3(0.3F, -0.8F, 0.5F));
    glm::dvec3 first(0.0);
    glm::dmat3 second(0.0);
    visit_independent_directions(2, normal, [&](const Sample& sample) {
        const glm::dvec3 direction(sample.direction);
        first += direction;
        second += glm::outerProduct(direction, direction);
    });
    constexpr double count = 65536.0;
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(first[i] / count, 2.0 / 3.0 * static_cast<double>(normal[i]), 5.0 * std::sqrt(0.25 / count)) << i;
        for (int j = 0; j <= i; ++j) {
            const double expected = 0.25 * ((i == j ? 1.0 : 0.0) + static_cast<double>(normal[i]) * normal[j]);
            EXPECT_NEAR(second[i][j] / count, expected, 5.0 * std::sqrt(0.1 / count)) << i << j;
        }
    }
}

TEST(CosineSampler, OneTexelsSamplesIntegrateASmoothFunctionFarBetterThanChance) {
    // The mean of cos θ over 256 independent directions has a standard error of √(1/18/256) = 0.0147; nested scrambling
    // of a (0, 2)-sequence brings a smooth function's down by about √256. A quarter of chance would already fail for
    // directions without stratification; also for counts that are no power of two.
    for (const std::uint32_t count : {100U, 256U, 1000U}) {
        std::vector<double> sums(200, 0.0);
        visit_samples(cosine(count), 200, {0, 0, 1}, 0, CosineStrata(count).count() - 1,
                      [&](std::uint32_t texel, std::size_t, const Sample& sample) {
                          sums[texel] += static_cast<double>(sample.direction.z);
                      });
        double squares = 0.0;
        for (const double sum : sums) {
            squares += std::pow(sum / count - 2.0 / 3.0, 2.0);
        }
        EXPECT_LT(std::sqrt(squares / 200.0), 0.25 * std::sqrt(1.0 / 18.0 / count)) << count;
    }
}

/// Of a texel's samples: the estimate of ∫ cos² θ dω / π = 2/3, over many texels.
struct CosineMean {
    double mean = 0.0;
    double deviation = 0.0; ///< of one texel's from 2/3
};
CosineMean cosine_mean(Sampler sampler, std::uint32_t count) {
    constexpr std::uint32_t texels = 400;
    Settings settings;
    settings.sampler = sampler;
    settings.rays = count;
    std::vector<double> sums(texels, 0.0);
    std::vector<std::uint32_t> samples(texels, 0);
    const glm::vec3 normal = glm::normalize(glm::vec3(0.3F, -0.8F, 0.5F));
    visit_samples(settings, texels, normal, 0, count - 1, [&](std::uint32_t texel, std::size_t, const Sample& sample) {
        sums[texel] += sample.weight * glm::dot(glm::dvec3(sample.direction), glm::dvec3(normal));
        ++samples[texel];
    });
    CosineMean result;
    for (std::uint32_t texel = 0; texel < texels; ++texel) {
        EXPECT_EQ(samples[texel], count);
        const double off = sums[texel] / count - 2.0 / 3.0;
        result.mean += (off + 2.0 / 3.0) / texels;
        result.deviation += off * off / texels;
    }
    result.deviation = std::sqrt(result.deviation);
    return result;
}

TEST(RandomSamplers, UniformOnesScatterAsIndependentOnesDo) {
    // Evenly spread, weight 2 cos θ: 2 cos² θ has the variance 4 (1/5 − 1/9) = 16/45.
    for (const std::uint32_t count : {1U, 50U, 256U}) {
        const double chance = std::sqrt(16.0 / 45.0 / count);
        const CosineMean found = cosine_mean(Sampler::uniform, count);
        EXPECT_NEAR(found.mean, 2.0 / 3.0, 5.0 * chance / 20.0) << count;
        EXPECT_NEAR(found.deviation / chance, 1.0, 0.2) << count; // of 400: five standard errors
    }
}

TEST(RandomSamplers, StratifiedOnesScatterByTheirCellAlone) {
    // In a cell of side 1/√N a smooth function varies by 1/√N of what it does in all: an error of a few times 1/N in
    // place of 1/√N (a few: cos θ is steep at the rim). So also where N cells make no square.
    for (const std::uint32_t count : {1U, 50U, 100U, 256U}) {
        const double chance = std::sqrt(1.0 / 18.0 / count);
        const CosineMean found = cosine_mean(Sampler::stratified, count);
        EXPECT_NEAR(found.mean, 2.0 / 3.0, 5.0 * chance / 20.0) << count;
        EXPECT_LT(found.deviation, 5.0 * chance / std::sqrt(count)) << count;
    }
}

/// Σ cos(k h) and Σ sin(k h) over k < n, in closed form (Dirichlet's kernel).
struct StepSums {
    double cosine, sine;
};
StepSums step_sums(int n, double h) {
    const double kernel = std::sin(n * h / 2.0) / std::sin(h / 2.0);
    return {kernel * std::cos((n - 1) * h / 2.0), kernel * std::sin((n - 1) * h / 2.0)};
}

TEST(ThesisSampler, MomentsFollowFromItsStepsInClosedForm) {
    Settings settings;
    settings.sampler = Sampler::thesis;
    const RayPlan plan(settings, 1.0F);
    ASSERT_EQ(plan.samples(), 256U);
    ASSERT_EQ(plan.block_count(), 16U);
    const glm::vec3 normal = glm::normalize(glm::vec3(0.3F, -0.8F, 0.5F));
    double zeroth = 0.0;
    glm::dvec3 first(0.0);
    glm::dmat3 second(0.0);
    visit_samples(settings, 1, normal, 0, 255, [&](std::uint32_t, std::size_t, const Sample& sample) {
        const glm::dvec3 direction(sample.direction);
        zeroth += sample.weight;
        first += sample.weight * direction;
        second += sample.weight * glm::outerProduct(direction, direction);
    });

    // w = cos θ sin θ = ½ sin 2θ. Σ w, Σ w cos θ = Σ cos² sin = ¼ Σ (sin θ + sin 3θ), Σ w sin θ = Σ cos sin² =
    // ¼ Σ (cos θ − cos 3θ), Σ w cos² = ¼ Σ sin 2θ + ⅛ Σ sin 4θ, Σ w cos sin = ¼ Σ sin² 2θ = ⅛ Σ (1 − cos 4θ).
    const StepSums theta1 = step_sums(8, 0.2);
    const StepSums theta2 = step_sums(8, 0.4);
    const StepSums theta3 = step_sums(8, 0.6);
    const StepSums theta4 = step_sums(8, 0.8);
    const StepSums phi1 = step_sums(32, 0.2);
    const StepSums phi2 = step_sums(32, 0.4);
    const double w = 0.5 * theta2.sine;
    const double w_cos = 0.25 * (theta1.sine + theta3.sine);
    const double w_sin = 0.25 * (theta1.cosine - theta3.cosine);
    const double w_cos_cos = 0.25 * theta2.sine + 0.125 * theta4.sine;
    const double w_cos_sin = 0.125 * (8.0 - theta4.cosine);
    const double w_sin_sin = w - w_cos_cos;
    EXPECT_NEAR(zeroth, 32.0 * w, 1e-9);
    EXPECT_NEAR(zeroth * plan.scale(), 0.97353, 1e-5);

    const glm::dvec3 n(normal);
    const glm::dvec3 t = glm::normalize(glm::cross(n, glm::dvec3(0, 1, 0)));
    const glm::dvec3 b = glm::normalize(glm::cross(n, t));
    const glm::dvec3 expected_first = w_sin * phi1.cosine * t + w_sin * phi1.sine * b + 32.0 * w_cos * n;
    const glm::dmat3 local(t, b, n);
    const double xx = w_sin_sin * 0.5 * (32.0 + phi2.cosine);
    const double yy = w_sin_sin * 0.5 * (32.0 - phi2.cosine);
    const double xy = w_sin_sin * 0.5 * phi2.sine;
    const double xz = w_cos_sin * phi1.cosine;
    const double yz = w_cos_sin * phi1.sine;
    const glm::dmat3 moments(xx, xy, xz, xy, yy, yz, xz, yz, 32.0 * w_cos_cos);
    const glm::dmat3 expected_second = local * moments * glm::transpose(local);
    // 256 directions, each good to 3e-7.
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(first[i], expected_first[i], 4e-5) << i;
        for (int j = 0; j < 3; ++j) {
            EXPECT_NEAR(second[i][j], expected_second[i][j], 8e-5) << i << j;
        }
    }
}

TEST(ThesisSampler, BlocksHoldFourByFourNeighbours) {
    Settings settings;
    settings.sampler = Sampler::thesis;
    std::size_t visits = 0;
    visit_samples(settings, 3, {0, 1, 0}, 0, 255, [&](std::uint32_t, std::size_t number, const Sample& sample) {
        const std::size_t block = number / 16;
        const std::size_t row = block / 2 * 4 + number % 16 / 4;
        const std::size_t column = block % 2 * 4 + number % 4;
        const double phi = 0.2 * static_cast<double>(row);
        const double theta = 0.2 * static_cast<double>(column);
        // Tangent +X, bitangent +Z, normal +Y.
        EXPECT_NEAR(sample.direction.x, std::sin(theta) * std::cos(phi), 1e-7);
        EXPECT_NEAR(sample.direction.z, std::sin(theta) * std::sin(phi), 1e-7);
        EXPECT_NEAR(sample.direction.y, std::cos(theta), 1e-7);
        EXPECT_NEAR(sample.weight, std::cos(theta) * std::sin(theta), 1e-9);
        ++visits;
    });
    EXPECT_EQ(visits, 3U * 256U);
}

} // namespace
} // namespace vkbake
