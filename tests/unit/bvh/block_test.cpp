// Blocks of rays against the same rays asked one by one of the oracle.
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "amount.hpp"
#include "highway_targets.hpp"
#include "unit/bvh/ray_scenes.hpp"

namespace vkbake {
namespace {

void set_origin(RayBlock& block, std::size_t lane, const glm::vec3& origin) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        block.origin[axis][lane] = origin[static_cast<int>(axis)];
    }
}

void set_direction(RayBlock& block, std::size_t stratum, std::size_t lane, const glm::vec3& direction) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        block.direction[stratum][axis][lane] = direction[static_cast<int>(axis)];
    }
    block.active[stratum] = static_cast<RayBlock::LaneBits>(block.active[stratum] | 1U << lane);
}

template<class Direction>
RayBlock make_block(const glm::vec3& place, float spread, test::Random& random, const Direction& direction) {
    RayBlock block;
    for (std::size_t lane = 0; lane < RayBlock::lanes; ++lane) {
        set_origin(block, lane, place + random.point(spread));
        for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
            set_direction(block, stratum, lane, direction(stratum, lane));
        }
    }
    return block;
}

/// What a bake asks: origins beside each other, and each stratum its own narrow cone.
RayBlock coherent_block(test::Random& random) {
    const glm::vec3 axis = random.direction();
    std::array<glm::vec3, RayBlock::strata> cones{};
    for (glm::vec3& cone : cones) {
        cone = axis + random.point(0.3F);
    }
    return make_block(random.point(), 0.01F, random, [&](std::size_t stratum, std::size_t) {
        return glm::normalize(cones[stratum] + random.point(0.05F));
    });
}

RayBlock incoherent_block(test::Random& random) {
    return make_block(random.point(), 1.0F, random, [&](std::size_t, std::size_t) { return random.direction(); });
}

/// Exactly towards corners and points of edges of the triangles.
RayBlock aimed_block(const test::Triangles& triangles, test::Random& random) {
    RayBlock block = incoherent_block(random);
    for (std::size_t lane = 0; lane < RayBlock::lanes; ++lane) {
        const glm::vec3 origin(block.origin[0][lane], block.origin[1][lane], block.origin[2][lane]);
        for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
            const auto [a, b, c] = triangles.corners(random.below(triangles.count()));
            set_direction(block, stratum, lane, (stratum % 2 == 0 ? a : (b + c) * 0.5F) - origin);
        }
    }
    return block;
}

/// Zeros of both signs, denormals, axes, and what is no ray at all; some lanes are not asked.
RayBlock odd_block(test::Random& random) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const std::array<float, 10> parts{0.0F,    -0.0F,    1.0F,     -1.0F,    1e-40F,
                                      -1e-40F, 0x1p-30F, 0x1p-70F, infinity, std::numeric_limits<float>::quiet_NaN()};
    RayBlock block = make_block(glm::vec3(0.0F), 1.0F, random, [&](std::size_t, std::size_t) {
        const float x = parts[random.below(parts.size())];
        const float y = parts[random.below(parts.size())];
        return glm::vec3(x, y, parts[random.below(8)]);
    });
    for (auto& active : block.active) {
        active = static_cast<RayBlock::LaneBits>(random.bits());
    }
    return block;
}

/// What leaves a surface: origins just above one triangle, some of them over its edges, which is ignored; directions
/// with zeros and tangents among them.
RayBlock leaving_block(const test::Triangles& triangles, test::Random& random) {
    const std::size_t triangle = random.below(triangles.count());
    const auto [a, b, c] = triangles.corners(triangle);
    const glm::vec3 across = glm::cross(b - a, c - a);
    const float area = glm::length(across);
    const glm::vec3 normal = area > 0.0F ? across / area : glm::vec3(0, 1, 0);
    const glm::vec3 tangent = area > 0.0F ? glm::normalize(b - a) : glm::vec3(1, 0, 0);
    const glm::vec3 bitangent = glm::cross(normal, tangent);
    RayBlock block = make_block(a, 0.0F, random, [&](std::size_t stratum, std::size_t) {
        const float up = 0.25F * static_cast<float>(1 + stratum % 4);
        const std::array<glm::vec3, 4> sideways{tangent, -tangent, bitangent, -bitangent};
        return glm::normalize(normal * up + sideways[stratum / 4]);
    });
    for (std::size_t lane = 0; lane < RayBlock::lanes; ++lane) {
        const float along = static_cast<float>(random.below(5)) / 4.0F;
        const float rest = (1.0F - along) * static_cast<float>(random.below(5)) / 4.0F;
        set_origin(block, lane, a + along * (b - a) + rest * (c - a) + normal * 0x1p-20F);
        block.ignored_triangle[lane] = static_cast<std::uint32_t>(triangle);
    }
    return block;
}

/// Twelve triangles, fronts inwards.
test::Triangles box(const glm::vec3& low, const glm::vec3& high) {
    std::vector<glm::vec3> positions;
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool upper : {false, true}) {
            const auto corner = [&](int i, int j) {
                glm::vec3 at = low;
                at[axis] = upper ? high[axis] : low[axis];
                at[(axis + 1) % 3] = i != 0 ? high[(axis + 1) % 3] : low[(axis + 1) % 3];
                at[(axis + 2) % 3] = j != 0 ? high[(axis + 2) % 3] : low[(axis + 2) % 3];
                return at;
            };
            const std::array<glm::vec3, 4> quad{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
            const std::array<std::size_t, 6> order =
                upper ? std::array<std::size_t, 6>{0, 2, 1, 0, 3, 2} : std::array<std::size_t, 6>{0, 1, 2, 0, 2, 3};
            for (const std::size_t i : order) {
                positions.push_back(quad[i]);
            }
        }
    }
    return test::make_triangles("box", std::move(positions));
}

