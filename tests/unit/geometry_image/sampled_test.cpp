// Parts of a page, against the whole one, which rules_test.cpp and draw_test.cpp hold to its own truth.
#include <cstddef>

#include <gtest/gtest.h>

#include "geometry_image/reference.hpp"
#include "unit/geometry_image/surfaces.hpp"

namespace vkbake {
namespace {

TEST(SampledGeometryImage, SquaresAreWhatThePageHasThere) {
    const test::MappedSurface mapped = test::map_triangles(test::make_triangles(test::Kind::mixed, 400, 11), 131, 97);
    const GeometryImage whole = reference_geometry_image(mapped.surface, mapped.atlas, 0);
    constexpr int side = 8;
    const auto takes = [](int x, int y) { return (3 * x + y) % 5 == 0; };
    const GeometryImage part = sampled_geometry_image(mapped.surface, mapped.atlas, 0, side, takes);
    int square = 0;
    for (int y = 0; y * side < whole.height; ++y) {
        for (int x = 0; x * side < whole.width; ++x) {
            if (!takes(x, y)) {
                continue;
            }
            for (int texel = 0; texel < side * side; ++texel) {
                const int column = texel % side;
                const int row = texel / side;
                const auto of_part = static_cast<std::size_t>(row) * static_cast<std::size_t>(part.width) +
                                     static_cast<std::size_t>(square * side + column);
                const bool inside = x * side + column < whole.width && y * side + row < whole.height;
                const auto of_whole = static_cast<std::size_t>(y * side + row) * static_cast<std::size_t>(whole.width) +
                                      static_cast<std::size_t>(x * side + column);
                ASSERT_EQ(part.triangle[of_part], inside ? whole.triangle[of_whole] : GeometryImage::empty);
                if (inside) {
                    EXPECT_EQ(part.position[of_part], whole.position[of_whole]);
                    EXPECT_EQ(part.shading_normal[of_part], whole.shading_normal[of_whole]);
                    EXPECT_EQ(part.geometric_normal[of_part], whole.geometric_normal[of_whole]);
                }
            }
            ++square;
        }
    }
    EXPECT_EQ(part.width, square * side);
    EXPECT_GT(square, 4);
}

TEST(SampledGeometryImage, OfNothingThereIsNothing) {
    const test::MappedSurface mapped = test::map_triangles(test::make_triangles(test::Kind::mixed, 4, 1), 32, 32);
    EXPECT_EQ(sampled_geometry_image(mapped.surface, mapped.atlas, 0, 8, [](int, int) { return false; }).texel_count(),
              0U);
}

} // namespace
} // namespace vkbake
