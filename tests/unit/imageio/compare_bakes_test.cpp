#include "vkbake/compare.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "vkbake/error.hpp"

namespace vkbake {
namespace {

/// One map of four texels, the last not covered.
Bake grey_bake(float first, float second, float third) {
    Bake bake;
    LightMap map{.image = {2, 2, {}, {1.0F, 1.0F, 1.0F, 0.0F}}};
    for (const float value : {first, second, third, 100.0F}) {
        map.image.texels.emplace_back(value, value, value, 1.0F);
    }
    bake.light_maps.push_back(map);
    return bake;
}

TEST(CompareBakes, TellsErrorsOfLuminanceOverTheMean) {
    const BakeError error = compare_bakes(grey_bake(1.0F, 2.5F, 4.0F), grey_bake(1.0F, 2.0F, 3.0F));
    EXPECT_NEAR(error.relative_rmse, std::sqrt((0.25 + 1.0) / 3.0) / 2.0, 1e-6);
    EXPECT_NEAR(error.bias, 0.5 / 2.0, 1e-6);
    EXPECT_NEAR(error.percentile_99, 1.0 / 2.0, 1e-6);
    EXPECT_NEAR(error.maximum, 1.0 / 2.0, 1e-6);
}

TEST(CompareBakes, TakesOffWhatTheReferenceItselfErrs) {
    Bake reference = grey_bake(1.0F, 2.0F, 3.0F);
    reference.light_maps[0].error = MapError{.relative_rmse = 0.1}; // 0.2 of a texel
    const BakeError error = compare_bakes(grey_bake(1.0F, 2.5F, 4.0F), reference);
    EXPECT_NEAR(error.relative_rmse, std::sqrt((0.25 + 1.0) / 3.0 - 0.04) / 2.0, 1e-6);
}

TEST(CompareBakes, RefusesWhatDoesNotFit) {
    EXPECT_THROW((void)compare_bakes(grey_bake(1.0F, 1.0F, 1.0F), Bake()), Error);
    EXPECT_THROW((void)compare_bakes(grey_bake(1.0F, 1.0F, 1.0F), grey_bake(0.0F, 0.0F, 0.0F)), Error);
}

} // namespace
} // namespace vkbake
