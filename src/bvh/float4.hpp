// Four floats at once, where the compiler's own instruction set will do: what the build needs of vectors.
#pragma once

#include <cstdint>
#include <cstring>

#include <glm/vec3.hpp>

namespace vkbake {

using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

[[nodiscard]] inline Float4 fill4(float value) { return Float4{value, value, value, value}; }
[[nodiscard]] inline Float4 load4(const float* four) {
    Float4 value;
    std::memcpy(&value, four, sizeof(value));
    return value;
}
[[nodiscard]] inline Float4 xyz0(const glm::vec3& v) { return Float4{v.x, v.y, v.z, 0.0F}; }
[[nodiscard]] inline glm::vec3 xyz_of(Float4 v) { return {v[0], v[1], v[2]}; }

/// Of a NaN in `a` nothing is left: the result is b.
[[nodiscard]] inline Float4 min4(Float4 a, Float4 b) { return a < b ? a : b; }
[[nodiscard]] inline Float4 max4(Float4 a, Float4 b) { return a > b ? a : b; }
/// Rounds towards 0.
[[nodiscard]] inline Int4 to_int(Float4 v) { return __builtin_convertvector(v, Int4); }
[[nodiscard]] inline Float4 to_float(Int4 v) { return __builtin_convertvector(v, Float4); }

} // namespace vkbake
