#include "atlas/predicates.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vkbake {

namespace {

/// The exact sign of a sum of six doubles: Shewchuk's GROW-EXPANSION, a term at a time. The components stay
/// non-overlapping and ascend in magnitude, so the greatest one that is not 0 has the sum's sign.
int sign_of_sum(const std::array<double, 6>& terms) {
    std::array<double, 6> expansion{};
    std::size_t count = 0;
    for (const double term : terms) {
        double carry = term;
        for (std::size_t i = 0; i < count; ++i) {
            // TWO-SUM (Knuth): sum + error is exactly carry + expansion[i].
            const double sum = carry + expansion[i];
            const double second = sum - carry;
            const double error = (carry - (sum - second)) + (expansion[i] - second);
            expansion[i] = error;
            carry = sum;
        }
        expansion[count++] = carry;
    }
    for (std::size_t i = count; i-- > 0;) {
        if (expansion[i] != 0.0) {
            return expansion[i] > 0.0 ? 1 : -1;
        }
    }
    return 0;
}

} // namespace

int orientation(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c) {
    const double ax = a.x;
    const double ay = a.y;
    const double bx = b.x;
    const double by = b.y;
    const double cx = c.x;
    const double cy = c.y;

    // Shewchuk's ccwerrboundA, (3 + 16ε)ε with ε = 2⁻⁵³.
    constexpr double epsilon = 0x1p-53;
    constexpr double relative_error = (3.0 + 16.0 * epsilon) * epsilon;
    const double left = (ax - cx) * (by - cy);
    const double right = (ay - cy) * (bx - cx);
    const double determinant = left - right;
    const double bound = relative_error * (std::abs(left) + std::abs(right));
    if (determinant > bound) {
        return 1;
    }
    if (determinant < -bound) {
        return -1;
    }
    // The common case of shared corners. Products of differences of floats do not underflow, so these zeros are exact.
    if (left == 0.0 && right == 0.0) {
        return 0;
    }
    // A product of two floats is exact in double, so the expanded determinant is a sum of six doubles.
    return sign_of_sum({ax * by, -(ay * bx), bx * cy, -(by * cx), cx * ay, -(cy * ax)});
}

bool triangles_overlap(const FlatTriangle& first, const FlatTriangle& second) {
    for (int axis = 0; axis < 2; ++axis) {
        const auto [first_low, first_high] = std::minmax({first[0][axis], first[1][axis], first[2][axis]});
        const auto [second_low, second_high] = std::minmax({second[0][axis], second[1][axis], second[2][axis]});
        if (first_high <= second_low || second_high <= first_low) {
            return false;
        }
    }
    const int first_turn = orientation(first);
    const int second_turn = orientation(second);
    // Two convex polygons whose interiors are apart are separated by a line along an edge of one of them.
    return first_turn != 0 && second_turn != 0 && !separated_by_edge(first, first_turn, second) &&
           !separated_by_edge(second, second_turn, first);
}

} // namespace vkbake
