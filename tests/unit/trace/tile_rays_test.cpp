#include "trace/tile_rays.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include "base/random.hpp"
#include "base/sampling_sobol.hpp"
#include "closed_form/hand_made.hpp"
#include "highway_targets.hpp"
#include "trace/ray_origin.hpp"

namespace vkbake {
namespace {

constexpr float no_limit = std::numeric_limits<float>::infinity();

float number_of(std::uint64_t key) {
    return static_cast<float>(static_cast<double>(mix64(key) >> 11U) * 0x1p-53 * 2.0 - 1.0);
}

glm::vec3 unit(std::uint64_t key) {
    return glm::normalize(glm::vec3(number_of(3 * key), number_of(3 * key + 1), number_of(3 * key + 2)));
}

/// `count` texels that face every way, shaded up to some 30° off their triangle.
struct Texels {
    Surface surface;
    GeometryImage geometry;
};
Texels texels_facing_every_way(std::uint32_t count) {
    test::SurfaceMaker maker;
    for (std::uint64_t i = 0; i < count; ++i) {
        maker.add(0.9F * unit(7 * i), 0.9F * unit(7 * i + 1), 0.9F * unit(7 * i + 2));
    }
    const Surface surface = maker.finish();
    std::vector<test::SamplePoint> points;
    for (std::uint32_t i = 0; i < count; ++i) {
        points.push_back(test::point_on(surface, i, {0.4, 0.3, 0.3}));
        points.back().shading_normal = glm::normalize(points.back().geometric_normal + 0.5F * unit(1000 + i));
    }
    return {surface, test::geometry_image(points, 7)};
}

TexelTile tile_of(std::uint32_t first, std::uint32_t count) {
    TexelTile tile;
    for (tile.count = 0; tile.count < count; ++tile.count) {
        tile.texels[tile.count] = first + tile.count;
    }
    return tile;
}

glm::vec3 direction_in(const RayBlock& block, std::size_t stratum, std::size_t lane) {
    return {block.direction[stratum][0][lane], block.direction[stratum][1][lane], block.direction[stratum][2][lane]};
}

/// Shirley and Chiu's map and Malley's lift in double and library functions.
glm::dvec3 reference_direction(const SquarePoint& point, const glm::vec3& normal) {
    const double x = (2.0 * point.x + 1.0) * 0x1p-24 - 1.0;
    const double y = (2.0 * point.y + 1.0) * 0x1p-24 - 1.0;
    const bool wide = std::abs(x) > std::abs(y);
    const double radius = wide ? x : y;
    const double angle = std::numbers::pi / 4.0 * (wide ? y / x : x / y);
    const glm::dvec2 disc =
        radius * (wide ? glm::dvec2(std::cos(angle), std::sin(angle)) : glm::dvec2(std::sin(angle), std::cos(angle)));
    const OrthonormalFrame frame = orthonormal_frame(normal);
    return disc.x * glm::dvec3(frame.tangent) + disc.y * glm::dvec3(frame.bitangent) +
           std::sqrt(1.0 - radius * radius) * glm::dvec3(frame.normal);
}

TEST(CosineStrata, EachSixteenAreASquareOfCells) {
    for (const std::uint32_t rays : {1U, 3U, 4U, 15U, 16U, 63U, 64U, 256U, 1023U, 1024U, 4096U, 100000U}) {
        const CosineStrata strata(rays);
        const unsigned side = 1U << strata.bits();
        EXPECT_LE(side * side, rays);
        EXPECT_TRUE(4 * side * side > rays || side == 64) << rays;
        EXPECT_GE(strata.count(), rays);
        EXPECT_LT(strata.count(), rays + side * side);
        std::set<std::pair<int, int>> cells;
        for (std::uint32_t first = 0; first < side * side; first += 16) {
            int low_column = 64;
            int low_row = 64;
            int high_column = 0;
            int high_row = 0;
            for (std::uint32_t i = first; i < std::min(first + 16, side * side); ++i) {
                const CosineStrata::Cell cell = strata.cell(i);
                cells.emplace(cell.column, cell.row);
                low_column = std::min<int>(low_column, cell.column);
                high_column = std::max<int>(high_column, cell.column);
                low_row = std::min<int>(low_row, cell.row);
                high_row = std::max<int>(high_row, cell.row);
            }
            EXPECT_LT(high_column - low_column, 4);
            EXPECT_LT(high_row - low_row, 4);
        }
        EXPECT_EQ(cells.size(), side * side);
        EXPECT_LT(std::max_element(cells.begin(), cells.end())->first, static_cast<int>(side));
    }
}

/// Every stratum's ray is the sample of the texel's sequence that lies in the stratum's cell, to a float's precision:
/// so each cell is met once a round, each of the `rays` samples once, and none beyond them.
TEST(TileRays, AreTheSamplesOfTheSequenceCellByCell) {
    const Texels texels = texels_facing_every_way(16);
    for (const std::uint32_t rays : {1U, 2U, 3U, 4U, 5U, 15U, 16U, 50U, 64U, 100U, 255U, 256U, 257U, 1000U, 5000U}) {
        Settings settings;
        settings.rays = rays;
        settings.seed = 77;
        const RayPlan plan(settings, no_limit);
        const CosineStrata strata(rays);
        TileRays tile(texels.surface, texels.geometry, plan);
        tile.begin(tile_of(0, 16));
        std::vector<std::array<int, 16>> met(rays, std::array<int, 16>{});
        std::uint64_t asked = 0;
        for (std::size_t block = 0; block < plan.block_count(); ++block) {
            const RayBlock& some = tile.make(block);
            asked += tile.asked();
            for (std::size_t i = 0; i < RayBlock::strata; ++i) {
                const std::uint64_t stratum = block * RayBlock::strata + i;
                const std::uint32_t round = strata.round(stratum);
                const unsigned shift = 24U - strata.bits();
                for (std::uint32_t lane = 0; lane < 16; ++lane) {
                    const ScrambledSobol points(texel_scramble(settings.seed, lane % 7, lane / 7));
                    const bool active = ((some.active[i] >> lane) & 1U) != 0;
                    std::uint32_t index = round << (2 * strata.bits());
                    const std::uint32_t end = index + (1U << (2 * strata.bits()));
                    const CosineStrata::Cell cell = strata.cell(stratum);
                    while (index < end && (points.point(index).x >> shift != cell.column ||
                                           points.point(index).y >> shift != cell.row)) {
                        ++index;
                    }
                    ASSERT_LT(index, end);
                    if (index >= rays) {
                        ASSERT_FALSE(active);
                        continue;
                    }
                    ++met[index][lane];
                    const glm::dvec3 expected =
                        reference_direction(points.point(index), texels.geometry.shading_normal[lane]);
                    const glm::vec3 found = direction_in(some, i, lane);
                    ASSERT_LT(glm::distance(glm::dvec3(found), expected), 4e-7) << rays << " rays, sample " << index;
                    ASSERT_NEAR(glm::length(glm::dvec3(found)), 1.0, 0x1p-21);
                    const double above = glm::dot(expected, glm::dvec3(texels.geometry.geometric_normal[lane]));
                    if (std::abs(above) > 1e-6) {
                        ASSERT_EQ(active, above > 0.0);
                    }
                }
            }
            if (rays > 1000 && block >= 8) {
                break; // the search above is slow
            }
        }
        if (rays <= 1000) {
            EXPECT_EQ(asked, 16U * rays);
            for (const auto& sample : met) {
                EXPECT_EQ(sample, (std::array<int, 16>{1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1})) << rays;
            }
        }
    }
}

TEST(TileRays, StartWhereTheTexelsRaysStart) {
    const Texels texels = texels_facing_every_way(16);
    const RayPlan plan({}, 0.25F);
    TileRays tile(texels.surface, texels.geometry, plan);
    tile.begin(tile_of(3, 9));
    const RayBlock& block = tile.make(0);
    EXPECT_EQ(block.max_distance, 0.25F);
    for (std::size_t lane = 0; lane < 16; ++lane) {
        const std::size_t texel = lane < 9 ? lane + 3 : 3; // lanes without a texel stay near
        const glm::vec3 origin =
            ray_origin({texels.surface.positions[3 * texel], texels.surface.positions[3 * texel + 1],
                        texels.surface.positions[3 * texel + 2]},
                       texels.geometry.position[texel], texels.geometry.geometric_normal[texel]);
        EXPECT_EQ(glm::vec3(block.origin[0][lane], block.origin[1][lane], block.origin[2][lane]), origin);
        for (std::size_t i = 0; i < RayBlock::strata && lane >= 9; ++i) {
            EXPECT_EQ((block.active[i] >> lane) & 1U, 0U);
        }
    }
}

using Bits = std::vector<std::uint32_t>;

/// All that a texel's rays are, by texel.
std::map<std::uint32_t, Bits> rays_by_texel(const Texels& texels, const Settings& settings,
                                            const std::vector<TexelTile>& tiles) {
    const RayPlan plan(settings, no_limit);
    TileRays rays(texels.surface, texels.geometry, plan);
    std::map<std::uint32_t, Bits> bits;
    for (const TexelTile& tile : tiles) {
        rays.begin(tile);
        for (std::size_t number = 0; number < plan.block_count(); ++number) {
            const RayBlock& block = rays.make(number);
            for (std::uint32_t lane = 0; lane < tile.count; ++lane) {
                Bits& own = bits[tile.texels[lane]];
                for (std::size_t i = 0; i < RayBlock::strata; ++i) {
                    own.push_back((block.active[i] >> lane) & 1U);
                    for (std::size_t axis = 0; axis < 3; ++axis) {
                        own.push_back(std::bit_cast<std::uint32_t>(block.origin[axis][lane]));
                        own.push_back(std::bit_cast<std::uint32_t>(block.direction[i][axis][lane]));
                    }
                }
            }
        }
    }
    return bits;
}

TEST(TileRays, DependNeitherOnTheTileNorOnTheLaneNorOnTheInstructionSet) {
    const Texels texels = texels_facing_every_way(35);
    for (const Sampler sampler : {Sampler::cosine, Sampler::thesis}) {
        Settings settings;
        settings.sampler = sampler;
        settings.rays = 300;
        const auto expected = rays_by_texel(texels, settings, {tile_of(0, 16), tile_of(16, 16), tile_of(32, 3)});
        TexelTile backwards = tile_of(5, 16);
        std::reverse(backwards.texels.begin(), backwards.texels.end());
        std::vector<TexelTile> others{tile_of(0, 5), backwards, tile_of(21, 14)};
        test::for_every_target([&] { EXPECT_EQ(rays_by_texel(texels, settings, others), expected); });
    }
}

} // namespace
} // namespace vkbake
