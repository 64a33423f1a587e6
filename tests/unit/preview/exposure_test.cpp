#include "preview/exposure.hpp"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace {

using vkbake::Image;

Image map_of(std::vector<glm::vec4> texels, std::vector<float> coverage = {}) {
    const auto width = static_cast<int>(texels.size());
    return {.width = width, .height = 1, .texels = std::move(texels), .coverage = std::move(coverage)};
}

TEST(PreviewExposure, MeanIsOverBakedFiniteTexels) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const Image covered =
        map_of({{1.0F, 2.0F, 3.0F, 1.0F}, {9.0F, 9.0F, 9.0F, 1.0F}, {nan, 1.0F, 1.0F, 1.0F}}, {1.0F, 0.0F, 1.0F});
    const Image plain = map_of({{3.0F, 2.0F, 1.0F, 1.0F}, {9.0F, 9.0F, 9.0F, 0.0F}});
    EXPECT_EQ(vkbake::mean_light({covered, plain}), glm::dvec3(2.0));
}

TEST(PreviewExposure, BlackTexelsDoNotCount) {
    std::vector<glm::vec4> texels(1000, glm::vec4(0.0F, 0.0F, 0.0F, 1.0F));
    texels[3] = texels[500] = glm::vec4(2.0F);
    EXPECT_EQ(vkbake::mean_light({map_of(texels)}), glm::dvec3(2.0));
}

TEST(PreviewExposure, ScalesInverselyWithTheLight) {
    EXPECT_NEAR(vkbake::metered_exposure(std::vector{glm::vec4(1000.0F)}).value() * 1000.0, 0.4, 1e-6);
    EXPECT_NEAR(vkbake::metered_exposure(std::vector{glm::vec4(0.001F)}).value() * 0.001, 0.4, 1e-6);
}

TEST(PreviewExposure, MetersTheGeometricMeanOfLuminances) {
    // Rec. 709: green of 1 ÷ 0.7152 is as bright as white of 1.
    const std::vector<glm::vec4> light{{0.25F, 0.25F, 0.25F, 1.0F}, {0.0F, 1.0F / 0.7152F, 0.0F, 1.0F}};
    EXPECT_NEAR(vkbake::metered_exposure(light).value(), 0.4 / 0.5, 1e-6);
}

TEST(PreviewExposure, NeitherSkyNorBlackNorNanCounts) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<glm::vec4> light{{2.0F, 2.0F, 2.0F, 1.0F},
                                       {90.0F, 90.0F, 90.0F, 0.0F},
                                       {nan, 1.0F, 1.0F, 1.0F},
                                       {0.0F, 0.0F, 0.0F, 1.0F},
                                       {0.009F, 0.009F, 0.009F, 1.0F}};
    EXPECT_NEAR(vkbake::metered_exposure(light).value(), 0.4 / 2.0, 1e-6);
}

TEST(PreviewExposure, DarknessHasNone) {
    EXPECT_FALSE(vkbake::metered_exposure({}).has_value());
    EXPECT_FALSE(vkbake::metered_exposure(std::vector{glm::vec4(0.0F, 0.0F, 0.0F, 1.0F)}).has_value());
}

} // namespace
