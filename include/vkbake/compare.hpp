// The difference between two images, over the texels that both cover.
#pragma once

#include <cstdint>

#include "vkbake/image.hpp"
#include "vkbake/lightmap.hpp"

namespace vkbake {

/// Errors of RGB, each channel counting alike, and of luminance. Coverage (alpha where a file has no coverage) above ½
/// covers a texel.
struct Comparison {
    std::uint64_t covered_a = 0;
    std::uint64_t covered_b = 0;
    std::uint64_t covered_both = 0;
    std::uint64_t not_finite = 0;           ///< texels left out because a value of either is NaN or infinite
    double root_mean_square = 0.0;          ///< of the differences of all channels
    double relative_root_mean_square = 0.0; ///< root_mean_square ÷ mean of A's channels; 0 where both are 0
    double relative_luminance_rmse = 0.0; ///< of luminance (Rec. 709), ÷ its mean in A: as MapError::relative_rmse and
                                          ///< Settings::target_error have it; 0 where both are 0
    double mean_a = 0.0;                  ///< of all channels
    double mean_b = 0.0;
    double maximum = 0.0; ///< the largest absolute difference of a channel
    int maximum_x = 0;    ///< where it is
    int maximum_y = 0;
    Image difference; ///< RGB: |a − b| per channel, A: 1 where compared
};

/// Throws Error{bad_input} where the sizes differ or no texel is covered by both.
[[nodiscard]] Comparison compare(const Image& a, const Image& b);

/// How different two pictures look that render() made: the mean of CIEDE2000 (Sharma, Wu and Dalal 2005) over the
/// pixels that are not black in both; about 1 is the least difference of colours that is seen side by side. Pixel by
/// pixel: noise finer than the eye's resolution counts as well. Throws Error{bad_input} where the sizes differ.
[[nodiscard]] double color_difference(const Image& a, const Image& b);

/// How far a bake is from a better one of the same atlas, over the covered texels of all maps: luminance (Rec. 709).
struct BakeError {
    double relative_rmse = 0.0; ///< root-mean-square error ÷ the reference's mean, without what the
                                ///< reference's own error adds, where it was estimated
    double bias = 0.0;          ///< mean of bake − reference, ÷ the reference's mean
    double percentile_99 = 0.0; ///< of the absolute errors, ÷ the reference's mean
    double maximum = 0.0;       ///< of them, ÷ the reference's mean
};

/// Throws Error{usage} where the maps do not fit each other or the reference is black.
[[nodiscard]] BakeError compare_bakes(const Bake& bake, const Bake& reference);

} // namespace vkbake
