#include "surface/canonical.hpp"

#include <algorithm>
#include <compare>
#include <numeric>

namespace vkbake {
namespace {

/// All coordinates are finite and no zero is negative, so the order is total.
std::strong_ordering order(const glm::vec3& a, const glm::vec3& b) {
    for (int axis = 0; axis < 3; ++axis) {
        if (a[axis] != b[axis]) {
            return a[axis] < b[axis] ? std::strong_ordering::less : std::strong_ordering::greater;
        }
    }
    return std::strong_ordering::equal;
}

std::strong_ordering order_of_corners(const std::vector<glm::vec3>& values, std::uint32_t a, std::uint32_t b) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const auto result = order(values[3 * std::size_t{a} + corner], values[3 * std::size_t{b} + corner]);
        if (result != std::strong_ordering::equal) {
            return result;
        }
    }
    return std::strong_ordering::equal;
}

} // namespace

int first_corner(const std::array<glm::vec3, 3>& positions, const std::array<glm::vec3, 3>& normals) {
    const auto less = [&](std::size_t a, std::size_t b) {
        for (const auto* values : {&positions, &normals}) {
            for (std::size_t step = 0; step < 3; ++step) {
                const auto result = order((*values)[(a + step) % 3], (*values)[(b + step) % 3]);
                if (result != std::strong_ordering::equal) {
                    return result == std::strong_ordering::less;
                }
            }
        }
        return false;
    };
    std::size_t first = 0;
    for (std::size_t corner = 1; corner < 3; ++corner) {
        if (less(corner, first)) {
            first = corner;
        }
    }
    return static_cast<int>(first);
}

std::vector<std::uint32_t> canonical_order(const std::vector<glm::vec3>& positions,
                                           const std::vector<glm::vec3>& normals) {
    std::vector<std::uint32_t> result(positions.size() / 3);
    std::iota(result.begin(), result.end(), 0U);
    std::sort(result.begin(), result.end(), [&](std::uint32_t a, std::uint32_t b) {
        auto compared = order_of_corners(positions, a, b);
        if (compared == std::strong_ordering::equal) {
            compared = order_of_corners(normals, a, b);
        }
        return compared == std::strong_ordering::equal ? a < b : compared == std::strong_ordering::less;
    });
    return result;
}

} // namespace vkbake
