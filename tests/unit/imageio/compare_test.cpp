#include <cmath>
#include <limits>

#include "test_images.hpp"
#include "vkbake/compare.hpp"

namespace vkbake {
namespace {

using test::filled;
using test::message_of;

// Differences 1, 2, 3 in one texel of two: squares sum to 14 over 6 channels; A's channels sum to 1+2+3+4+4+4 = 18.
TEST(Compare, NumbersByHand) {
    const Image a{2, 1, {{1, 2, 3, 1}, {4, 4, 4, 1}}, {}};
    const Image b{2, 1, {{2, 4, 0, 1}, {4, 4, 4, 1}}, {}};
    const Comparison result = compare(a, b);
    EXPECT_EQ(result.covered_a, 2U);
    EXPECT_EQ(result.covered_b, 2U);
    EXPECT_EQ(result.covered_both, 2U);
    EXPECT_DOUBLE_EQ(result.root_mean_square, std::sqrt(14.0 / 6.0));
    EXPECT_DOUBLE_EQ(result.mean_a, 3.0);
    EXPECT_DOUBLE_EQ(result.mean_b, 3.0);
    EXPECT_DOUBLE_EQ(result.relative_root_mean_square, std::sqrt(14.0 / 6.0) / 3.0);
    EXPECT_DOUBLE_EQ(result.maximum, 3.0);
    EXPECT_EQ(result.maximum_x, 0);
    EXPECT_EQ(result.maximum_y, 0);
    EXPECT_EQ(result.difference.texels[0], glm::vec4(1, 2, 3, 1));
    EXPECT_EQ(result.difference.texels[1], glm::vec4(0, 0, 0, 1));
}

// Rec. 709: of red 0.2126, of green 0.7152, of blue 0.0722. A's luminances are 2 and 4.
TEST(Compare, LuminanceByHand) {
    const Image a{2, 1, {{2, 2, 2, 1}, {4, 4, 4, 1}}, {}};
    const Image bluer{2, 1, {{2, 2, 3, 1}, {4, 4, 4, 1}}, {}};
    EXPECT_NEAR(compare(a, bluer).relative_luminance_rmse, 0.0722 / std::sqrt(2.0) / 3.0, 1e-12);
    const Image balanced{2, 1, {{2.0F + 0.7152F, 2.0F - 0.2126F, 2, 1}, {4, 4, 4, 1}}, {}}; // as bright
    EXPECT_NEAR(compare(a, balanced).relative_luminance_rmse, 0.0, 1e-7);
    EXPECT_GT(compare(a, balanced).relative_root_mean_square, 0.05);
    const Image brighter{2, 1, {{3, 3, 3, 1}, {2, 2, 2, 1}}, {}};
    EXPECT_NEAR(compare(a, brighter).relative_luminance_rmse, std::sqrt((1.0 + 4.0) / 2.0) / 3.0, 1e-12);
}

TEST(Compare, CoverageStandsAboveAlphaAndAlphaCountsWhereThereIsNone) {
    Image a = filled(2, 2, glm::vec4(1.0F));
    a.coverage = {1, 1, 0, 1};
    Image b = filled(2, 2, glm::vec4(1.0F));
    b.texels[0] = {50, 50, 50, 0}; // not covered by b
    b.texels[2] = {9, 9, 9, 1};    // dilated in a
    b.texels[3] = {1, 1.5F, 1, 1};
    const Comparison result = compare(a, b);
    EXPECT_EQ(result.covered_a, 3U);
    EXPECT_EQ(result.covered_b, 3U);
    EXPECT_EQ(result.covered_both, 2U);
    EXPECT_DOUBLE_EQ(result.root_mean_square, std::sqrt(0.25 / 6.0));
    EXPECT_EQ(result.maximum_x, 1);
    EXPECT_EQ(result.maximum_y, 1);
    EXPECT_EQ(result.difference.texels[0].w, 0.0F);
}

TEST(Compare, LeavesOutAndCountsWhatIsNotFinite) {
    Image a = filled(3, 1, glm::vec4(2.0F, 2.0F, 2.0F, 1.0F));
    Image b = a;
    a.texels[0].y = std::numeric_limits<float>::quiet_NaN();
    b.texels[1].z = std::numeric_limits<float>::infinity();
    const Comparison result = compare(a, b);
    EXPECT_EQ(result.not_finite, 2U);
    EXPECT_EQ(result.root_mean_square, 0.0);
    EXPECT_EQ(result.mean_a, 2.0);
    EXPECT_EQ(result.difference.texels[0], glm::vec4(0.0F));
}

TEST(Compare, RelativeErrorOfBlack) {
    const Image black = filled(2, 2, {0, 0, 0, 1});
    EXPECT_EQ(compare(black, black).relative_root_mean_square, 0.0);
    EXPECT_EQ(compare(black, black).relative_luminance_rmse, 0.0);
    const Comparison result = compare(black, filled(2, 2, glm::vec4(1.0F)));
    EXPECT_EQ(result.relative_root_mean_square, std::numeric_limits<double>::infinity());
    EXPECT_EQ(result.relative_luminance_rmse, std::numeric_limits<double>::infinity());
}

TEST(Compare, RefusesWhatHasNothingInCommon) {
    const Image one = filled(2, 2, glm::vec4(1.0F));
    message_of(ErrorKind::bad_input, [&] { (void)compare(one, filled(2, 3, glm::vec4(1.0F))); });
    message_of(ErrorKind::bad_input, [&] { (void)compare(one, filled(2, 2, glm::vec4(0.0F))); });
    const float nan = std::numeric_limits<float>::quiet_NaN();
    message_of(ErrorKind::bad_input, [&] { (void)compare(one, filled(2, 2, {nan, 0, 0, 1})); });
}

} // namespace
} // namespace vkbake
