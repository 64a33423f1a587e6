// What the denoiser mends and what it leaves, on light that is known; the compute passes are held to the reference bit
// by bit in tests/gpu.
#include "finish/denoise_reference.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "noisy_map.hpp"

namespace {

using vkbake::test::NoisyMap;

std::uint64_t denoise(NoisyMap& noisy) {
    const vkbake::DenoiseFields fields = vkbake::make_denoise_fields(noisy.map, noisy.guides());
    return vkbake::take_denoised(fields, vkbake::denoise_reference(fields), noisy.guides(), noisy.map);
}

TEST(DenoiseReference, TakesMostNoiseOutOfEvenLightAndTellsWhatIsLeft) {
    // 49 texels a window: a seventh, and a little more at the border.
    NoisyMap noisy(96, 0.05, [](int, int) { return 1.0; });
    const double before = noisy.relative_rmse();
    denoise(noisy);
    EXPECT_LT(noisy.relative_rmse(), 0.25 * before);
    // Of v: a texel's estimate, (f − y)² and a constant, has a variance of 2 v², f being near the truth; so the mean's
    // deviation is √(2 / N). It may err upwards, as which texels count hangs a little on y, but has to tell that two
    // thirds of the noise are gone.
    const double deviation = std::sqrt(2.0 / static_cast<double>(noisy.truth.size()));
    const double truth = std::pow(noisy.relative_rmse() / 0.05, 2.0);
    const double told = std::pow(noisy.map.error->relative_rmse / 0.05, 2.0);
    EXPECT_GT(told, truth - 3.0 * deviation);
    EXPECT_LT(told, 1.0 / 9.0);
    EXPECT_NEAR(noisy.map.error->noise_rmse, 0.05, 1e-9);
}

TEST(DenoiseReference, KeepsAShadowOneTexelWide) {
    // Dark, and as faint as eight standard errors; the texels beside it stay lit.
    for (const double depth : {0.9, 0.4}) {
        NoisyMap noisy(48, 0.05, [&](int x, int) { return x == 20 ? 1.0 - depth : 1.0; });
        denoise(noisy);
        EXPECT_NEAR(noisy.column_mean(20), 1.0 - depth, 0.02) << depth;
        EXPECT_NEAR(noisy.column_mean(19), 1.0, 0.02) << depth;
        EXPECT_NEAR(noisy.column_mean(21), 1.0, 0.02) << depth;
        EXPECT_LT(noisy.relative_rmse(), 0.03) << depth;
    }
}

TEST(DenoiseReference, KeepsEdges) {
    NoisyMap noisy(48, 0.05, [](int x, int) { return x < 24 ? 1.0 : 0.7; });
    denoise(noisy);
    EXPECT_NEAR(noisy.column_mean(23), 1.0, 0.02);
    EXPECT_NEAR(noisy.column_mean(24), 0.7, 0.02);
}

TEST(DenoiseReference, KeepsGradientsUpToTheBorder) {
    // Without noise, but with some told: what a plane is must come out as it went in, to the ridge's pull at borders.
    NoisyMap noisy(
        24, 0.05, [](int x, int y) { return 1.0 + 0.01 * x - 0.005 * y; }, 1, false);
    denoise(noisy);
    for (std::size_t texel = 0; texel < noisy.truth.size(); ++texel) {
        ASSERT_NEAR(noisy.map.image.texels[texel].g, noisy.truth[texel], 0.003) << texel;
    }
}

TEST(DenoiseReference, LeavesWavesThatFitsWouldFlatten) {
    // No two texels differ by more than noise explains, but fits miss the light by half as much again as the noise is.
    NoisyMap noisy(64, 0.05, [](int x, int) { return 1.0 + 0.075 * (x % 2 == 0 ? 1 : -1); });
    const double before = noisy.relative_rmse();
    denoise(noisy);
    EXPECT_LT(noisy.relative_rmse(), 1.2 * before);
    EXPECT_NEAR(noisy.map.error->relative_rmse / noisy.relative_rmse(), 1.0, 0.2);
}

/// Two halves whose light differs by too little to be told apart: what keeps them apart is what `part` sets.
template<typename Part>
void expect_apart(const Part& part) {
    NoisyMap noisy(
        16, 0.05, [](int x, int) { return x < 8 ? 1.0 : 1.02; }, 1, false);
    part(noisy);
    denoise(noisy);
    for (int y = 0; y < 16; ++y) {
        ASSERT_NEAR(noisy.map.image.texels[noisy.map.image.index(7, y)].g, 1.0, 1e-5) << y;
        ASSERT_NEAR(noisy.map.image.texels[noisy.map.image.index(8, y)].g, 1.02, 1e-5) << y;
    }
}

template<typename Change>
void change_right_half(NoisyMap& noisy, const Change& change) {
    for (int y = 0; y < 16; ++y) {
        for (int x = 8; x < 16; ++x) {
            change(noisy.map.image.index(x, y));
        }
    }
}

TEST(DenoiseReference, LetsNothingBleedAcrossAChartACreaseOrAStep) {
    expect_apart([](NoisyMap& noisy) { change_right_half(noisy, [&](std::size_t texel) { noisy.chart[texel] = 1; }); });
    expect_apart([](NoisyMap& noisy) {
        change_right_half(noisy, [&](std::size_t texel) { noisy.geometry.shading_normal[texel] = {0.6F, 0.8F, 0.0F}; });
    });
    expect_apart([](NoisyMap& noisy) {
        change_right_half(noisy, [&](std::size_t texel) { noisy.geometry.position[texel].y = 0.1F; });
    });
    // And where nothing keeps them apart they do mix: else the above would prove nothing.
    NoisyMap noisy(
        16, 0.05, [](int x, int) { return x < 8 ? 1.0 : 1.02; }, 1, false);
    denoise(noisy);
    EXPECT_GT(noisy.map.image.texels[noisy.map.image.index(7, 8)].g, 1.004F);
}

TEST(DenoiseReference, LeavesGoodTexelsAndWhatIsNotFiniteToTheBit) {
    NoisyMap noisy(16, 0.05, [](int, int) { return 1.0; });
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 8; ++x) {
            noisy.variance[noisy.map.image.index(x, y)] = 0.0F;
        }
    }
    const std::size_t infinite = noisy.map.image.index(12, 12);
    noisy.map.image.texels[infinite].r = std::numeric_limits<float>::infinity();
    const std::vector<glm::vec4> before = noisy.map.image.texels;
    const std::vector<float> errors = noisy.map.standard_error;
    const std::uint64_t changed = denoise(noisy);
    EXPECT_GT(changed, 120U);
    EXPECT_LT(changed, 16U * 9U); // nine columns have a noisy texel beside them
    for (std::size_t texel = 0; texel < before.size(); ++texel) {
        if (texel % 16 < 7 || texel == infinite) {
            EXPECT_EQ(noisy.map.image.texels[texel], before[texel]) << texel;
            EXPECT_EQ(noisy.map.standard_error[texel], errors[texel]) << texel;
        } else {
            EXPECT_TRUE(std::isfinite(noisy.map.image.texels[texel].r)) << texel;
        }
    }
}

TEST(DenoiseReference, ReciprocalsAreGoodToTwoUnitsInTheLastPlace) {
    std::mt19937 random(3);
    for (int i = 0; i < 100000; ++i) {
        const auto exponent = 127U - 100U + static_cast<std::uint32_t>(random()) % 200U;
        const float x = std::bit_cast<float>((exponent << 23U) | (static_cast<std::uint32_t>(random()) & 0x7FFFFFU));
        ASSERT_NEAR(static_cast<double>(vkbake::plain_reciprocal(x)) * static_cast<double>(x), 1.0, 2.4e-7) << x;
        ASSERT_NEAR(static_cast<double>(vkbake::plain_root_reciprocal(x)) * std::sqrt(static_cast<double>(x)), 1.0,
                    2.4e-7)
            << x;
    }
}

} // namespace
