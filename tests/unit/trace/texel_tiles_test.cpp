#include "trace/texel_tiles.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "base/random.hpp"
#include "vkbake/error.hpp"

namespace vkbake {
namespace {

GeometryImage empty_image(int width, int height) {
    GeometryImage image;
    image.width = width;
    image.height = height;
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    image.triangle.assign(count, GeometryImage::empty);
    image.position = ZeroedArray<glm::vec3>(count);
    image.shading_normal = ZeroedArray<glm::vec3>(count);
    image.geometric_normal = ZeroedArray<glm::vec3>(count);
    return image;
}

void cover(GeometryImage& image, int x, int y, const glm::vec3& position, const glm::vec3& normal) {
    const auto texel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
    image.triangle[texel] = 0;
    image.position[texel] = position;
    image.shading_normal[texel] = image.geometric_normal[texel] = normal;
}

void expect_every_covered_texel_once(const GeometryImage& image, const std::vector<TexelTile>& tiles) {
    std::vector<int> held(image.texel_count(), 0);
    for (const TexelTile& tile : tiles) {
        ASSERT_GE(tile.count, 1U);
        ASSERT_LE(tile.count, 16U);
        for (std::uint32_t i = 0; i < tile.count; ++i) {
            ++held.at(tile.texels[i]);
        }
    }
    for (std::size_t texel = 0; texel < held.size(); ++texel) {
        EXPECT_EQ(held[texel], image.triangle[texel] == GeometryImage::empty ? 0 : 1) << texel;
    }
}

TEST(TexelTiles, AFlatChartFallsIntoSquares) {
    GeometryImage image = empty_image(32, 24);
    for (int y = 0; y < 24; ++y) {
        for (int x = 0; x < 32; ++x) {
            cover(image, x, y, {0.01F * static_cast<float>(x), 0, 0.01F * static_cast<float>(y)}, {0, 1, 0});
        }
    }
    const std::vector<TexelTile> tiles = make_tiles(image, 1);
    expect_every_covered_texel_once(image, tiles);
    ASSERT_EQ(tiles.size(), 48U);
    EXPECT_EQ(occupancy(tiles), 1.0);
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const std::uint32_t corner = tiles[i].texels[0];
        EXPECT_EQ(tiles[i].texels[15], corner + 3 + 3 * 32);
        if (i > 0) { // neighbours follow each other, but for the curve's jumps
            EXPECT_LT(glm::distance(image.position[corner], image.position[tiles[i - 1].texels[0]]), 0.25F);
        }
    }
}

/// Charts of 2 × 3 texels all over the map, each a piece of one of two planes: alone they would fill 6 of 16 lanes.
TEST(TexelTiles, SmallChartsShareTiles) {
    GeometryImage image = empty_image(128, 128);
    std::uint64_t key = 0;
    for (int top = 0; top + 3 <= 128; top += 5) {
        for (int left = 0; left + 2 <= 128; left += 4) {
            const bool floor = mix64(++key) % 2 == 0;
            // Somewhere on the plane, wherever it is in the map.
            const auto u = static_cast<float>(mix64(++key) % 60);
            const auto v = static_cast<float>(mix64(++key) % 60);
            for (int y = 0; y < 3; ++y) {
                for (int x = 0; x < 2; ++x) {
                    const float p = 0.01F * (u + static_cast<float>(x));
                    const float q = 0.01F * (v + static_cast<float>(y));
                    cover(image, left + x, top + y, floor ? glm::vec3(p, 0, q) : glm::vec3(0, p, q),
                          floor ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0));
                }
            }
        }
    }
    const std::vector<TexelTile> tiles = make_tiles(image, 1);
    expect_every_covered_texel_once(image, tiles);
    EXPECT_GT(occupancy(tiles), 0.9);
    for (const TexelTile& tile : tiles) {
        for (std::uint32_t i = 1; i < tile.count; ++i) {
            EXPECT_EQ(image.shading_normal[tile.texels[i]], image.shading_normal[tile.texels[0]]);
        }
    }
}

TEST(TexelTiles, NormalsOfATileAreAlikeAndItsPlacesNear) {
    GeometryImage image = empty_image(64, 64); // a ball, in a map with a cut down its middle
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            const double theta = (y + 0.5) / 64.0 * 3.14159;
            const double phi = (x + 0.5) / 64.0 * 6.28318 + (x >= 30 ? 2.0 : 0.0);
            const glm::vec3 normal(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
            cover(image, x, y, 0.7F * normal, normal);
        }
    }
    const std::vector<TexelTile> tiles = make_tiles(image, 1);
    expect_every_covered_texel_once(image, tiles);
    EXPECT_GT(occupancy(tiles), 0.85);
    for (const TexelTile& tile : tiles) {
        for (std::uint32_t i = 1; i < tile.count; ++i) {
            EXPECT_GT(glm::dot(image.shading_normal[tile.texels[i]], image.shading_normal[tile.texels[0]]), 0.76F);
            EXPECT_LT(glm::distance(image.position[tile.texels[i]], image.position[tile.texels[0]]), 0.6F);
        }
    }
}

TEST(TexelTiles, RefusesAnImageThatContradictsItself) {
    GeometryImage image = empty_image(4, 4);
    EXPECT_TRUE(make_tiles(image, 0).empty());
    EXPECT_EQ(occupancy({}), 1.0);
    cover(image, 1, 1, {0, 0, 0}, {0, 1, 0});
    EXPECT_EQ(make_tiles(image, 1).size(), 1U);
    EXPECT_THROW((void)make_tiles(image, 0), Error);
    image.position = ZeroedArray<glm::vec3>(image.texel_count() - 1);
    EXPECT_THROW((void)make_tiles(image, 1), Error);
}

} // namespace
} // namespace vkbake
