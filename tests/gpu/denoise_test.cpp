// The denoiser's compute passes against their CPU reference, bit by bit.
#include "finish/denoise.hpp"

#include <cstdint>
#include <random>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "device.hpp"
#include "finish/denoise_reference.hpp"
#include "same_bits.hpp"

namespace {

/// Charts, creases, holes, and light of many magnitudes with more and less noise.
struct RandomMap {
    RandomMap(int width, int height, std::uint32_t seed) {
        std::mt19937 random(seed);
        const auto uniform = [&] { return static_cast<float>(random() >> 8U) * 0x1p-24F; };
        map.image = {.width = width, .height = height, .texels = {}, .coverage = {}};
        geometry.width = width;
        geometry.height = height;
        geometry.position = geometry.shading_normal =
            vkbake::ZeroedArray<glm::vec3>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const bool covered = uniform() < 0.95F;
                const float brightness = (x / 11 + y / 7) % 5 == 0 ? 1e-3F : 1.0F;
                const float sigma = x % 29 < 20 ? 0.1F : 0.004F;
                const auto light = [&] { return brightness * (1.0F + sigma * (uniform() + uniform() - 1.0F)); };
                map.image.texels.emplace_back(light(), light(), light(), covered ? 1.0F : 0.0F);
                map.image.coverage.push_back(covered ? 1.0F : 0.0F);
                variance.push_back(covered ? brightness * brightness * sigma * sigma * uniform() : 0.0F);
                map.standard_error.push_back(brightness * sigma);
                geometry.triangle.push_back(covered ? static_cast<std::uint32_t>((x / 23) * 3 + (y / 17) * 2)
                                                    : vkbake::GeometryImage::empty);
                const float bend = 0.05F * uniform() + (y % 13 < 7 ? 0.0F : 0.6F);
                const std::size_t texel = map.image.index(x, y);
                geometry.shading_normal[texel] = glm::normalize(glm::vec3(bend, 1.0F, 0.1F * uniform()));
                geometry.position[texel] = {0.01F * static_cast<float>(x), 0.001F * uniform(),
                                            0.01F * static_cast<float>(y)};
            }
        }
        chart.resize(static_cast<std::size_t>(width) + static_cast<std::size_t>(height), 0);
        for (std::size_t triangle = 0; triangle < chart.size(); ++triangle) {
            chart[triangle] = static_cast<std::uint32_t>(triangle / 3);
        }
        map.error = vkbake::MapError{.relative_rmse = 0.1};
    }

    [[nodiscard]] vkbake::DenoiseGuides guides() const { return {geometry, chart, variance}; }

    vkbake::LightMap map;
    vkbake::GeometryImage geometry;
    std::vector<std::uint32_t> chart;
    std::vector<float> variance;
};

TEST(Denoise, EqualsTheReferenceForSizesAndTiles) {
    struct Size {
        int width;
        int height;
    };
    for (const Size size : {Size{1, 37}, Size{61, 67}, Size{97, 40}}) {
        const RandomMap start(size.width, size.height, 7);
        RandomMap expected = start;
        const vkbake::DenoiseFields fields = vkbake::make_denoise_fields(start.map, start.guides());
        const std::uint64_t changed =
            vkbake::take_denoised(fields, vkbake::denoise_reference(fields), start.guides(), expected.map);
        for (const int tile : {33, 1024}) {
            RandomMap noisy = start;
            EXPECT_EQ(vkbake::denoise(vkbake::test::context(), noisy.map, noisy.guides(), {.tile = tile}), changed);
            EXPECT_TRUE(vkbake::test::same_bits(noisy.map.image.texels, expected.map.image.texels))
                << size.width << " x " << size.height << ", tile " << tile;
            EXPECT_TRUE(vkbake::test::same_bits(noisy.map.standard_error, expected.map.standard_error));
            EXPECT_EQ(noisy.map.error->relative_rmse, expected.map.error->relative_rmse);
        }
        EXPECT_TRUE(size.width < 50 || changed > 100U) << "nothing was denoised, so nothing was compared";
    }
}

} // namespace
