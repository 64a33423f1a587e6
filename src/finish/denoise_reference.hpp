// Denoising on the CPU: what the compute passes must equal, bit for bit.
#pragma once

#include "finish/denoise_fields.hpp"

namespace vkbake {

/// The passes of denoise.hpp by the plainest means: whole map, one thread. For tests.
[[nodiscard]] DenoisedTexels denoise_reference(const DenoiseFields& fields);

/// 1 / x of additions and multiplications alone, so that every device gets the same bits: Newton's iteration from a
/// guess by the exponent. x: 2^-100 … 2^100. Good to two units in the last place.
[[nodiscard]] float plain_reciprocal(float x);
/// 1 / √x, likewise.
[[nodiscard]] float plain_root_reciprocal(float x);

} // namespace vkbake
