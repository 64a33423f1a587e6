// --target-error of a denoised map, through a whole bake.
#include <cmath>

#include <gtest/gtest.h>

#include "closed_form/configuration_factors.hpp"
#include "device.hpp"
#include "host_bake.hpp"
#include "vkbake/vkbake.hpp"

namespace vkbake::test {
namespace {

constexpr int side = 64;     // texels; the floor has the left half of them
constexpr double half = 0.5; // of the roof, which lies over the floor's middle
constexpr double height = 0.3;

/// A floor of 2 × 4 under a roof of 1 × 1, both seen from above.
Scene floor_and_roof() {
    Primitive primitive;
    add_quad(primitive, {-1, 0, 2}, {1, 0, 2}, {1, 0, -2}, {-1, 0, -2});
    add_quad(primitive, {-half, height, half}, {half, height, half}, {half, height, -half}, {-half, height, -half});
    for (const float left : {0.0F, 0.5F}) {
        for (const glm::vec2& corner : {glm::vec2(0.0F, 1.0F), {0.5F, 1.0F}, {0.5F, 0.0F}, {0.0F, 0.0F}}) {
            primitive.tex_coords[1].push_back({left + corner.x, corner.y});
        }
    }
    return scene_of(primitive);
}

/// Of a white sky, from the middle of a texel.
double visible_from(int x, int y) {
    if (x >= side / 2) {
        return 1.0;
    }
    const double u = -1.0 + 4.0 * (x + 0.5) / side;
    const double v = -2.0 + 4.0 * (y + 0.5) / side;
    const auto factor = [&](double to_u, double to_v) {
        return element_to_parallel_rectangle(to_u - u, to_v - v, height);
    };
    return 1.0 - factor(half, half) + factor(-half, half) + factor(half, -half) - factor(-half, -half);
}

double true_error(const LightMap& map) {
    double squares = 0.0;
    double sum = 0.0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const double truth = visible_from(x, y);
            squares += std::pow(static_cast<double>(map.image.texels[map.image.index(x, y)].g) - truth, 2.0);
            sum += truth;
        }
    }
    return std::sqrt(squares * side * side) / sum;
}

TEST(DenoisedTargetError, IsWhatIsLeftAndTakesFewerRays) {
    Settings settings;
    settings.size = side;
    settings.uv = UvSource::trust;
    settings.target_error = 0.01;
    const auto baked = [&] { return bake(floor_and_roof(), constant_sky(glm::vec3(1.0F)), settings, device()); };
    const LightMap plain = baked().light_maps.at(0);
    EXPECT_NEAR(true_error(plain), 0.01, 0.002); // the closed form fits the scene
    settings.denoise = Switch::on;
    const Bake bake = baked();
    const LightMap& denoised = bake.light_maps.at(0);
    EXPECT_LT(true_error(denoised), 0.013);
    EXPECT_LE(denoised.error->relative_rmse, 0.01);
    EXPECT_TRUE(denoised.error->target_reached);
    EXPECT_GT(denoised.error->noise_rmse, 0.01);
    EXPECT_LT(denoised.error->mean_rays, 0.7 * plain.error->mean_rays);
    EXPECT_EQ(bake.light_maps.at(0).statistics.denoised_texels > 0, true);
}

} // namespace
} // namespace vkbake::test
