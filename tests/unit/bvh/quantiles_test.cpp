#include "bvh/quantiles.hpp"

#include <functional>
#include <numeric>

#include <gtest/gtest.h>

#include "unit/bvh/ray_scenes.hpp"

namespace vkbake {
namespace {

/// Holds the quantiles against a full sort.
void expect_sorted_places(const std::vector<glm::vec3>& positions, std::size_t splits) {
    TriangleList list;
    list.numbers.resize(positions.size() / 3);
    std::iota(list.numbers.begin(), list.numbers.end(), 0U);
    list.ranks = list.numbers;
    const auto cuts = quantiles(ListedTriangles(positions, list), splits, 2);
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<float> sorted;
        sorted.reserve(positions.size());
        for (const glm::vec3& corner : positions) {
            sorted.push_back(corner[axis]);
        }
        std::sort(sorted.begin(), sorted.end());
        std::vector<float> expected;
        expected.reserve(splits - 1);
        for (std::size_t cut = 1; cut < splits; ++cut) {
            expected.push_back(sorted[cut * sorted.size() / splits]);
        }
        EXPECT_EQ(cuts[static_cast<std::size_t>(axis)], expected);
    }
}

std::vector<glm::vec3> corners(std::size_t triangles, const std::function<glm::vec3(std::size_t)>& corner) {
    std::vector<glm::vec3> positions;
    for (std::size_t i = 0; i < 3 * triangles; ++i) {
        positions.push_back(corner(i));
    }
    return positions;
}

TEST(Quantiles, AreThePlacesOfAFullSort) {
    for (const std::size_t splits : {1U, 2U, 4U, 7U, 64U}) {
        expect_sorted_places(test::soup_positions(1, 0.1F, 1), splits);
        expect_sorted_places(test::soup_positions(500, 0.1F, 2), splits);
        expect_sorted_places(test::soup_positions(20000, 0.1F, 3), splits);
    }
}

TEST(Quantiles, OfEqualAndOfFarCoordinates) {
    test::Random random(4);
    expect_sorted_places(corners(20000,
                                 [&](std::size_t i) {
                                     return glm::vec3(1.0F, static_cast<float>(i % 5),
                                                      i == 7 ? 1e38F : random.point().z);
                                 }),
                         4);
}

TEST(Quantiles, WhereASampleMisleads) {
    // every eighth triangle, so all that a sample of every eighth or sixteenth sees, lies above or below all the others
    test::Random random(5);
    for (const float place : {-9.0F, 9.0F}) {
        expect_sorted_places(
            corners(40000, [&](std::size_t i) { return i / 3 % 8 == 0 ? glm::vec3(place) : random.point(); }), 4);
    }
}

} // namespace
} // namespace vkbake
