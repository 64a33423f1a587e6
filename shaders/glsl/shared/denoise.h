// What the denoising passes (denoise_guide.comp, denoise_fit.comp, denoise_choose.comp) and the CPU share.
#ifndef VKBAKE_SHARED_DENOISE_H
#define VKBAKE_SHARED_DENOISE_H

#ifdef __cplusplus
#include <cstdint>
namespace vkbake {
using uint = std::uint32_t;
#endif

// Side of a work group.
#define DENOISE_GROUP 8

// Texels on each side of the one that is looked at: in which means are taken, a plane is fitted, its risk is judged.
#define DENOISE_GUIDE_RADIUS 1
#define DENOISE_FIT_RADIUS 3
#define DENOISE_RISK_RADIUS 4
// From so far away a texel's result can depend on another.
#define DENOISE_BORDER (DENOISE_GUIDE_RADIUS + DENOISE_FIT_RADIUS + DENOISE_RISK_RADIUS)

// Two texels lie on one smooth piece of surface where the cosine between their normals is at least this, and the
// squared sine of the angle between the line through them and the plane across the mean of their normals at most that.
#define DENOISE_LEAST_COSINE 0.9f
#define DENOISE_MOST_SLOPE 0.0625f

// Squares of how many standard errors of their difference two texels, and the means around them, may lie apart.
#define DENOISE_TEXEL_SIGMAS 9.0f
#define DENOISE_GUIDE_SIGMAS 9.0f

// That a texel has in the mean around it, at least.
#define DENOISE_GUIDE_SHARE 0.111111112f

// Texels with less than this share of the map's mean variance are good already.
#define DENOISE_GOOD_SHARE 0.015625f

// Of a squared difference and of a squared length: what is less counts as none, whatever a device makes of denormals.
#define DENOISE_TINY 8.27180613e-25f

// Holds slopes down where the texels hardly show them: a row one texel wide has none across.
#define DENOISE_RIDGE 2.0f

// A risk that says: the texel is to stay as it was.
#define DENOISE_ALONE 3.0e38f

// Luminance (Rec. 709).
#define DENOISE_RED 0.2126f
#define DENOISE_GREEN 0.7152f
#define DENOISE_BLUE 0.0722f

// 1 / count, rounded once: division itself need not be rounded correctly on a device. Entry 0 is not used.
#define DENOISE_RECIPROCALS                                                                                            \
    { 0.0f, 1.0f, 0.5f, 0.333333343f, 0.25f, 0.200000003f, 0.166666672f, 0.142857149f, 0.125f, 0.111111112f }

struct DenoiseConstants {
    uint width; // texels that are looked at; the images may be larger
    uint height;
    float good; // variance below which a texel is left alone
};

#ifdef __cplusplus
} // namespace vkbake
#endif
#endif
