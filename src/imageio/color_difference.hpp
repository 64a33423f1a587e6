// How different two colours look.
#pragma once

#include <glm/vec3.hpp>

namespace vkbake {

/// CIE 1976 L*a*b* of linear sRGB, its white (D65) being L* = 100, a* = b* = 0.
[[nodiscard]] glm::dvec3 lab_of(const glm::dvec3& linear);

/// CIEDE2000 of two L*a*b* colours, all weights 1: about 1 is the least difference that is seen side by side.
/// G. Sharma, W. Wu, E. Dalal: The CIEDE2000 Color-Difference Formula. Color Research and Application 30(1), 2005.
[[nodiscard]] double ciede2000(const glm::dvec3& a, const glm::dvec3& b);

} // namespace vkbake
