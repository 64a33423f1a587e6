// How much work a test does.
#pragma once

namespace vkbake::test {

/// `full` in a plain build, `sanitized` where the address sanitizer makes all of it some twenty times slower. Only for
/// numbers of rays, texels and triangles: what is true of many is shown by the plain build, which runs beside it;
/// faults of memory and of arithmetic, which sanitizers look for, show with few.
template<typename Number>
constexpr Number amount([[maybe_unused]] Number full, [[maybe_unused]] Number sanitized) {
#ifdef __SANITIZE_ADDRESS__
    return sanitized;
#else
    return full;
#endif
}

/// Statistics are held to their bounds by the plain build alone where the sanitized amount is too small to tell.
inline constexpr bool few_samples = amount(false, true);

} // namespace vkbake::test