std::vector<RayBlock> blocks_of_all_kinds(const test::Triangles& triangles, std::uint64_t seed) {
    test::Random random(seed);
    std::vector<RayBlock> blocks;
    for (int i = 0; i < test::amount(6, 1); ++i) {
        blocks.push_back(coherent_block(random));
        blocks.push_back(incoherent_block(random));
        blocks.push_back(aimed_block(triangles, random));
        blocks.push_back(odd_block(random));
        blocks.push_back(leaving_block(triangles, random));
        blocks.push_back(leaving_block(triangles, random));
        blocks.push_back(coherent_block(random));
        blocks.back().max_distance = 0.3F;
        blocks.push_back(aimed_block(triangles, random));
        blocks.back().max_distance = 1.0F; // the corner's own distance
        blocks.push_back(coherent_block(random));
        for (std::uint32_t& ignored : blocks.back().ignored_triangle) {
            ignored = static_cast<std::uint32_t>(random.below(triangles.count()));
        }
    }
    return blocks;
}

Ray ray_of(const RayBlock& block, std::size_t stratum, std::size_t lane) {
    const auto& [x, y, z] = block.direction[stratum];
    return {{block.origin[0][lane], block.origin[1][lane], block.origin[2][lane]},
            {x[lane], y[lane], z[lane]},
            block.max_distance,
            block.ignored_triangle[lane]};
}

BlockedRays one_by_one(const TriangleAccelerator& accelerator, const RayBlock& block) {
    BlockedRays blocked{};
    for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
        for (unsigned bits = block.active[stratum]; bits != 0; bits &= bits - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
            if (accelerator.occluded(ray_of(block, stratum, lane))) {
                blocked[stratum] = static_cast<RayBlock::LaneBits>(blocked[stratum] | (bits & -bits));
            }
        }
    }
    return blocked;
}

std::vector<test::Triangles> scenes() {
    return {test::soup(2000, 0.1F, 1),
            test::soup(3, 0.9F, 2),
            test::needles(300, 3),
            test::duplicates(100, 4),
            test::sheet(12, 1, 0.25F),
            test::needle_fan(150),
            box(glm::vec3(-1.0F), glm::vec3(1.0F)),
            box({-1.0F, 0.3F, -1.0F}, {1.0F, 0.302F, 1.0F}),
            test::join("sphere in a soup", {test::sphere(4, 0.7F, glm::vec3(0.1F)), test::soup(200, 0.2F, 5)})};
}

TEST(Block, GivesTheOraclesAnswerToEveryRay) {
    for (const test::Triangles& triangles : scenes()) {
        SCOPED_TRACE(triangles.name);
        const TriangleAccelerator oracle = test::accelerate(triangles, Accelerator::brute);
        const TriangleAccelerator hierarchy = test::accelerate(triangles, Accelerator::bvh);
        const TriangleAccelerator clusters = test::accelerate(triangles, Accelerator::clusters);
        BlockScratch scratch = hierarchy.make_scratch();
        BlockScratch none = clusters.make_scratch();
        int met = 0;
        int passed = 0;
        for (const RayBlock& block : blocks_of_all_kinds(triangles, 7)) {
            const BlockedRays expected = one_by_one(oracle, block);
            EXPECT_EQ(hierarchy.blocked(block, scratch), expected);
            EXPECT_EQ(one_by_one(hierarchy, block), expected);
            EXPECT_EQ(clusters.blocked(block, none), expected);
            for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
                met += std::popcount(expected[stratum]);
                passed += std::popcount(static_cast<unsigned>(block.active[stratum] & ~expected[stratum]));
            }
        }
        EXPECT_GT(met, 20);
        EXPECT_GT(passed, 20);
    }
}

TEST(Block, AnswersDoNotDependOnTheInstructionSet) {
    const test::Triangles triangles =
        test::join("", {test::soup(1500, 0.1F, 8), test::sphere(3, 0.7F, glm::vec3(0.0F)), test::needles(50, 9)});
    const TriangleAccelerator accelerator = test::accelerate(triangles, Accelerator::bvh);
    const std::vector<RayBlock> blocks = blocks_of_all_kinds(triangles, 10);
    BlockScratch scratch = accelerator.make_scratch();
    const auto answers = [&] {
        std::vector<BlockedRays> all;
        all.reserve(blocks.size());
        for (const RayBlock& block : blocks) {
            all.push_back(accelerator.blocked(block, scratch));
        }
        return all;
    };
    const auto expected = answers();
    test::for_every_target([&] { EXPECT_EQ(answers(), expected); });
}

TEST(Block, AnIgnoredTriangleIsNeverMet) {
    const test::Triangles one = test::make_triangles("one", {{-1, 0, -1}, {0, 0, 2}, {2, 0, -1}});
    for (const Accelerator kind : {Accelerator::brute, Accelerator::clusters, Accelerator::bvh}) {
        const TriangleAccelerator accelerator = test::accelerate(one, kind);
        Ray ray{{0.1F, -1.0F, 0.1F}, {0.0F, 1.0F, 0.0F}};
        EXPECT_TRUE(accelerator.occluded(ray));
        EXPECT_TRUE(accelerator.nearest(ray));
        ray.ignored_triangle = 0;
        EXPECT_FALSE(accelerator.occluded(ray));
        EXPECT_FALSE(accelerator.nearest(ray));
    }
}

} // namespace
} // namespace vkbake
