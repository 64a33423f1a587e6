// What the dilation pass (dilate.comp) and the CPU share.
#ifndef VKBAKE_SHARED_DILATE_H
#define VKBAKE_SHARED_DILATE_H

#ifdef __cplusplus
#include <cstdint>
namespace vkbake {
using uint = std::uint32_t;
#endif

// Side of a work group.
#define DILATE_GROUP 8

// Magnitudes below 2^-120 count as 0 in sums: whether a device keeps or flushes denormals then makes no difference, since
// no product with a reciprocal below comes near them.
#define DILATE_TINY 7.52316385e-37f

// 1 / count, rounded once: division itself need not be rounded correctly on a device. Entry 0 is not used.
#define DILATE_RECIPROCALS {0.0f, 1.0f, 0.5f, 0.333333343f, 0.25f, 0.200000003f, 0.166666672f, 0.142857149f, 0.125f}

struct DilateConstants {
    uint width; // texels that are looked at; the images may be larger
    uint height;
    uint round; // from 0
};

#ifdef __cplusplus
} // namespace vkbake
#endif
#endif
