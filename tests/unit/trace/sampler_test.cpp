#include "trace/sampler.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <gtest/gtest.h>

#include "base/random.hpp"
#include "chi_squared.hpp"

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

TEST(CosineHemisphere, StaysAboveTheHorizonAtTheSquaresBorder) {
    constexpr std::uint32_t last = (1U << 24U) - 1U;
    for (const std::uint32_t x : {0U, 1U, last / 2, last / 2 + 1, last}) {
        for (const std::uint32_t y : {0U, 1U, last / 2, last / 2 + 1, last}) {
            const glm::vec3 direction = cosine_hemisphere({x, y});
            EXPECT_GE(direction.z, 0x1p-12F);
            EXPECT_NEAR(glm::length(direction), 1.0F, 2e-7F);
        }
    }
}

/// One direction a texel, so that all are independent: the points of one texel are not (they fill the square evenly).
template<typename Visit>
void visit_independent_directions(std::uint32_t index, const glm::vec3& normal, Visit visit) {
    const CosineSampler sampler(256);
    for (std::uint32_t y = 0; y < 256; ++y) {
        for (std::uint32_t x = 0; x < 256; ++x) {
            visit(sampler.at(texel_key(11, x, y), normal).sample(index));
        }
    }
}

TEST(CosineSampler, DirectionsHaveTheCosineDensity) {
    // Under cos θ / π, cos² θ and φ are independent and uniform: 16 × 16 cells of equal probability. Five tests.
    const std::array<std::uint32_t, 5> indices{0, 1, 16, 100, 255};
    for (const std::uint32_t index : indices) {
        std::vector<std::uint32_t> counts(256, 0);
        visit_independent_directions(index, {0, 0, 1}, [&](const HemisphereSample& sample) {
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
    visit_independent_directions(37, normal, [&](const HemisphereSample& sample) {
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
        double squares = 0.0;
        for (std::uint32_t texel = 0; texel < 200; ++texel) {
            const CosineSampler::Texel directions = CosineSampler::at(texel_key(0, texel, 0), {0, 0, 1});
            double sum = 0.0;
            for (std::uint32_t i = 0; i < count; ++i) {
                sum += static_cast<double>(directions.sample(i).direction.z);
            }
            squares += std::pow(sum / count - 2.0 / 3.0, 2.0);
        }
        EXPECT_LT(std::sqrt(squares / 200.0), 0.25 * std::sqrt(1.0 / 18.0 / count)) << count;
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
    ASSERT_EQ(ThesisSampler::count(), 256U);
    const ThesisSampler sampler;
    const glm::vec3 normal = glm::normalize(glm::vec3(0.3F, -0.8F, 0.5F));
    const ThesisSampler::Texel texel = sampler.at(0, normal);
    double zeroth = 0.0;
    glm::dvec3 first(0.0);
    glm::dmat3 second(0.0);
    for (std::uint32_t i = 0; i < ThesisSampler::count(); ++i) {
        const HemisphereSample sample = texel.sample(i);
        const glm::dvec3 direction(sample.direction);
        zeroth += sample.weight;
        first += sample.weight * direction;
        second += sample.weight * glm::outerProduct(direction, direction);
    }

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
    EXPECT_NEAR(zeroth * ThesisSampler::scale(), 0.97353, 1e-5);

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

TEST(ThesisSampler, StepsThroughThetaWithinPhi) {
    const ThesisSampler sampler;
    const ThesisSampler::Texel texel = sampler.at(0, {0, 1, 0});
    for (int i = 0; i < 32; ++i) {
        for (int j = 0; j < 8; ++j) {
            const double phi = 0.2 * i;
            const double theta = 0.2 * j;
            const HemisphereSample sample = texel.sample(static_cast<std::uint32_t>(8 * i + j));
            // Tangent +X, bitangent +Z, normal +Y.
            EXPECT_NEAR(sample.direction.x, std::sin(theta) * std::cos(phi), 1e-7);
            EXPECT_NEAR(sample.direction.z, std::sin(theta) * std::sin(phi), 1e-7);
            EXPECT_NEAR(sample.direction.y, std::cos(theta), 1e-7);
            EXPECT_NEAR(sample.weight, std::cos(theta) * std::sin(theta), 1e-9);
        }
    }
}

} // namespace
} // namespace vkbake
