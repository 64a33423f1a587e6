// The colour difference against the test data that its authors publish.
#include "imageio/color_difference.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "vkbake/compare.hpp"
#include "vkbake/error.hpp"

namespace vkbake {
namespace {

TEST(ColorDifference, IsWhatSharmaWuAndDalalTabulate) {
    struct Row {
        glm::dvec3 a;
        glm::dvec3 b;
        double difference;
    };
    // Their table 1: around every discontinuity of hue, and pairs as printers measure them.
    const std::vector<Row> rows{
        {{50, 2.6772, -79.7751}, {50, 0, -82.7485}, 2.0425},
        {{50, 3.1571, -77.2803}, {50, 0, -82.7485}, 2.8615},
        {{50, 2.8361, -74.0200}, {50, 0, -82.7485}, 3.4412},
        {{50, -1.3802, -84.2814}, {50, 0, -82.7485}, 1.0},
        {{50, 0, 0}, {50, -1, 2}, 2.3669},
        {{50, -1, 2}, {50, 0, 0}, 2.3669},
        {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0009}, 7.1792},
        {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0010}, 7.1792},
        {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0011}, 7.2195},
        {{50, -0.0010, 2.4900}, {50, 0.0009, -2.4900}, 4.8045},
        {{50, -0.0010, 2.4900}, {50, 0.0011, -2.4900}, 4.7461},
        {{50, 2.5, 0}, {50, 0, -2.5}, 4.3065},
        {{50, 2.5, 0}, {73, 25, -18}, 27.1492},
        {{50, 2.5, 0}, {61, -5, 29}, 22.8977},
        {{50, 2.5, 0}, {56, -27, -3}, 31.9030},
        {{50, 2.5, 0}, {58, 24, 15}, 19.4535},
        {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
        {{63.0109, -31.0961, -5.8663}, {62.8187, -29.7946, -4.0864}, 1.2630},
        {{35.0831, -44.1164, 3.7933}, {35.0232, -40.0716, 1.5901}, 1.8645},
        {{22.7233, 20.0904, -46.6940}, {23.0331, 14.9730, -42.5619}, 2.0373},
        {{90.9257, -0.5406, -0.9208}, {88.6381, -0.8985, -0.7239}, 1.5381},
        {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082},
    };
    for (const Row& row : rows) {
        EXPECT_NEAR(ciede2000(row.a, row.b), row.difference, 0.00005);
        EXPECT_NEAR(ciede2000(row.b, row.a), row.difference, 0.00005);
    }
}

TEST(ColorDifference, LabHasItsWhiteAndItsGreys) {
    const glm::dvec3 white = lab_of(glm::dvec3(1.0));
    EXPECT_NEAR(white.x, 100.0, 1e-9);
    EXPECT_NEAR(white.y, 0.0, 1e-9);
    EXPECT_NEAR(white.z, 0.0, 1e-9);
    EXPECT_NEAR(lab_of(glm::dvec3(0.0)).x, 0.0, 1e-9);
    EXPECT_NEAR(lab_of(glm::dvec3(0.125)).x, 116.0 * 0.5 - 16.0, 1e-9); // the cube root of 1/8
}

TEST(ColorDifference, OfPicturesIsTheMeanOverWhatIsNotBlackInBoth) {
    const auto picture = [](float first, float second) {
        return Image{.width = 2,
                     .height = 2,
                     .texels = {glm::vec4(first, first, first, 1), glm::vec4(0, 0, 0, 1),
                                glm::vec4(second, second, second, 1), glm::vec4(0, 0, 0, 1)}};
    };
    // White beside black, and black beside black: 100 of lightness, over 1 + 0.015 · 0 at the middle of 50.
    EXPECT_NEAR(color_difference(picture(1.0F, 0.0F), picture(0.0F, 0.0F)), 100.0, 1e-6);
    EXPECT_NEAR(color_difference(picture(1.0F, 1.0F), picture(0.0F, 1.0F)), 50.0, 1e-6);
    EXPECT_EQ(color_difference(picture(0.0F, 0.0F), picture(0.0F, 0.0F)), 0.0);
    EXPECT_THROW((void)color_difference(picture(1.0F, 0.0F), Image{}), Error);
}

} // namespace
} // namespace vkbake
