// Equality of bits, where == would take a negative zero for zero and a NaN for nothing.
#pragma once

#include <algorithm>
#include <span>

namespace vkbake::test {

/// Of two contiguous ranges of plain values; empty ones too.
template<class First, class Second>
[[nodiscard]] bool same_bits(const First& a, const Second& b) {
    return std::ranges::equal(std::as_bytes(std::span(a)), std::as_bytes(std::span(b)));
}

} // namespace vkbake::test
