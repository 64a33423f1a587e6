#include "preview/exposure.hpp"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace {

using vkbake::Image;

Image map_of(std::vector<glm::vec4> texels, std::vector<float> coverage = {}) {
    return {.width = static_cast<int>(texels.size()),
            .height = 1,
            .texels = std::move(texels),
            .coverage = std::move(coverage)};
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
    const double noon = vkbake::automatic_exposure({map_of({glm::vec4(1000.0F)})});
    const double night = vkbake::automatic_exposure({map_of({glm::vec4(0.001F)})});
    EXPECT_NEAR(noon * 1000.0, 0.4, 1e-6);
    EXPECT_NEAR(night * 0.001, 0.4, 1e-6);
}

TEST(PreviewExposure, DarknessStaysDark) {
    EXPECT_EQ(vkbake::automatic_exposure({}), 1.0);
    EXPECT_EQ(vkbake::automatic_exposure({map_of({{0.0F, 0.0F, 0.0F, 1.0F}})}), 1.0);
}

} // namespace
