// For which instruction sets the vector code is made: AVX-512, AVX2, SSE4 or NEON, and plain C++. Include it before
// Highway.
#pragma once

// Vectors of a length that is not known when compiling cannot be members of a struct; what has SSSE3 alone is rare. A
// build with sanitizers makes AVX2 and plain C++ alone: the others differ in how many vectors make a row, and compile
// for minutes.
#if defined(VKBAKE_SANITIZED)
#define HWY_DISABLED_TARGETS                                                                                           \
    (HWY_AVX3 | HWY_SSE4 | HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#else
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#endif
