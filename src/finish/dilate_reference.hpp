// Dilation on the CPU: what the compute pass must equal, bit for bit.
#pragma once

#include <cstdint>

#include <glm/vec4.hpp>

#include "vkbake/image.hpp"

namespace vkbake {

/// A ≠ 0, decided by A's bits: a denormal or NaN counts as filled whatever the floating-point environment is.
[[nodiscard]] bool is_filled(const glm::vec4& texel);

/// `dilate` of dilate.hpp by the plainest means: whole image, two buffers, one thread. For tests.
std::uint64_t dilate_reference(Image& image, int rounds);

} // namespace vkbake
